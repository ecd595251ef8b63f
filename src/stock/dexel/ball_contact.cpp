#include "stock/dexel/ball_contact.hpp"

#include <algorithm>
#include <cmath>

#include "math/math.hpp"

namespace kerf::stock::dexel {
namespace {

// Half of a cell and a little more, so that no way slips through between two.
constexpr double kHalfCell = 0.51;
// A grid sees a face whose normal has this component along it or more; the others do it better. All
// three see one that looks at them alike.
constexpr double kSquarely = 0.577;

/// Distance of a point from a stretch of the plane.
double distance(double b, double c, double from_b, double from_c, double to_b, double to_c) {
  const double way_b = to_b - from_b;
  const double way_c = to_c - from_c;
  const double square = way_b * way_b + way_c * way_c;
  const double along = (b - from_b) * way_b + (c - from_c) * way_c;
  const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
  return math::hypot(b - from_b - t * way_b, c - from_c - t * way_c);
}

}  // namespace

void BallContact::look_at(const Lattice& lattice, const Tile& tile, int column, int row) {
  Line line{.axis = lattice.axis,
            .half_b = kHalfCell * lattice.cell_b,
            .half_c = kHalfCell * lattice.cell_c};
  for (int j = 0; j < tile.rows(); ++j) {
    line.c = lattice.c_of(row + j);
    for (int i = 0; i < tile.columns(); ++i) {
      line.b = lattice.b_of(column + i);
      if (is_near(line)) look_at(line, tile.ends(tile.index(i, j)));
    }
  }
}

bool BallContact::is_near(const Line& line) const {
  const int b = (line.axis + 1) % 3;
  const int c = (line.axis + 2) % 3;
  const Vec3& from = ball_.way.from;
  const Vec3& to = ball_.way.to;
  return distance(line.b, line.c, on_axis(from, b), on_axis(from, c), on_axis(to, b),
                  on_axis(to, c)) <= ball_.radius_mm + line.half_b + line.half_c;
}

void BallContact::look_at(const Line& line, std::span<const DexelEnd> ends) {
  const double low = on_axis(box_.low, line.axis) - kLeft_mm;
  const double high = on_axis(box_.high, line.axis) + kLeft_mm;
  for (std::size_t i = 0; i < ends.size(); i += 2) {
    const double begin{ends[i].at};
    const double end{ends[i + 1].at};
    if (end < low - line.half_b - line.half_c || begin > high + line.half_b + line.half_c) continue;
    look_at_face(line, ends[i]);
    look_at_face(line, ends[i + 1]);
    const Bounds material{along_axis(line.axis, begin, line.b, line.c),
                          along_axis(line.axis, end, line.b, line.c)};
    if (const auto t = ball_.radius_mm > 0 ? first_touch(ball_, material) : std::nullopt)
      met_at(*t);
  }
}

void BallContact::look_at_face(const Line& line, const DexelEnd& end) {
  const Vec3 normal = direction(end.normal);
  if (std::fabs(on_axis(normal, line.axis)) < kSquarely) return;
  const Vec3 place = along_axis(line.axis, double{end.at}, line.b, line.c);
  const double gap = geometry::dot(ball_.way.from - place, normal) - ball_.radius_mm;
  const double change = geometry::dot(ball_.way.to - ball_.way.from, normal);
  // What is behind the face by more than the whole ball is met by the material itself.
  if (gap < -2 * ball_.radius_mm - kLeft_mm) return;
  double t = 0;
  if (gap >= -kLeft_mm) {
    if (change >= 0 || gap > -change) return;
    t = std::max(0.0, gap / -change);
  }
  const Vec3 foot = point_at(ball_.way, t) - (gap + ball_.radius_mm + t * change) * normal;
  const Vec3 aside = foot - place;
  if (std::fabs(on_axis(aside, (line.axis + 1) % 3)) > line.half_b) return;
  if (std::fabs(on_axis(aside, (line.axis + 2) % 3)) > line.half_c) return;
  met_at(t);
}

}  // namespace kerf::stock::dexel
