#pragma once

#include <cstdint>
#include <string>

#include "base/result.hpp"
#include "base/source_file.hpp"
#include "geometry/mesh/solid_mesh.hpp"

namespace kerf::machine {

/// Of the numbers in a file that does not say it.
enum class MeshUnit : std::uint8_t { mm, inch };

/// The solid in an STL file, binary or text. The file is read piece by piece; what is held of it is
/// the mesh. Failure (input): it cannot be read, is no STL, is not closed (the sentence counts the
/// open edges), or its triangles need more than `memory_bytes`.
[[nodiscard]] base::Outcome<mesh::SolidMesh> read_mesh(const std::string& path, MeshUnit unit,
                                                       std::size_t memory_bytes);

/// The same of a file that is open.
[[nodiscard]] base::Outcome<mesh::SolidMesh> mesh_in(const base::SourceFile& file, MeshUnit unit,
                                                     std::size_t memory_bytes);

/// The same of bytes that are there; `name` is what messages call them.
[[nodiscard]] base::Outcome<mesh::SolidMesh> mesh_of(std::string bytes, const std::string& name,
                                                     MeshUnit unit, std::size_t memory_bytes);

}  // namespace kerf::machine
