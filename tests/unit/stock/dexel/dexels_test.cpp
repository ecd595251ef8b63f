// What the model is made of.
#include <random>

#include "mill.hpp"
#include "stock/dexel/octahedral.hpp"
#include "stock/dexel/solid.hpp"

namespace kerf::stock::dexel::test {
namespace {

TEST(Octahedral, KeepsDirectionsWithinADegree) {
  std::mt19937 random(3);
  const auto draw = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; };
  for (int i = 0; i < 20000; ++i) {
    const Vec3 v = geometry::unit({draw(), draw(), draw() + 1e-9});
    EXPECT_GT(dot(direction(octahedral(v)), v), std::cos(pi / 180));
  }
}

TEST(Octahedral, IsExactAlongTheAxes) {
  for (const Vec3 v : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    EXPECT_EQ(direction(octahedral(v)), v);
    EXPECT_EQ(direction(octahedral(-2.0 * v)), -1.0 * v);
  }
}

TEST(Solids, OfAnyProfileHaveItsRadiiWithinTheTolerance) {
  for (const Body& body : {bull(10, 2), lollipop(12, 5), t_slot(16, 4, 7), pointed(6, 30, 0.2),
                           Outline().to(1, 0).to(3, 2.5, -kQuarter * 0.8).to(3, 8).body()}) {
    const std::vector<Solid> solids = solids_of(body.profile, 0.0005);
    for (double z = 0.0137; z < 20; z += 0.0731) {
      double widest = 0;
      for (const Solid& solid : solids) {
        if (solid.low <= z && z <= solid.high) widest = std::max(widest, solid.radius_at(z));
      }
      // Near the foot of a flat arc the radius changes fast: compared across, not along r.
      const double least = std::min(body.profile.radius_at(std::max(0.0, z - 0.0005)),
                                    body.profile.radius_at(z + 0.0005));
      const double most = std::max(body.profile.radius_at(std::max(0.0, z - 0.0005)),
                                   body.profile.radius_at(z + 0.0005));
      EXPECT_GE(widest, least - 0.0006) << z;
      EXPECT_LE(widest, most + 0.0006) << z;
    }
  }
}

TEST(Tile, ReusesWhatListsHaveLeft) {
  Tile tile(8, 8, 10);
  const std::array<DexelEnd, 2> whole{{{-10, {}, 0, 0}, {10, {}, 0, 0}}};
  const auto end = [](float at) { return DexelEnd{at, {}, 0, 7}; };
  std::size_t bytes = 0;
  for (int round = 0; round < 50; ++round) {
    for (std::size_t i = 0; i < tile.count(); ++i) tile.fill(i, whole);
    for (std::size_t i = 0; i < tile.count(); ++i) {
      for (float at = -9; at < 9; at += 0.5F) {
        EXPECT_NEAR(tile.subtract(i, at, at + 0.25F, end, end), 0.25, 1e-6);
      }
      EXPECT_EQ(tile.ends(i).size(), 74U);
      EXPECT_NEAR(tile.overlap(i, -10, 10), 20 - 36 * 0.25, 1e-5);
    }
    if (round == 1) bytes = tile.bytes();
  }
  EXPECT_EQ(tile.bytes(), bytes);
}

TEST(Tile, DropsWhatIsShorterThanItTells) {
  Tile tile(1, 1, 10);
  tile.fill(0, std::array<DexelEnd, 2>{{{0, {}, 0, 0}, {1, {}, 0, 0}}});
  const auto end = [](float at) { return DexelEnd{at, {}, 0, 7}; };
  EXPECT_EQ(tile.subtract(0, 0.999995F, 2, end, end), 0);
  EXPECT_NEAR(tile.subtract(0, 5e-6F, 2, end, end), 1, 1e-9);
  EXPECT_TRUE(tile.ends(0).empty());
}

TEST(Shape, OfATubeHasItsVolumeAndItsNormals) {
  for (const int axis : {0, 1, 2}) {
    Mill mill(round_shape({axis, 1, 2, -6, 4, 5, 2}), 0.1);
    EXPECT_NEAR(mill.model.stock_mm3(), pi * (25 - 4) * 10, 1e-6);
    for (const double grid : mill.model.grids_mm3()) {
      EXPECT_NEAR(grid, mill.model.stock_mm3(), 0.003 * mill.model.stock_mm3());
    }
    EXPECT_EQ(mill.model.left_mm3(), mill.model.stock_mm3());
    const Bounds box = mill.model.extents();
    EXPECT_NEAR(on_axis(box.low, axis), -6, 1e-6);
    EXPECT_NEAR(on_axis(box.high, (axis + 1) % 3), 6, 1e-3);
    EXPECT_NEAR(on_axis(box.low, (axis + 2) % 3), -3, 1e-3);
  }
}

TEST(Shape, CutAwayLeavesNothing) {
  Mill mill(Bounds{{-2, -2, -2}, {2, 2, 2}}, 0.5);
  mill.tool(flat(20)).at({-20, 0, -3}).line({20, 0, -3}).run();
  EXPECT_NEAR(mill.removed(), 64, 1e-4);
  EXPECT_GT(mill.model.extents().low.x, mill.model.extents().high.x);
}

TEST(Ends, RememberTheMotionAndLookAwayFromTheMaterial) {
  Mill mill(Bounds{{-10, -10, -10}, {10, 10, 0}}, 0.5);
  mill.tool(ball(8)).at({-20, 0, -3}).line({20, 0, -3}).run();
  const Tile& tile = mill.model.tile(2, 0);
  const Lattice& lattice = mill.model.lattice(2);
  for (int row = 0; row < tile.rows(); ++row) {
    const double y = lattice.c_of(row);
    const DexelEnd& top = tile.ends(tile.index(20, row)).back();
    const bool is_cut = std::fabs(y) < std::sqrt(4 * 4 - 1);
    EXPECT_EQ(top.motion, is_cut ? 1U : 0U) << y;
    const Vec3 n = is_cut ? Vec3{0, -y / 4, std::sqrt(16 - y * y) / 4} : Vec3{0, 0, 1};
    EXPECT_GT(dot(direction(top.normal), n), std::cos(pi / 180)) << y;
  }
}

}  // namespace
}  // namespace kerf::stock::dexel::test
