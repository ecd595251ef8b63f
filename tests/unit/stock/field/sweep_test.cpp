// Random sweeps against points of the tool, taken one by one, and properties of sweeps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "stock/field/field_jobs.hpp"

namespace kerf::stock::field {
namespace {

using std::numbers::pi;

const Bounds kBox{{-10, -8, -12}, {10, 8, 0}};
constexpr double kCell = 0.5;

class Random {
 public:
  double in(double low, double high) {
    return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
  }
  int below(int n) { return static_cast<int>(in(0, n)); }
  Vec3 place() { return {in(-9, 9), in(-7, 7), in(-8, -0.5)}; }

 private:
  std::mt19937_64 bits_{20240611};
};

/// A form with a concave arc: its edge rises ever less.
Body bell() {
  const double b = std::sqrt(2.0) - 1;
  return {.profile = Profile({{{0, 0}, {1, 0}}, {{1, 0}, {4, 3}, -b}, {{4, 3}, {4, 20}}})};
}
Body tapered() {
  // A ball of 1 mm that goes over into a cone of 10° to the axis.
  const double a = pi / 18;
  const double r = std::cos(a);
  const double z = 1 - std::sin(a);
  const double bulge = std::tan((pi / 2 - a) / 4);
  return {.profile = Profile({{{0, 0}, {r, z}, bulge}, {{r, z}, {r + 6 * std::tan(a), z + 6}}})};
}

std::vector<Body> bodies() {
  return {flat(6), ball(6), bull(6, 1), cone(6, 60, 0.4), cone(5, 118, 0), bell(), tapered()};
}

Way random_way(Random& random) {
  const Vec3 from = random.place();
  const Vec3 centre = from + Vec3{random.in(-4, 4), random.in(-4, 4), 0};
  const double turn = random.in(0.2, 13) * (random.below(2) == 0 ? 1 : -1);
  switch (random.below(8)) {
    case 0: return StraightWay{from, {from.x, from.y, random.in(-8, 2)}};
    case 1: return StraightWay{from, {random.in(-9, 9), random.in(-7, 7), from.z}};
    case 2: return StraightWay{from, from + Vec3{random.in(-0.3, 0.3), 0.1, random.in(-0.1, 0.1)}};
    case 3: return around(centre, from, turn);
    case 4: return around(centre, from, turn, random.in(-2, 2));
    case 5: return around(centre, from, turn, random.in(-1, 1), random.in(-1, 2));
    case 6:
      return ArcWay{from, {}, {1, 0, 0}, {0, 0, 1}, random.in(0.5, 3), 0, random.in(0, 6), turn};
    default: return StraightWay{from, random.place()};
  }
}

/// f(s) by looking for the lowest height at which the outline is that far out.
double lowest_of(const Profile& profile, double s) {
  double low = 0;
  double high = profile.height();
  if (profile.widest() < s) return 1e9;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    double reach = 0;
    for (const ProfileEdge& edge : profile.edges()) {
      if (edge.from.z > middle) break;
      reach = std::max(reach, edge.to.z <= middle ? std::max(edge.from.r, edge.to.r) : 0);
    }
    (std::max(reach, profile.radius_at(middle)) >= s ? high : low) = middle;
  }
  return high;
}

class Table {
 public:
  explicit Table(const Profile& profile) : reach_(profile.widest()) {
    for (int i = 0; i <= kSteps; ++i) values_.push_back(lowest_of(profile, i * reach_ / kSteps));
  }
  /// So many steps are this far, at least.
  [[nodiscard]] int steps(double mm) const {
    return static_cast<int>(std::ceil(mm / reach_ * kSteps)) + 2;
  }
  /// f some steps farther out.
  [[nodiscard]] double at(double s, int steps) const {
    const int i = static_cast<int>(std::ceil(s / reach_ * kSteps)) + steps;
    if (i > kSteps) return 1e9;
    return values_[static_cast<std::size_t>(std::max(0, i))];
  }

 private:
  static constexpr int kSteps = 20000;
  double reach_;
  std::vector<double> values_;
};

/// Over a column no point of the tool may be left below what the field holds, and for what is gone
/// there must be one.
void expect_swept(const HeightField& field, const Table& tool, const Way& way) {
  constexpr int kPlaces = 1500;
  std::vector<Vec3> places;
  for (int k = 0; k <= kPlaces; ++k) places.push_back(point_at(way, 1.0 * k / kPlaces));
  const double step = length(way) / kPlaces;
  const Grid& grid = field.columns().grid();
  const double e = sweep_error_mm(grid);
  const int outwards = tool.steps(e);
  const int inwards = -tool.steps(e + step / 2);
  for (int j = 0; j < grid.ny; ++j) {
    for (int i = 0; i < grid.nx; ++i) {
      double above = 1e9;  // not below the true surface: at the places alone, a little farther out
      double below = 1e9;  // not above it: between the places, a little farther in
      for (const Vec3& at : places) {
        const double s = std::hypot(grid.x(i) - at.x, grid.y(j) - at.y);
        above = std::min(above, at.z + tool.at(s, outwards));
        below = std::min(below, at.z - step / 2 + tool.at(s, inwards));
      }
      const double z = kBox.low.z + static_cast<double>(field.columns().height(i, j));
      ASSERT_LE(z, std::clamp(above, kBox.low.z, kBox.high.z) + e) << i << ' ' << j;
      ASSERT_GE(z, std::clamp(below, kBox.low.z, kBox.high.z) - e) << i << ' ' << j;
    }
  }
}

TEST(Sweeps, LeaveWhatPointsOfTheToolLeave) {
  Random random;
  const std::vector<Body> tools = bodies();
  for (std::size_t tool = 0; tool < tools.size(); ++tool) {
    const Body& body = tools[tool];
    const Table table(body.profile);
    for (int n = 0; n < 10; ++n) {
      HeightField field(grid_of(kBox, kCell), 1);
      Sweep sweep{.way = random_way(random), .body = field.add_body(body), .motion = 1};
      Outcome outcome;
      ASSERT_TRUE(field.can_cut(sweep));
      field.cut({&sweep, 1}, {&outcome, 1});
      expect_swept(field, table, sweep.way);
      ASSERT_NEAR(outcome.removed.value(), field.stock_mm3() - field.left_mm3(), 1e-6);
      if (testing::Test::HasFatalFailure()) {
        FAIL() << "tool " << tool << ", way " << sweep.way.index() << ", sweep " << n;
      }
    }
  }
}

void cut(HeightField& field, const Sweep& sweep) {
  Outcome outcome;
  field.cut({&sweep, 1}, {&outcome, 1});
}

/// Steepest step from a column to its neighbours, mm per mm.
double steepness(const HeightField& field, int i, int j) {
  const Columns& columns = field.columns();
  double steepest = 0;
  for (const auto& [di, dj] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
    const int i2 = std::clamp(i + di, 0, columns.grid().nx - 1);
    const int j2 = std::clamp(j + dj, 0, columns.grid().ny - 1);
    const double step = std::abs(static_cast<double>(columns.height(i, j)) -
                                 static_cast<double>(columns.height(i2, j2)));
    steepest = std::max(steepest, step / columns.grid().cell_x());
  }
  return steepest;
}

/// How many columns are this far apart, down or across.
int columns_apart(const HeightField& a, const HeightField& b, double within) {
  int apart = 0;
  const Grid& grid = a.columns().grid();
  for (int j = 0; j < grid.ny; ++j) {
    for (int i = 0; i < grid.nx; ++i) {
      const auto here = static_cast<double>(a.columns().height(i, j));
      const auto there = static_cast<double>(b.columns().height(i, j));
      apart += std::abs(here - there) > within * (1 + 2 * steepness(a, i, j)) ? 1 : 0;
    }
  }
  return apart;
}

Way part_of(const Way& way, double from, double to) {
  if (const auto* arc = std::get_if<ArcWay>(&way)) return part(*arc, from, to);
  return part(std::get<StraightWay>(way), from, to);
}

TEST(Sweeps, WholeAreTheSameAsInTwoParts) {
  Random random;
  for (const Body& body : {flat(6), bull(6, 1), cone(5, 118, 0), bell()}) {
    for (int n = 0; n < 40; ++n) {
      const Way way = random_way(random);
      HeightField whole(grid_of(kBox, kCell), 1);
      HeightField parts(grid_of(kBox, kCell), 1);
      cut(whole, {.way = way, .body = whole.add_body(body)});
      const double at = random.in(0.1, 0.9);
      const BodyId tool = parts.add_body(body);
      cut(parts, {.way = part_of(way, 0, at), .body = tool});
      cut(parts, {.way = part_of(way, at, 1), .body = tool});
      // Beside a wall that moves by the error a column may be in or out: at most a few are.
      const double within = 2 * sweep_error_mm(whole.columns().grid());
      EXPECT_LE(columns_apart(whole, parts, within), 2) << way.index();
    }
  }
}

TEST(Sweeps, MadeTwiceRemoveNothingTheSecondTime) {
  Random random;
  for (const Body& body : bodies()) {
    HeightField field(grid_of(kBox, kCell), 1);
    const BodyId tool = field.add_body(body);
    for (int n = 0; n < 20; ++n) {
      const Sweep sweep{.way = random_way(random), .body = tool, .motion = 7};
      cut(field, sweep);
      Outcome again;
      field.cut({&sweep, 1}, {&again, 1});
      EXPECT_EQ(again.removed, Exact());
    }
  }
}

Vec3 mirrored(Vec3 v) { return {-v.x, v.y, v.z}; }
Vec3 turned(Vec3 v) { return {-v.y, v.x, v.z}; }

template <class Map>
Way mapped(const Way& way, const Map& map) {
  if (const auto* line = std::get_if<StraightWay>(&way)) {
    return StraightWay{map(line->from), map(line->to)};
  }
  ArcWay arc = std::get<ArcWay>(way);
  arc.centre = map(arc.centre);
  arc.rise = map(arc.rise);
  arc.e1 = map(arc.e1);
  arc.e2 = map(arc.e2);
  return arc;
}

TEST(Sweeps, MirroredAndTurnedLeaveExactlyTheMirroredAndTurned) {
  Random random;
  const Bounds box{{-10, -10, -12}, {10, 10, 0}};
  for (const Body& body : bodies()) {
    HeightField here(grid_of(box, 0.3), 1);
    HeightField there(grid_of(box, 0.3), 1);
    HeightField round(grid_of(box, 0.3), 1);
    const BodyId tool = here.add_body(body);
    ASSERT_EQ(there.add_body(body), tool);
    ASSERT_EQ(round.add_body(body), tool);
    for (int n = 0; n < 20; ++n) {
      const Way way = random_way(random);
      cut(here, {.way = way, .body = tool});
      cut(there, {.way = mapped(way, mirrored), .body = tool});
      cut(round, {.way = mapped(way, turned), .body = tool});
    }
    const int n = here.columns().grid().nx;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        ASSERT_EQ(here.columns().height(i, j), there.columns().height(n - 1 - i, j));
        ASSERT_EQ(here.columns().height(i, j), round.columns().height(n - 1 - j, i));
      }
    }
  }
}

TEST(Sweeps, ThatAreDisjointMayBeMadeInAnyOrder) {
  HeightField one(grid_of(kBox, 0.1), 1);
  HeightField other(grid_of(kBox, 0.1), 1);
  const BodyId tool = one.add_body(ball(3));
  ASSERT_EQ(other.add_body(ball(3)), tool);
  std::vector<Sweep> sweeps;
  for (int i = 0; i < 8; ++i) {
    const double x = -8.5 + 2.2 * i + 0.5;
    sweeps.push_back({.way = StraightWay{{x, -6, -0.2}, {x, 6, -0.1 * i}}, .body = tool});
    sweeps.back().motion = static_cast<std::uint32_t>(i + 1);
  }
  for (const Sweep& sweep : sweeps) cut(one, sweep);
  std::reverse(sweeps.begin(), sweeps.end());
  for (const Sweep& sweep : sweeps) cut(other, sweep);
  EXPECT_EQ(columns_apart(one, other, 0), 0);
}

}  // namespace
}  // namespace kerf::stock::field
