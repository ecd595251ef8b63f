#include "features/internal/patterns.hpp"

#include <algorithm>
#include <cmath>

#include "features/path/tolerance.hpp"
#include "geometry/angle.hpp"

namespace kerf::features {
namespace {

using Points = std::vector<Vec2>;

constexpr double kRoundedPoint_mm = 0.01;  // programs write points of circles with three digits
constexpr std::size_t kLeastOnCircle = 4;

bool are_alike(const HoleStep& a, const HoleStep& b) {
  return a.how == b.how && a.tool == b.tool && a.cycle == b.cycle &&
         std::fabs(a.diameter - b.diameter) <= kSamePoint_mm &&
         std::fabs(a.bottom - b.bottom) <= kSamePoint_mm;
}

bool are_alike(const Hole& a, const Hole& b) {
  return a.setup == b.setup && a.steps.front().operation == b.steps.front().operation &&
         std::equal(a.steps.begin(), a.steps.end(), b.steps.begin(), b.steps.end(),
                    [](const HoleStep& x, const HoleStep& y) { return are_alike(x, y); });
}

bool are_near(double a, double b) { return std::fabs(a - b) <= kRoundedPoint_mm; }

/// The middle of the circle through three points; nothing: they lie on a line.
std::optional<Vec2> centre_of(Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 u = b - a;
  const Vec2 v = c - a;
  const double twice = 2 * geometry::cross(u, v);
  if (std::fabs(twice) < kRoundedPoint_mm) return std::nullopt;
  const double uu = geometry::dot(u, u);
  const double vv = geometry::dot(v, v);
  return a + (1 / twice) * Vec2{uu * v.v - vv * u.v, vv * u.u - uu * v.u};
}

double angle_deg(Vec2 arm) { return geometry::degrees(math::atan2(arm.v, arm.u)); }

// By points far apart, so that what was rounded counts least.
std::optional<Vec2> centre_of(const Points& points) {
  const std::size_t n = points.size();
  return centre_of(points[0], points[n / 3], points[2 * n / 3]);
}

bool are_equally_spaced(const Points& points, Vec2 centre, double radius) {
  std::vector<double> angles;
  for (const Vec2 point : points) angles.push_back(angle_deg(point - centre));
  std::sort(angles.begin(), angles.end());
  std::vector<double> steps;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double next = i + 1 < angles.size() ? angles[i + 1] : angles.front() + 360;
    steps.push_back(next - angles[i]);
  }
  // Of an arc one step is the way round from its end to its begin.
  std::sort(steps.begin(), steps.end());
  const double most_deg = geometry::degrees(2 * kRoundedPoint_mm / radius);
  return steps[steps.size() - 2] - steps.front() <= most_deg && steps.front() > most_deg;
}

bool take_circle(const Points& points, Pattern& pattern) {
  if (points.size() < kLeastOnCircle) return false;
  const auto centre = centre_of(points);
  if (!centre) return false;
  double radius = 0;
  for (const Vec2 point : points)
    radius += geometry::length(point - *centre) / static_cast<double>(points.size());
  const bool are_on_it = std::all_of(points.begin(), points.end(), [&](Vec2 point) {
    return are_near(geometry::length(point - *centre), radius);
  });
  if (!are_on_it || !are_equally_spaced(points, *centre, radius)) return false;
  pattern.kind = Pattern::Kind::circle;
  pattern.centre = *centre;
  pattern.radius = radius;
  pattern.start_deg = angle_deg(points.front() - *centre);
  if (*pattern.start_deg < 0) *pattern.start_deg += 360;
  return true;
}

/// The different values, in order; nothing: they are not equally spaced.
std::optional<std::vector<double>> spaced(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto end = std::unique(values.begin(), values.end(), are_near);
  values.erase(end, values.end());
  for (std::size_t i = 2; i < values.size(); ++i) {
    if (!are_near(values[i] - values[i - 1], values[1] - values[0])) return std::nullopt;
  }
  return values;
}

struct Lattice {
  Vec2 along{};
  std::vector<double> columns{};
  std::vector<double> rows{};
};

// Along the way from the first to the second, and across it.
std::optional<Lattice> lattice_of(const Points& points) {
  const Vec2 way = points[1] - points[0];
  if (geometry::length(way) < kRoundedPoint_mm) return std::nullopt;
  Lattice lattice{.along = geometry::unit(way)};
  std::vector<double> u;
  std::vector<double> v;
  for (const Vec2 point : points) {
    u.push_back(geometry::dot(point - points[0], lattice.along));
    v.push_back(geometry::cross(lattice.along, point - points[0]));
  }
  const auto columns = spaced(u);
  const auto rows = spaced(v);
  if (!columns || !rows) return std::nullopt;
  lattice.columns = *columns;
  lattice.rows = *rows;
  return lattice;
}

bool take_lattice(const Points& points, Pattern& pattern) {
  const auto lattice = lattice_of(points);
  if (!lattice || lattice->columns.size() * lattice->rows.size() != points.size()) return false;
  pattern.pitch = lattice->columns[1] - lattice->columns[0];
  pattern.angle_deg = angle_deg(lattice->along);
  pattern.kind = Pattern::Kind::line;
  if (lattice->rows.size() == 1) return true;
  pattern.kind = Pattern::Kind::grid;
  pattern.second_pitch = lattice->rows[1] - lattice->rows[0];
  return true;
}

Pattern pattern_of(const Tree& tree, std::vector<std::size_t> holes) {
  Pattern pattern;
  Points points;
  for (const std::size_t hole : holes) points.push_back(tree.holes[hole].at);
  pattern.holes = std::move(holes);
  if (!take_circle(points, pattern)) static_cast<void>(take_lattice(points, pattern));
  return pattern;
}

}  // namespace

void find_patterns(Tree& tree) {
  for (std::size_t begin = 0; begin < tree.holes.size();) {
    std::size_t end = begin + 1;
    while (end < tree.holes.size() && are_alike(tree.holes[begin], tree.holes[end])) ++end;
    if (end - begin >= 2) {
      std::vector<std::size_t> holes;
      for (std::size_t i = begin; i < end; ++i) holes.push_back(i);
      for (const std::size_t hole : holes) tree.holes[hole].pattern = tree.patterns.size();
      tree.patterns.push_back(pattern_of(tree, std::move(holes)));
    }
    begin = end;
  }
}

}  // namespace kerf::features
