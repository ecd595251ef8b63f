#include "stock/compare/plate_solid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/math.hpp"

namespace kerf::stock::compare {
namespace {

constexpr std::size_t kWallsInRow = 256;
constexpr double kWallLayers = 4;  // at which walls have points

Bounds plate_box(const contour::Box& box, double low_z, double high_z) {
  if (box.is_empty()) return {{0, 0, low_z}, {0, 0, high_z}};
  return {{box.low.u, box.low.v, low_z}, {box.high.u, box.high.v, high_z}};
}

}  // namespace

PlateSolid::PlateSolid(const contour::Region& region, const Bounds& sheet)
    : outline_(region, Outline::OnAxis::is_surface),
      bounds_(plate_box(outline_.box(), sheet.low.z, sheet.high.z)),
      walls_(outline_.samples(kSample_mm)),
      lines_(sheet) {}

// The walls or the faces, whichever is nearer; from outside over an edge both.
Near PlateSolid::near(Vec3 place, Hint& hint) const {
  Near wall = outline_.near({place.x, place.y}, hint);
  const double over = std::max(bounds_.low.z - place.z, place.z - bounds_.high.z);
  if (!std::isfinite(wall.distance_mm)) return wall;
  const bool is_face = over > wall.distance_mm;
  const double away = math::hypot(std::max(0.0, over), std::max(0.0, wall.distance_mm));
  wall.distance_mm = away > 0 ? away : std::max(over, wall.distance_mm);
  if (is_face) wall.motion = 0;
  return wall;
}

std::size_t PlateSolid::wall_rows() const {
  return (walls_.size() + kWallsInRow - 1) / kWallsInRow;
}

std::size_t PlateSolid::rows() const { return wall_rows() + lines_.count(); }

void PlateSolid::add_wall(const Outline::Sample& sample, std::vector<SurfacePoint>& out) const {
  const double height = bounds_.high.z - bounds_.low.z;
  for (double layer = 0.5; layer < kWallLayers; ++layer) {
    out.push_back({{sample.at.u, sample.at.v, bounds_.low.z + layer / kWallLayers * height},
                   {sample.normal.u, sample.normal.v, 0},
                   sample.mm * height / kWallLayers,
                   sample.motion});
  }
}

void PlateSolid::row(std::size_t number, Row& row) const {
  row.clear();
  if (number >= wall_rows())
    return lines_.add(number - wall_rows(), *this, {false, false, true}, row);
  const std::size_t end = std::min(walls_.size(), (number + 1) * kWallsInRow);
  for (std::size_t i = number * kWallsInRow; i < end; ++i) add_wall(walls_[i], row.points);
}

void PlateSolid::inside(int axis, double b, double c, std::vector<Stretch>& out) const {
  if (axis == 2) {
    if (outline_.holds({b, c})) out.push_back({bounds_.low.z, bounds_.high.z});
    return;
  }
  const double z = axis == 0 ? c : b;
  if (z < bounds_.low.z || z > bounds_.high.z) return;
  if (axis == 0) return outline_.along_u(b, out);
  outline_.along_v(c, out);
}

}  // namespace kerf::stock::compare
