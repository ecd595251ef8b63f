// Sweeps of every body against points and poses: what is in a pose of the tool is cut, what is cut
// is in one.
#include <random>

#include "mill.hpp"
#include "stock/dexel/strokes.hpp"

namespace kerf::stock::dexel::test {
namespace {

constexpr double kBound_mm = 0.002;
constexpr int kPoses = 800;

struct Pose {
  Vec3 tip;
  Vec3 axis;
};

Pose pose_at(const Sweep& sweep, double t) {
  const Vec3 tip = point_at(sweep.way, t);
  const auto* turning = std::get_if<TurningWay>(&sweep.way);
  if (turning == nullptr) return {tip, sweep.axis};
  return {tip, geometry::unit(sweep.axis + t * (turning->to_axis - sweep.axis))};
}

/// In the tool made larger by `by`, or smaller.
bool is_in(const Profile& profile, const Pose& pose, Vec3 p, double by) {
  const Vec3 v = p - pose.tip;
  const double z = dot(v, pose.axis);
  const double r = std::sqrt(std::max(0.0, dot(v, v) - z * z));
  if (z < -by || z > profile.height() + by) return false;
  double widest = 0;
  for (const double dz : {-by, -by / 2, 0.0, by / 2, by}) {
    const double at = std::clamp(z + dz, 0.0, profile.height());
    widest = by > 0 ? std::max(widest, profile.radius_at(at))
                    : (dz == -by ? profile.radius_at(at) : std::min(widest, profile.radius_at(at)));
  }
  return r <= widest + by;
}

bool is_in_any(const Profile& profile, const std::vector<Pose>& poses, Vec3 p, double by) {
  return std::any_of(poses.begin(), poses.end(),
                     [&](const Pose& pose) { return is_in(profile, pose, p, by); });
}

bool has_material(const Tile& tile, std::size_t dexel, double s) {
  return tile.overlap(dexel, static_cast<float>(s - 1e-4), static_cast<float>(s + 1e-4)) > 1e-4;
}

class Against : public testing::TestWithParam<int> {
 protected:
  Against() : random_(static_cast<unsigned>(GetParam())) {}

  double draw(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
  }
  Vec3 place() { return {draw(-7, 7), draw(-6, 6), draw(-5, 4)}; }
  Vec3 direction() {
    if (draw(0, 1) < 0.4) return {0, 0, 1};
    return geometry::unit({draw(-1, 1), draw(-1, 1), draw(-0.3, 1)});
  }
  Body body() {
    switch (GetParam() % 8) {
      case 0: return ball(5, 9);
      case 1: return flat(4, 7);
      case 2: return bull(6, 1.2);
      case 3: return pointed(6, 30, 0.4);
      case 4: return t_slot(7, 1.5, 3);
      case 5: return lollipop(5, 2);
      case 6: return Outline().to(3, 0).to(2, 3).to(2, 8).body();
      default: return Outline().to(0.5, 0).to(3, 2.5, -kQuarter * 0.8).to(3, 8).body();
    }
  }
  Way way() {
    const double choice = draw(0, 1);
    if (choice < 0.5) return StraightWay{place(), place()};
    if (choice < 0.75) {
      const Vec3 e1 = geometry::unit({draw(-1, 1), draw(-1, 1), draw(-1, 1)});
      const Vec3 e2 = geometry::unit(cross(e1, geometry::unit({draw(-1, 1), 1, 0.3})));
      return ArcWay{place(),    {0, 0, draw(-2, 2)}, e1,          e2,
                    draw(1, 4), draw(-1, 1),         draw(-3, 3), draw(-5, 5)};
    }
    return TurningWay{place(), place(), direction()};
  }
  Sweep sweep() {
    Sweep one{way(), direction(), 0, SweepKind::cut, 1};
    if (auto* turning = std::get_if<TurningWay>(&one.way)) {
      turning->to_axis = geometry::unit(one.axis + Vec3{draw(-0.2, 0.2), draw(-0.2, 0.2), 0.05});
    }
    return one;
  }

  std::mt19937 random_;
};
INSTANTIATE_TEST_SUITE_P(Seeds, Against, testing::Range(0, 64));

TEST_P(Against, PosesOfTheToolAtPointsOfTheDexels) {
  TriDexel model(box_shape({{-6, -5, -4}, {6, 5, 4}}), 0.5, 1);
  Body tool = body();
  tool.touch_mm = 0;  // else a neck may lean on material
  (void)model.add_body(tool);
  const std::vector<Sweep> sweeps{sweep()};
  std::vector<Outcome> outcomes(1);
  model.cut(sweeps, outcomes);
  std::vector<Pose> poses;
  for (int i = 0; i <= kPoses; ++i)
    poses.push_back(pose_at(sweeps[0], static_cast<double>(i) / kPoses));
  double step = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const Vec3 turn = poses[i].axis - poses[i - 1].axis;
    const Vec3 way = poses[i].tip - poses[i - 1].tip;
    step = std::max(step, std::sqrt(dot(way, way)) + 16 * std::sqrt(dot(turn, turn)));
  }
  for (int i = 0; i < 400; ++i) {
    const int grid = i % 3;
    const Lattice& lattice = model.lattice(grid);
    const std::size_t number = random_() % model.tiles(grid);
    const Tile& tile = model.tile(grid, number);
    const int column = static_cast<int>(random_() % static_cast<unsigned>(tile.columns()));
    const int row = static_cast<int>(random_() % static_cast<unsigned>(tile.rows()));
    const double s = draw(-lattice.half_s, lattice.half_s) * 0.999;
    const int first_column = static_cast<int>(number) % lattice.tiles_b() * Lattice::kTile;
    const int first_row = static_cast<int>(number) / lattice.tiles_b() * Lattice::kTile;
    const Vec3 p =
        along_axis(grid, s, lattice.b_of(first_column + column), lattice.c_of(first_row + row));
    const bool is_left = has_material(tile, tile.index(column, row), s);
    if (is_left) {
      EXPECT_FALSE(is_in_any(tool.profile, poses, p, -kBound_mm))
          << p.x << ' ' << p.y << ' ' << p.z;
    } else {
      EXPECT_TRUE(is_in_any(tool.profile, poses, p, kBound_mm + 2 * step))
          << p.x << ' ' << p.y << ' ' << p.z;
    }
  }
}

TEST(Strokes, OfAnArcAreWithinTheTolerance) {
  const ArcWay arc{{1, 2, 3}, {0, 0, -4}, {1, 0, 0}, {0, 1, 0}, 5, 1, 0.3, -9};
  std::vector<Stroke> strokes;
  append_strokes(arc, {1, 1, 1}, 0.001, strokes);
  ASSERT_GT(strokes.size(), 100U);
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const double n = static_cast<double>(strokes.size());
    for (const double share : {0.25, 0.5, 0.75}) {
      const Vec3 on = point_at(arc, (static_cast<double>(i) + share) / n) - Vec3{1, 1, 1};
      const Vec3 off = on - (strokes[i].from + share * strokes[i].way);
      EXPECT_LE(std::sqrt(dot(off, off)), 0.001);
    }
  }
}

TEST(Strokes, OfAnArcWithABillionTurnsAreStillFinite) {
  const ArcWay arc{{0, 0, 0}, {0, 0, -4}, {1, 0, 0}, {0, 1, 0}, 5, 0, 0, 1e10};
  std::vector<Stroke> strokes;
  append_strokes(arc, {}, 0.001, strokes);
  EXPECT_LE(strokes.size(), 1U << 20);
}

}  // namespace
}  // namespace kerf::stock::dexel::test
