#include "stock/cutting/workpiece.hpp"

#include <array>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "geometry/mesh/lines.hpp"
#include "stock/cutting/saved_part.hpp"

namespace kerf::stock {
namespace {

double volume_of(const BoxShape& box) {
  const Vec3 size = box.high - box.low;
  return size.x * size.y * size.z;
}

double volume_of(const CylinderShape& c) {
  return std::numbers::pi / 4 * (c.diameter + c.inner_diameter) * (c.diameter - c.inner_diameter) *
         (c.to - c.from);
}

double volume_of(const MeshShape& mesh) { return mesh.solid->volume_mm3; }

double volume_of(const SavedShape& saved) { return saved.part->volume_mm3(); }

Bounds bounds_of(const BoxShape& box) { return {box.low, box.high}; }

Bounds bounds_of(const CylinderShape& c) {
  const double r = c.diameter / 2;
  switch (c.along) {
    case 0: return {{c.from, c.u - r, c.v - r}, {c.to, c.u + r, c.v + r}};
    case 1: return {{c.u - r, c.from, c.v - r}, {c.u + r, c.to, c.v + r}};
    default: return {{c.u - r, c.v - r, c.from}, {c.u + r, c.v + r, c.to}};
  }
}

// Of a side of a mesh. So many show whether shells overlap anywhere that matters, and so many
// measure what they hold together.
constexpr int kLinesThatShow = 256;
constexpr int kLinesThatMeasure = 1024;

mesh::LineGrid lines_over(const mesh::MeshBox& box, int count) {
  mesh::LineGrid grid{2, {}, {}};
  for (int i = 0; i < count; ++i) {
    const double share = (i + 0.5) / count;
    grid.b.push_back(box.low.x + share * (box.high.x - box.low.x));
    grid.c.push_back(box.low.y + share * (box.high.y - box.low.y));
  }
  return grid;
}

double volume_by_lines(const mesh::TriangleMesh& mesh, const mesh::MeshBox& box) {
  const mesh::Lines lines(mesh, lines_over(box, kLinesThatMeasure));
  double sum = 0;
  std::vector<mesh::Stretch> inside;
  for (std::size_t row = 0; row < kLinesThatMeasure; ++row) {
    inside.clear();
    for (std::size_t column = 0; column < kLinesThatMeasure; ++column)
      lines.inside(column, row, 0, inside);
    double row_sum = 0;
    for (const mesh::Stretch& one : inside) row_sum += one.high - one.low;
    sum += row_sum;
  }
  const Vec3 size = box.high - box.low;
  return sum * size.x / kLinesThatMeasure * size.y / kLinesThatMeasure;
}

Bounds bounds_of(const MeshShape& mesh) { return mesh.box; }

Bounds bounds_of(const SavedShape& saved) { return saved.part->box(); }

MeshShape shared(mesh::SolidMesh solid, const mesh::MeshBox& box) {
  const Vec3 seen = mesh::seen_mm2(solid.mesh);
  return {std::make_shared<const mesh::SolidMesh>(std::move(solid)), {box.low, box.high}, seen};
}

}  // namespace

MeshShape mesh_shape(mesh::SolidMesh solid) {
  const mesh::MeshBox box = mesh::box_of(solid.mesh);
  if (mesh::Lines(solid.mesh, lines_over(box, kLinesThatShow)).is_wound_otherwise()) {
    solid.volume_mm3 = volume_by_lines(solid.mesh, box);
    solid.changes.push_back("shells overlap: the volume is measured along " +
                            std::to_string(kLinesThatMeasure) + " x " +
                            std::to_string(kLinesThatMeasure) + " lines");
  }
  return shared(std::move(solid), box);
}

MeshShape mesh_shape(mesh::TriangleMesh mesh, double volume_mm3) {
  const mesh::MeshBox box = mesh::box_of(mesh);
  return shared({.mesh = std::move(mesh), .volume_mm3 = volume_mm3}, box);
}

double volume(const Workpiece& piece) {
  return std::visit([](const auto& one) { return volume_of(one); }, piece);
}

Bounds bounds(const Workpiece& piece) {
  return std::visit([](const auto& one) { return bounds_of(one); }, piece);
}

}  // namespace kerf::stock
