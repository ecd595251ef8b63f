#include "machine/definition/mesh_file.hpp"

#include <algorithm>
#include <utility>

#include "geometry/mesh/stl_reader.hpp"
#include "motion/feed.hpp"

namespace kerf::machine {
namespace {

using base::Outcome;

constexpr std::size_t kPiece = 1 << 20;
// Held at most while a mesh is read: corners, numbers of corners, and the tables that find equal
// corners and open edges.
constexpr std::size_t kBytesOfTriangle = 80;
constexpr std::size_t kMostTriangles = 500'000'000;  // corners have numbers of 31 bits
constexpr std::uint64_t kLargestPipe = std::uint64_t{4} << 30U;

base::Failure named(const std::string& name, base::Failure failure) {
  failure.message = name + ": " + failure.message;
  return failure;
}

}  // namespace

Outcome<mesh::SolidMesh> mesh_in(const base::SourceFile& file, MeshUnit unit,
                                 std::size_t memory_bytes) {
  mesh::StlReader reader(
      {.size = file.size(),
       .mm_per_unit = unit == MeshUnit::inch ? motion::kMillimetresPerInch : 1,
       .most_triangles = std::min(memory_bytes / kBytesOfTriangle, kMostTriangles)});
  std::string piece(std::min<std::uint64_t>(kPiece, file.size()), '\0');
  for (std::uint64_t at = 0; at < file.size();) {
    const std::size_t count = file.read(at, piece);
    if (count == 0 || !reader.take(std::string_view(piece).substr(0, count))) break;
    at += count;
  }
  auto mesh = reader.finish();
  if (!mesh) return tl::unexpected(named(file.name(), mesh.error()));
  auto solid = mesh::solid_of(std::move(*mesh));
  if (!solid) return tl::unexpected(named(file.name(), solid.error()));
  return solid;
}

Outcome<mesh::SolidMesh> read_mesh(const std::string& path, MeshUnit unit,
                                   std::size_t memory_bytes) {
  const auto file = base::SourceFile::open(path, {.most_bytes = kLargestPipe, .seconds = 60});
  if (!file) return tl::unexpected(file.error());
  return mesh_in(**file, unit, memory_bytes);
}

Outcome<mesh::SolidMesh> mesh_of(std::string bytes, const std::string& name, MeshUnit unit,
                                 std::size_t memory_bytes) {
  return mesh_in(*base::SourceFile::from_text(name, std::move(bytes)), unit, memory_bytes);
}

}  // namespace kerf::machine
