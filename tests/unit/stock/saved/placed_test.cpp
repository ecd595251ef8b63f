// A part that is clamped anew by quarters keeps its cells; the oracle is the same job, turned.
#include <gtest/gtest.h>

#include <cmath>

#include "parts.hpp"
#include "stock/dexel/tri_dexel.hpp"
#include "stock/field/height_field.hpp"
#include "stock/saved/saved_dexels.hpp"
#include "stock/saved/saved_field.hpp"
#include "stock/saved/saved_turned.hpp"
#include "stock/sheet/sheet.hpp"
#include "stock/turned/turned_job.hpp"

namespace kerf::stock::saved::test {
namespace {

const Bounds kBox{{-10.5, -7.25, -6}, {11, 8.5, 2}};

std::shared_ptr<const SavedPart> dexels_of(double cell) {
  dexel::TriDexel model(dexel::box_shape(kBox), cell, 1);
  EXPECT_EQ(model.add_body(mill(5)), 0U);
  cut_all(model, level_sweeps(1, 30));
  return part_of(file_of({.zero = "G54", .volume_mm3 = model.left_mm3()}, model)).part;
}

std::shared_ptr<const SavedPart> field_of(double cell) {
  field::HeightField model(field::grid_of(kBox, cell), 1);
  EXPECT_EQ(model.add_body(mill(5)), 0U);
  cut_all(model, level_sweeps(1, 30));
  return part_of(file_of({.zero = "G54", .volume_mm3 = model.left_mm3()}, model)).part;
}

Placing turn(double a, double b, double c) { return Placing({{}, {a, b, c}}); }

const dexel::TriDexel::State& state_of(const SavedPart& part) {
  return dynamic_cast<const SavedDexels&>(part).state();
}

/// Where material begins and ends, without what its faces look to.
std::vector<float> places_of(const SavedPart& part) {
  std::vector<float> places;
  for (const auto& tiles : state_of(part).tiles) {
    for (const auto& tile : tiles) {
      for (const dexel::DexelEnd& end : tile.ends) places.push_back(end.at);
    }
  }
  return places;
}

TEST(PlacedPart, ATurnAndItsOppositeLeaveEveryDexelWhereItWas) {
  const auto part = dexels_of(0.4);
  const std::vector<float> were = places_of(*part);
  for (const double degrees : {90.0, 180.0, 270.0}) {
    for (const int axis : {0, 1, 2}) {
      const Vec3 by{axis == 0 ? degrees : 0, axis == 1 ? degrees : 0, axis == 2 ? degrees : 0};
      const auto there = part->placed(turn(by.x, by.y, by.z));
      const auto back = there->placed(turn(-by.x, -by.y, -by.z));
      EXPECT_EQ(back->box(), part->box());
      EXPECT_EQ(state_of(*back).cells, state_of(*part).cells);
      EXPECT_EQ(places_of(*back), were) << axis << " by " << degrees;
      EXPECT_EQ(there->volume_mm3(), part->volume_mm3());
    }
  }
}

/// Sweeps of a tool that stands along an axis other than Z.
std::vector<Sweep> turned_sweeps(std::vector<Sweep> sweeps, const Placing& placing) {
  for (Sweep& sweep : sweeps) {
    const auto& way = std::get<StraightWay>(sweep.way);
    sweep.way = StraightWay{placing(way.from), placing(way.to)};
    sweep.axis = placing.turned(sweep.axis);
  }
  return sweeps;
}

TEST(PlacedPart, TurnedDexelsAreThoseOfTheTurnedJob) {
  const auto part = dexels_of(0.4);
  for (const Vec3 by :
       {Vec3{90, 0, 0}, Vec3{0, 90, 0}, Vec3{0, 0, 90}, Vec3{180, 0, 0}, Vec3{90, 0, 270}}) {
    const Placing placing = turn(by.x, by.y, by.z);
    const auto turned = part->placed(placing);
    dexel::TriDexel model(dexel::box_shape(turned->box()), 0.4, 1);
    ASSERT_EQ(model.cells(), state_of(*turned).cells);
    ASSERT_EQ(model.add_body(mill(5)), 0U);
    cut_all(model, turned_sweeps(level_sweeps(1, 30), placing));
    const auto wanted = part_of(file_of({.zero = "G54", .volume_mm3 = 1}, model)).part;
    const std::vector<float> is = places_of(*turned);
    const std::vector<float> should = places_of(*wanted);
    ASSERT_EQ(is.size(), should.size()) << by.x << " " << by.y << " " << by.z;
    for (std::size_t i = 0; i < is.size(); ++i) ASSERT_NEAR(is[i], should[i], 2e-6) << i;
  }
}

TEST(PlacedPart, AFieldStaysOneAboutZAndUpsideDown) {
  const auto part = field_of(0.4);
  const auto& was = dynamic_cast<const SavedField&>(*part).state();
  const auto quarter = part->placed(turn(0, 0, 90));
  const auto& is = dynamic_cast<const SavedField&>(*quarter).state();
  ASSERT_EQ(is.grid.nx, was.grid.ny);
  for (int j = 0; j < was.grid.ny; ++j) {
    for (int i = 0; i < was.grid.nx; ++i) {
      // (x, y) comes to (-y, x).
      const auto from = static_cast<std::size_t>(j * was.grid.nx + i);
      const auto to = static_cast<std::size_t>(i * is.grid.nx + (was.grid.ny - 1 - j));
      ASSERT_EQ(is.heights[to], was.heights[from]);
    }
  }
  const auto over = part->placed(turn(180, 0, 0));
  EXPECT_EQ(over->kind(), SavedPart::Kind::field);
  EXPECT_EQ(over->box(), (Bounds{{-10.5, -8.5, -2}, {11, 7.25, 6}}));
  EXPECT_NEAR(over->model(1)->left_mm3(), part->model(1)->left_mm3(), 1e-3);
  const auto& again = dynamic_cast<const SavedField&>(*over->placed(turn(-180, 0, 0))).state();
  for (std::size_t i = 0; i < was.heights.size(); ++i)
    ASSERT_NEAR(again.heights[i], was.heights[i], 1e-6);
}

TEST(PlacedPart, AFieldOnItsSideIsItsColumnsAsDexels) {
  const auto part = field_of(0.5);
  const auto side = part->placed(turn(90, 0, 0));  // Z comes to -Y, Y to Z
  ASSERT_EQ(side->kind(), SavedPart::Kind::dexels);
  EXPECT_EQ(side->volume_mm3(), part->volume_mm3());
  const auto model = side->model(1);
  const auto grids = dynamic_cast<const dexel::TriDexel&>(*model).grids_mm3();
  EXPECT_NEAR(grids[1], part->model(1)->left_mm3(), 1e-3);  // the columns, exactly
  EXPECT_NEAR(grids[0], grids[1], 0.02 * grids[1]);
  EXPECT_NEAR(grids[2], grids[1], 0.02 * grids[1]);
}

TEST(PlacedPart, DexelsOfAFieldHaveItsVolume) {
  const auto part = field_of(0.4);
  const auto dexels = part->dexels(1);
  const auto grids = dynamic_cast<const dexel::TriDexel&>(*dexels).grids_mm3();
  EXPECT_NEAR(grids[2], part->model(1)->left_mm3(), 1e-3);
  EXPECT_EQ(dexels->left_mm3(), part->volume_mm3());
}

TEST(PlacedPart, OtherAnglesAskForTheSolid) {
  for (const auto& part : {dexels_of(0.5), field_of(0.5)}) {
    EXPECT_EQ(part->placed(turn(0, 0, 30)), nullptr);
    const MeshShape solid = part->solid();
    EXPECT_EQ(solid.solid->volume_mm3, part->volume_mm3());
    EXPECT_NEAR(mesh::volume_mm3(solid.solid->mesh), part->volume_mm3(), 0.02 * part->volume_mm3());
    const Workpiece placed_part = placed(SavedShape{part}, {{}, {0, 0, 30}});
    EXPECT_TRUE(std::holds_alternative<MeshShape>(placed_part));
    EXPECT_EQ(volume(placed_part), part->volume_mm3());
  }
}

TEST(PlacedPart, ATurnedPartIsTurnedRoundAndMovedAlongItsAxis) {
  turned::Job job(50, -80, 0);
  job.with(turned::turning(0.8)).at(60, 2).rapid(40, 2).to(40, -60).to(52, -66);
  const auto part =
      part_of(file_of({.zero = "G54", .volume_mm3 = job.part().left_mm3()}, job.part())).part;
  const auto round = part->placed(Placing({{0, 0, -80}, {180, 0, 0}}));
  ASSERT_TRUE(round);
  EXPECT_NEAR(round->box().low.z, -80, 1e-12);
  EXPECT_NEAR(round->box().high.z, 0, 1e-12);
  const auto& region = dynamic_cast<const SavedTurned&>(*round).region();
  EXPECT_NEAR(contour::area(region), contour::area(job.part().region()), 1e-9);
  EXPECT_NEAR(round->model(1)->left_mm3(), part->volume_mm3(), 1e-8 * part->volume_mm3());
  // What was cut from Z0 to Z-60 lies from Z-80 to Z-20 now.
  EXPECT_EQ(contour::side_of(region, {-70, 22}, 1e-9), contour::Side::outside);
  EXPECT_EQ(contour::side_of(region, {-5, 22}, 1e-9), contour::Side::inside);
  EXPECT_EQ(part->placed(Placing({{0, 0, 0}, {90, 0, 0}})), nullptr);
  EXPECT_EQ(part->placed(Placing({{1, 0, 0}, {}})), nullptr);
  EXPECT_NE(part->placed(Placing({{}, {0, 0, 33}})), nullptr);
}

TEST(PlacedPart, ASheetIsTurnedInItsPlane) {
  const sheet::Grid grid = sheet::grid_of({{-10, -5}, {31, 30}}, 0.1);
  sheet::Sheet cut(grid, {.kerf_mm = 0.4});
  const std::vector<sheet::Trace> ways{sheet::straight({0, 0}, {20, 3}),
                                       sheet::round({5, 5}, 4, 0, 5)};
  cut.cut(ways);
  const std::vector<SheetCut> cuts{{ways[0], 0.4}, {ways[1], 0.4}};
  const auto part =
      part_of(file_of({.zero = "G54", .volume_mm3 = 7}, SheetPart{cut, cuts, 1})).part;
  for (const double degrees : {90.0, 180.0, 270.0}) {
    const auto there = part->placed(Placing({{3, 4, 0}, {0, 0, degrees}}));
    ASSERT_TRUE(there);
    const auto& turned = dynamic_cast<const SavedSheet&>(*there);
    sheet::Sheet found(turned.state().grid, {.kerf_mm = 0.4});
    ASSERT_TRUE(turned.restore(found));
    EXPECT_EQ(found.cut_mm2() / found.grid().cell_mm2(), cut.cut_mm2() / grid.cell_mm2());
    // The ways, cut anew where they lie now, go over the same cells.
    sheet::Sheet wanted(turned.state().grid, {.kerf_mm = 0.4});
    std::vector<sheet::Trace> turned_ways;
    for (const SheetCut& each : turned.state().cuts) turned_ways.push_back(each.way);
    wanted.cut(turned_ways);
    for (std::size_t tile = 0; tile < wanted.grid().tiles(); ++tile) {
      ASSERT_EQ(wanted.coverage(tile) == nullptr, found.coverage(tile) == nullptr) << tile;
      if (wanted.coverage(tile) == nullptr) continue;
      for (std::size_t i = 0; i < sheet::kTileCells; ++i)
        ASSERT_NEAR((*wanted.coverage(tile))[i], (*found.coverage(tile))[i], 1) << tile << " " << i;
    }
  }
  EXPECT_EQ(part->placed(turn(180, 0, 0)), nullptr);
  EXPECT_EQ(part->placed(Placing({{0, 0, 1}, {}})), nullptr);
  EXPECT_NEAR(mesh::volume_mm3(part->solid().solid->mesh), (41 * 35 - cut.cut_mm2()), 1);
}

}  // namespace
}  // namespace kerf::stock::saved::test
