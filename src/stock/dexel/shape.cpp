#include "stock/dexel/shape.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "geometry/mesh/lines.hpp"
#include "stock/dexel/tile.hpp"

namespace kerf::stock::dexel {
namespace {

Vec3 from_parts(int axis, double along, double b, double c) {
  std::array<double, 3> v{};
  v[static_cast<std::size_t>(axis)] = along;
  v[static_cast<std::size_t>((axis + 1) % 3)] = b;
  v[static_cast<std::size_t>((axis + 2) % 3)] = c;
  return {v[0], v[1], v[2]};
}

std::array<double, 3> parts(Vec3 v) { return {v.x, v.y, v.z}; }

/// Half of the chord of a circle at a distance from its centre; below 0: none.
double half_chord(double radius, double distance) {
  const double squared = radius * radius - distance * distance;
  return squared > 0 ? std::sqrt(squared) : -1;
}

void along_round(const Round& round, double b, double c, std::vector<Interval>& out) {
  const double squared = (b - round.b) * (b - round.b) + (c - round.c) * (c - round.c);
  if (squared > round.radius_mm * round.radius_mm || squared < round.inner_mm * round.inner_mm) {
    return;
  }
  const Vec3 up = from_parts(round.axis, 1, 0, 0);
  out.push_back({round.low, round.high, -1.0 * up, up});
}

/// Across it, in the plane of two coordinates: `middle` is the centre on the line, `distance` that
/// of the line from it; `normal` makes directions of (along, aside).
template <class Normal>
void across_round(const Round& round, double middle, double distance, Normal&& normal,
                  std::vector<Interval>& out) {
  const double outer = half_chord(round.radius_mm, distance);
  const double inner = half_chord(round.inner_mm, distance);
  if (outer <= 0) return;
  const auto face = [&](double s, double radius) { return normal(s / radius, distance / radius); };
  if (inner <= 0) {
    out.push_back({middle - outer, middle + outer, face(-outer, round.radius_mm),
                   face(outer, round.radius_mm)});
    return;
  }
  out.push_back({middle - outer, middle - inner, face(-outer, round.radius_mm),
                 -1.0 * face(-inner, round.inner_mm)});
  out.push_back({middle + inner, middle + outer, -1.0 * face(inner, round.inner_mm),
                 face(outer, round.radius_mm)});
}

void through_round(const Round& round, int axis, double b, double c, std::vector<Interval>& out) {
  if (axis == round.axis) {
    along_round(round, b, c, out);
  } else if (axis == (round.axis + 1) % 3) {  // b is the round's c, c lies along it
    if (c < round.low || c > round.high) return;
    const auto normal = [&](double s, double d) { return from_parts(round.axis, 0, s, d); };
    across_round(round, round.b, b - round.c, normal, out);
  } else {  // b lies along it, c is the round's b
    if (b < round.low || b > round.high) return;
    const auto normal = [&](double s, double d) { return from_parts(round.axis, 0, d, s); };
    across_round(round, round.c, c - round.b, normal, out);
  }
}

mesh::LineGrid lines_of(const Lattice& lattice, Vec3 middle) {
  mesh::LineGrid grid{lattice.axis, {}, {}};
  const double b = on_axis(middle, (lattice.axis + 1) % 3);
  const double c = on_axis(middle, (lattice.axis + 2) % 3);
  for (int i = 0; i < lattice.columns; ++i) grid.b.push_back(b + lattice.b_of(i));
  for (int i = 0; i < lattice.rows; ++i) grid.c.push_back(c + lattice.c_of(i));
  return grid;
}

}  // namespace

InsideOf inside_of(const Shape& shape, const Lattice& lattice, Vec3 middle) {
  if (shape.on_lattice) return shape.on_lattice(lattice, middle);
  const double b = on_axis(middle, (lattice.axis + 1) % 3);
  const double c = on_axis(middle, (lattice.axis + 2) % 3);
  return [&shape, &lattice, b, c](int column, int row, std::vector<Interval>& out) {
    shape.inside(lattice.axis, b + lattice.b_of(column), c + lattice.c_of(row), out);
  };
}

Shape box_shape(const Bounds& box) {
  const auto inside = [box](int axis, double, double, std::vector<Interval>& out) {
    const auto i = static_cast<std::size_t>(axis);
    const Vec3 up = from_parts(axis, 1, 0, 0);
    out.push_back({parts(box.low)[i], parts(box.high)[i], -1.0 * up, up});
  };
  const Vec3 size = box.high - box.low;
  return {box, inside, size.x * size.y * size.z};
}

Shape round_shape(const Round& round) {
  const double r = round.radius_mm;
  const Bounds box{from_parts(round.axis, round.low, round.b - r, round.c - r),
                   from_parts(round.axis, round.high, round.b + r, round.c + r)};
  const auto inside = [round](int axis, double b, double c, std::vector<Interval>& out) {
    through_round(round, axis, b, c, out);
  };
  const double area = std::numbers::pi * (r * r - round.inner_mm * round.inner_mm);
  return {box, inside, area * (round.high - round.low)};
}

Shape mesh_shape(std::shared_ptr<const mesh::SolidMesh> solid) {
  const mesh::MeshBox box = mesh::box_of(solid->mesh);
  Shape shape{.box = {box.low, box.high}, .inside = {}, .volume_mm3 = solid->volume_mm3};
  shape.on_lattice = [solid](const Lattice& lattice, Vec3 middle) -> InsideOf {
    const auto lines = std::make_shared<const mesh::Lines>(solid->mesh, lines_of(lattice, middle));
    return [solid, lines](int column, int row, std::vector<Interval>& out) {
      std::vector<mesh::Stretch> found;
      lines->inside(static_cast<std::size_t>(column), static_cast<std::size_t>(row),
                    Tile::kLeast_mm, found);
      for (const mesh::Stretch& s : found) {
        out.push_back({s.low, s.high, mesh::normal_of(solid->mesh, s.low_triangle),
                       mesh::normal_of(solid->mesh, s.high_triangle)});
      }
    };
  };
  return shape;
}

}  // namespace kerf::stock::dexel
