// Any bytes as an STL: a sentence, or a solid whose volume is above 0, whose dexels and columns can
// be made, and which is the same however the bytes came.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

#include "geometry/mesh/solid_mesh.hpp"
#include "geometry/mesh/stl_reader.hpp"
#include "stock/cutting/placement.hpp"
#include "stock/dexel/tri_dexel.hpp"

namespace {

using namespace kerf;

constexpr std::size_t kMostTriangles = 20'000;
constexpr double kCellsAlong = 12;

void require(bool condition) {
  if (!condition) std::abort();
}

base::Outcome<mesh::TriangleMesh> read(std::string_view bytes, std::size_t piece) {
  mesh::StlReader reader(
      {.size = bytes.size(), .mm_per_unit = 1, .most_triangles = kMostTriangles});
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    if (!reader.take(bytes.substr(at, piece))) break;
  }
  return reader.finish();
}

void check_dexels(const stock::MeshShape& shape) {
  const stock::Vec3 size = shape.box.high - shape.box.low;
  if (!(std::min({size.x, size.y, size.z}) > 1e-3)) return;
  const double cell = std::max({size.x, size.y, size.z}) / kCellsAlong;
  const stock::dexel::TriDexel model(stock::dexel::mesh_shape(shape.solid), cell, 1);
  for (const double volume : model.grids_mm3()) require(std::isfinite(volume) && volume >= 0);
}

void check_solid(mesh::TriangleMesh triangles) {
  auto solid = mesh::solid_of(std::move(triangles));
  if (!solid) return require(!solid.error().message.empty());
  require(solid->volume_mm3 > 0 && std::isfinite(solid->volume_mm3));
  const stock::MeshShape shape = stock::mesh_shape(std::move(*solid));
  check_dexels(shape);
  const stock::Workpiece there = stock::placed(shape, {{1, 2, 3}, {30, 0, 90}});
  require(stock::volume(there) == shape.solid->volume_mm3);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  auto whole = read(bytes, std::max<std::size_t>(size, 1));
  const auto in_pieces = read(bytes, 7);
  require(whole.has_value() == in_pieces.has_value());
  if (!whole) {
    require(!whole.error().message.empty() && whole.error().message == in_pieces.error().message);
    return 0;
  }
  require(whole->points == in_pieces->points && whole->triangles == in_pieces->triangles);
  check_solid(std::move(*whole));
  return 0;
}
