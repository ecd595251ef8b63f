#include "stock/saved/saved_turned.hpp"

#include "stock/saved/quarter_turn.hpp"
#include "stock/surface/turned_surface.hpp"
#include "stock/turned/revolved.hpp"
#include "stock/turned/turned_part.hpp"

namespace kerf::stock::saved {
namespace {

// Chords of its solid.
constexpr double kChord_mm = 0.001;

/// Against Z: what went round it anticlockwise does so again.
contour::Contour mirrored(contour::Contour loop) {
  for (contour::Vertex& vertex : loop.vertices) {
    vertex.point.u = -vertex.point.u;
    vertex.bulge = -vertex.bulge;
  }
  return contour::reversed(loop);
}

}  // namespace

Bounds SavedTurned::box() const { return turned::bounds(region_); }

std::size_t SavedTurned::bytes() const {
  return contour::vertex_count(region_) * sizeof(contour::Vertex);
}

std::unique_ptr<Model> SavedTurned::model(unsigned) const {
  return std::make_unique<turned::TurnedPart>(region_);
}

MeshShape SavedTurned::solid() const {
  return mesh_shape(surface::turned(region_, kChord_mm).mesh, volume_mm3_);
}

std::shared_ptr<const SavedPart> SavedTurned::placed(const Placing& placing) const {
  const Vec3 axis = placing.turned({0, 0, 1});
  const Vec3 zero = placing({0, 0, 0});
  if (axis.x != 0 || axis.y != 0 || zero.x != 0 || zero.y != 0) return nullptr;
  contour::Region region = region_;
  for (contour::Contour& loop : region.loops) {
    if (axis.z < 0) loop = mirrored(std::move(loop));
    for (contour::Vertex& vertex : loop.vertices) vertex.point.u += zero.z;
  }
  return std::make_shared<const SavedTurned>(std::move(region), volume_mm3_);
}

}  // namespace kerf::stock::saved
