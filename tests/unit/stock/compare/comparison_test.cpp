#include "stock/compare/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "stock/compare/dexel_solid.hpp"
#include "stock/compare/field_solid.hpp"
#include "stock/compare/mesh_solid.hpp"
#include "stock/compare/meshes.hpp"
#include "stock/dexel/mill.hpp"
#include "stock/field/field_jobs.hpp"

namespace kerf::stock::compare::test {
namespace {

constexpr Tolerance kTolerance{};

/// What a region of each side is, and how many there are.
std::array<std::uint64_t, 2> counts(const Comparison& comparison) {
  return {comparison.of(Side::gouge).regions, comparison.of(Side::excess).regions};
}

Comparison of_field(const field::HeightField& field, const TriangleMesh& design,
                    unsigned jobs = 1) {
  return compare(FieldSolid(field), MeshSolid(design), kTolerance, jobs);
}
Comparison of_dexels(const dexel::TriDexel& dexels, const TriangleMesh& design, unsigned jobs = 1) {
  return compare(DexelSolid(dexels), MeshSolid(design), kTolerance, jobs);
}

const Bounds kBlock{{0, 0, -6}, {40, 30, 0}};

/// A block faced to this height, by both kinds of stock.
struct Faced {
  explicit Faced(double z) : field(kBlock, 0.4, field::flat(20)), dexels(kBlock, 1) {
    field.at({-15, 5, 5}).to({-15, 5, z});
    dexels.tool(dexel::test::flat(20)).at({-15, 5, 5}).line({-15, 5, z});
    for (const Vec3 to :
         {Vec3{55, 5, z}, Vec3{55, 20, z}, Vec3{-15, 20, z}, Vec3{-15, 30, z}, Vec3{55, 30, z}}) {
      field.to(to);
      dexels.line(to);
    }
    dexels.run();
  }
  field::Job field;
  dexel::test::Mill dexels;
};

TriangleMesh block_to(double z) { return box(kBlock.low, {kBlock.high.x, kBlock.high.y, z}); }

TEST(Comparison, AFaceCutTooDeepIsOneGougeOfItsFormula) {
  Faced part(-1.2);
  for (const Comparison& one :
       {of_field(part.field.field(), block_to(-1)), of_dexels(part.dexels.model, block_to(-1))}) {
    EXPECT_EQ(counts(one), (std::array<std::uint64_t, 2>{1, 0}));
    EXPECT_NEAR(one.of(Side::gouge).max_mm, 0.2, 1e-6);
    EXPECT_NEAR(one.of(Side::gouge).volume_mm3, 240, 1e-3);
    EXPECT_NEAR(one.of(Side::gouge).all_mm3, 240, 1e-3);
    EXPECT_NEAR(one.of(Side::excess).max_mm, 0, 1e-6);
    EXPECT_NEAR(one.of(Side::excess).all_mm3, 0, 1e-3);
    ASSERT_EQ(one.regions.size(), 1U);
    const Region& region = one.regions[0];
    EXPECT_EQ(region.side, Side::gouge);
    EXPECT_NEAR(region.volume_mm3, 240, 1e-3);
    EXPECT_NEAR(region.centre.x, 20, 0.2);
    EXPECT_NEAR(region.centre.y, 15, 0.2);
    EXPECT_NEAR(region.area_mm2, 1200, 40) << "but for what is nearer to a wall than tolerance";
    double shares = 0;
    for (const MotionShare& motion : region.motions) shares += motion.share;
    EXPECT_NEAR(shares, 1, 1e-6) << "all of it was cut";
    // The first lane reaches to Y15, the second over the rest: the third finds nothing.
    ASSERT_EQ(region.motions.size(), 2U);
    EXPECT_NEAR(region.motions[0].share, 0.5, 0.05);
  }
}

TEST(Comparison, AFaceAsDesignedIsRight) {
  Faced part(-1);
  for (const Comparison& one :
       {of_field(part.field.field(), block_to(-1)), of_dexels(part.dexels.model, block_to(-1))}) {
    EXPECT_EQ(counts(one), (std::array<std::uint64_t, 2>{0, 0}));
    EXPECT_LT(one.of(Side::gouge).max_mm, 1e-6);
    EXPECT_LT(one.of(Side::excess).max_mm, 1e-6);
    EXPECT_EQ(one.histogram[20] > 0, true);
    double beside = 0;
    for (std::size_t i = 0; i < one.histogram.size(); ++i) beside += i == 20 ? 0 : one.histogram[i];
    EXPECT_EQ(beside, 0);
  }
}

TEST(Comparison, AFaceLeftTooHighIsAnExcess) {
  Faced part(-0.7);
  for (const Comparison& one :
       {of_field(part.field.field(), block_to(-1)), of_dexels(part.dexels.model, block_to(-1))}) {
    EXPECT_EQ(counts(one), (std::array<std::uint64_t, 2>{0, 1}));
    EXPECT_NEAR(one.of(Side::excess).max_mm, 0.3, 1e-6);
    EXPECT_NEAR(one.of(Side::excess).volume_mm3, 360, 1e-3);
    EXPECT_EQ(one.of(Side::gouge).max_mm < 1e-6, true);
    // All of the face is beyond: 1200 mm² of the part in the last bin.
    EXPECT_NEAR(one.histogram[40], 1200, 100);
  }
}

TEST(Comparison, ToleranceIsOfEachSide) {
  Faced part(-1.2);
  const MeshSolid design(block_to(-1));
  const FieldSolid solid(part.field.field());
  EXPECT_EQ(counts(compare(solid, design, {0.25, 0}, 1))[0], 0U);
  EXPECT_EQ(counts(compare(solid, design, {0.19, 0.05}, 1))[0], 1U);
}

/// A block with a rib along its middle, and ones with square pockets of 6 mm.
TriangleMesh ribbed() {
  return filled_cells({0, 40}, {0, 14, 16, 30}, {-6, -4, 0},
                      [](auto, auto j, auto k) { return k == 0 || j == 1; });
}
TriangleMesh with_pockets(const std::vector<double>& xs, double low) {
  std::vector<double> cuts{0};
  for (const double x : xs) cuts.insert(cuts.end(), {x, x + 6});
  cuts.push_back(40);
  return filled_cells(cuts, {0, 10, 16, 30}, {-6, low, 0},
                      [](auto i, auto j, auto k) { return k == 0 || j != 1 || i % 2 == 0; });
}

TEST(Comparison, ARibThatIsGoneIsAGougeOfItsVolume) {
  Faced part(-4);
  const TriangleMesh design = ribbed();
  for (const Comparison& one :
       {of_field(part.field.field(), design), of_dexels(part.dexels.model, design)}) {
    EXPECT_EQ(counts(one), (std::array<std::uint64_t, 2>{1, 0}));
    EXPECT_NEAR(one.of(Side::gouge).max_mm, 4, 1e-6) << "its top is that far from what is left";
    EXPECT_NEAR(one.of(Side::gouge).volume_mm3, 2.0 * 4 * 40, 0.01);
    ASSERT_EQ(one.regions.size(), 1U);
    EXPECT_FALSE(one.regions[0].motions.empty()) << "who cut the floor under it";
  }
}

TEST(Comparison, AHoleThatNobodyDrilledIsAnExcess) {
  const TriangleMesh design = with_pockets({10}, -4);
  field::Job field(kBlock, 0.2, field::flat(4));
  dexel::test::Mill dexels(kBlock, 0.5);
  for (const Comparison& one : {of_field(field.field(), design), of_dexels(dexels.model, design)}) {
    EXPECT_EQ(counts(one)[0], 0U);
    EXPECT_EQ(counts(one)[1], 1U);
    EXPECT_NEAR(one.of(Side::excess).volume_mm3, 6.0 * 6 * 4, 0.01);
    // Nowhere in it is it more than 3 mm to the top or to the bottom of the block.
    EXPECT_NEAR(one.of(Side::excess).max_mm, 3, 0.3);
    EXPECT_LE(one.of(Side::excess).max_mm, 3.001);
    EXPECT_TRUE(one.regions[0].motions.empty()) << "nobody cut anything";
  }
}

TEST(Comparison, BodiesThatTouchOrOverlapAreOnePart) {
  // The rib as a body of its own, standing on the block or stuck into it: faces within are none.
  for (const double foot : {-4.0, -5.0}) {
    const TriangleMesh design = with(block_to(-4), box({0, 14, foot}, {40, 16, 0}));
    Faced flat(-4);
    const Comparison gone = of_dexels(flat.dexels.model, design);
    EXPECT_EQ(counts(gone), (std::array<std::uint64_t, 2>{1, 0}));
    EXPECT_NEAR(gone.of(Side::gouge).volume_mm3, 2.0 * 4 * 40, 0.01);
    EXPECT_NEAR(gone.of(Side::gouge).max_mm, 4, 1e-6);
  }
}

TEST(Comparison, WhatTwoMotionsSpoiltIsTwoRegionsWithTheirMotions) {
  const TriangleMesh design = with_pockets({4, 24}, -1);
  field::Job field(kBlock, 0.2, field::flat(2));
  dexel::test::Mill dexels(kBlock, 0.25);
  dexels.tool(dexel::test::flat(2));
  for (const auto& [x, z] : {std::pair{4.0, -3.0}, std::pair{24.0, -1.5}}) {
    field.at({x + 1, 11, 5}).to({x + 1, 11, z});
    dexels.at({x + 1, 11, 5}).line({x + 1, 11, z});
    for (const Vec3 to :
         {Vec3{x + 5, 11, z}, Vec3{x + 5, 15, z}, Vec3{x + 1, 15, z}, Vec3{x + 1, 11, z},
          Vec3{x + 3, 11, z}, Vec3{x + 3, 15, z}, Vec3{x + 2, 15, z}, Vec3{x + 2, 11, z},
          Vec3{x + 4, 11, z}, Vec3{x + 4, 15, z}}) {
      field.to(to);
      dexels.line(to);
    }
  }
  dexels.run();
  for (const Comparison& one : {of_field(field.field(), design), of_dexels(dexels.model, design)}) {
    ASSERT_GE(one.regions.size(), 2U);
    const Region& deep = one.regions[0];
    const Region& shallow = one.regions[1];
    EXPECT_EQ(deep.side, Side::gouge);
    EXPECT_EQ(shallow.side, Side::gouge);
    // Corners of radius 1 stay: 4 - pi mm² of each pocket's 36.
    EXPECT_NEAR(deep.volume_mm3, 2 * (36 - (4 - std::numbers::pi)), 0.6);
    EXPECT_NEAR(shallow.volume_mm3, 0.5 * (36 - (4 - std::numbers::pi)), 0.3);
    EXPECT_NEAR(deep.max_mm, 2, 0.02);
    EXPECT_NEAR(shallow.max_mm, 0.5, 0.02);
    // Motions 1 to 11 made the first, the others the second.
    for (const MotionShare& motion : deep.motions) EXPECT_LE(motion.motion, 11U);
    for (const MotionShare& motion : shallow.motions) EXPECT_GT(motion.motion, 11U);
    EXPECT_FALSE(deep.motions.empty() || shallow.motions.empty());
    // What the round tool cannot reach is left in the corners.
    EXPECT_EQ(one.of(Side::excess).regions, 8U);
    EXPECT_NEAR(one.of(Side::excess).max_mm, std::numbers::sqrt2 - 1, 0.2 * std::numbers::sqrt2);
  }
}

TEST(Comparison, ABallGrooveIsRightAgainstItsOwnShape) {
  // A half round groove, its design in steps of a degree: a chord is 0.0005 mm off.
  std::vector<std::array<double, 2>> outline;
  for (int i = 0; i <= 180; ++i) {
    const double angle = std::numbers::pi * i / 180;
    outline.push_back({15 + 4 * std::cos(angle), -4 * std::sin(angle)});
  }
  TriangleMesh groove = moved(prism(outline, -20, 60), [](Vec3 p) { return Vec3{p.z, p.x, p.y}; });
  if (volume_mm3(groove) < 0) groove = turned(groove);
  // As the plate less the groove: overlapping shells cannot say that, so it is compared reversed.
  const Bounds box{{0, 0, -10}, {40, 30, 0}};
  field::Job field(box, 0.2, field::ball(8));
  field.at({-10, 15, -4}).to({50, 15, -4});
  dexel::test::Mill dexels(box, 0.4);
  dexels.tool(dexel::test::ball(8)).at({-10, 15, -4}).line({50, 15, -4}).run();
  // Every end that was cut lies on the groove.
  const MeshSolid design(groove);
  double most = 0;
  std::size_t count = 0;
  const FieldSolid by_columns(field.field());
  const DexelSolid by_dexels(dexels.model);
  for (const Part* part :
       {static_cast<const Part*>(&by_columns), static_cast<const Part*>(&by_dexels)}) {
    for (std::size_t row = 0; row < part->rows(); ++row) {
      std::vector<SurfacePoint> points;
      part->points(row, 1, points);
      Hint hint;
      for (const SurfacePoint& point : points) {
        if (point.motion == 0) continue;
        most = std::max(most, std::fabs(design.near(point.at, hint).distance_mm));
        ++count;
      }
    }
    // And every point of the groove within the block lies on the part.
    std::vector<SurfacePoint> points;
    for (std::size_t row = 0; row < design.rows(); ++row) design.points(row, 0.5, points);
    double off = 0;
    for (const SurfacePoint& point : points) {
      if (point.at.x < 0.5 || point.at.x > 39.5 || point.at.z > -0.5) continue;
      Hint hint;
      off = std::max(off, std::fabs(part->near(point.at, hint).distance_mm));
    }
    EXPECT_LT(off, 0.01);
  }
  EXPECT_GT(count, 1000U);
  EXPECT_LT(most, 0.001);
}

TEST(Comparison, PartsThatAreCutAlikeAreEqualToTheLastBit) {
  Random random(7);
  std::vector<std::pair<Vec3, Vec3>> ways;
  for (int i = 0; i < 30; ++i)
    ways.emplace_back(random.in({0, 0, -4}, {40, 30, 0}), random.in({0, 0, -4}, {40, 30, 0}));
  const auto cut = [&](auto begin, auto end, field::Job& field, dexel::test::Mill& dexels) {
    dexels.tool(dexel::test::ball(5));
    for (auto way = begin; way != end; ++way) {
      field.at(way->first).to(way->second);
      dexels.at(way->first).line(way->second);
    }
    dexels.run();
  };
  field::Job one_field(kBlock, 0.3, field::ball(5));
  field::Job other_field(kBlock, 0.3, field::ball(5));
  dexel::test::Mill one_dexels(kBlock, 0.5);
  dexel::test::Mill other_dexels(kBlock, 0.5);
  cut(ways.begin(), ways.end(), one_field, one_dexels);
  cut(ways.rbegin(), ways.rend(), other_field, other_dexels);
  for (const Comparison& same :
       {compare(FieldSolid(one_field.field()), FieldSolid(other_field.field()), kTolerance, 2),
        compare(DexelSolid(one_dexels.model), DexelSolid(other_dexels.model), kTolerance, 2)}) {
    EXPECT_EQ(counts(same), (std::array<std::uint64_t, 2>{0, 0}));
    for (const Side side : {Side::gouge, Side::excess}) {
      EXPECT_EQ(same.of(side).max_mm, 0);
      EXPECT_EQ(same.of(side).all_mm3, 0);
    }
  }
}

TEST(Comparison, WhatTheOneLacksTheOtherHasTooMuch) {
  Faced low(-2);
  Faced high(-1.5);
  const auto both = [&](const Part& a, const Part& b) {
    const Comparison there = compare(a, b, kTolerance, 1);
    const Comparison back = compare(b, a, kTolerance, 1);
    EXPECT_NEAR(there.of(Side::gouge).all_mm3, 600, 1e-3);
    EXPECT_EQ(there.of(Side::gouge).all_mm3, back.of(Side::excess).all_mm3);
    EXPECT_EQ(there.of(Side::gouge).max_mm, back.of(Side::excess).max_mm);
    EXPECT_NEAR(there.of(Side::gouge).max_mm, 0.5, 1e-6);
    EXPECT_EQ(there.of(Side::excess).all_mm3, 0);
  };
  both(FieldSolid(low.field.field()), FieldSolid(high.field.field()));
  both(DexelSolid(low.dexels.model), DexelSolid(high.dexels.model));
}

TEST(Comparison, ColumnsAndDexelsOfOnePartAreEqualWithinACell) {
  Random random(8);
  field::Job field(kBlock, 0.5, field::ball(6));
  dexel::test::Mill dexels(kBlock, 0.5);
  dexels.tool(dexel::test::ball(6));
  Vec3 at{5, 5, 0};
  field.at(at);
  dexels.at(at);
  for (int i = 0; i < 15; ++i) {
    at = random.in({2, 2, -3}, {38, 28, -1});
    field.to(at);
    dexels.line(at);
  }
  dexels.run();
  const Comparison one =
      compare(FieldSolid(field.field()), DexelSolid(dexels.model), {0.5, 0.5}, 2);
  EXPECT_EQ(counts(one), (std::array<std::uint64_t, 2>{0, 0}));
  const Comparison other =
      compare(DexelSolid(dexels.model), FieldSolid(field.field()), {0.5, 0.5}, 2);
  EXPECT_EQ(counts(other), (std::array<std::uint64_t, 2>{0, 0}));
}

TEST(Comparison, ThreadsChangeNoBit) {
  Faced part(-1.2);
  const TriangleMesh design = with_pockets({4, 24}, -3);
  const auto same = [](const Comparison& a, const Comparison& b) {
    EXPECT_EQ(a.histogram, b.histogram);
    ASSERT_EQ(a.regions.size(), b.regions.size());
    for (std::size_t i = 0; i < a.regions.size(); ++i) {
      EXPECT_EQ(a.regions[i].volume_mm3, b.regions[i].volume_mm3);
      EXPECT_EQ(a.regions[i].area_mm2, b.regions[i].area_mm2);
      EXPECT_EQ(a.regions[i].centre, b.regions[i].centre);
      EXPECT_EQ(a.regions[i].motions, b.regions[i].motions);
    }
  };
  const Comparison field = of_field(part.field.field(), design);
  const Comparison dexels = of_dexels(part.dexels.model, design);
  for (const unsigned jobs : {2U, 7U}) {
    same(field, of_field(part.field.field(), design, jobs));
    same(dexels, of_dexels(part.dexels.model, design, jobs));
  }
}

}  // namespace
}  // namespace kerf::stock::compare::test
