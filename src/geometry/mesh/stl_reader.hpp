#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.hpp"
#include "geometry/mesh/triangle_mesh.hpp"

namespace kerf::mesh {

class StlTriangles;

/// The triangles of an STL file, which comes in pieces of any length. Binary and text are told
/// apart by content: a file whose length is what its count of triangles asks for is binary,
/// whatever its header says; else one that begins with "solid" and has text behind it is text.
/// Normals, colours and names are not looked at. Numbers are single floats where they are binary
/// and doubles where they are text; equal corners become one.
class StlReader {
 public:
  struct Settings {
    std::uint64_t size = 0;          ///< of the whole file, bytes
    double mm_per_unit = 1;          ///< of its numbers
    std::size_t most_triangles = 0;  ///< more are refused
  };
  explicit StlReader(const Settings& settings);
  ~StlReader();
  StlReader(const StlReader&) = delete;
  StlReader& operator=(const StlReader&) = delete;

  /// The next bytes. False: something is wrong with them, the rest need not come.
  bool take(std::string_view bytes);
  /// Behind the last byte. Failure (input): a sentence without the name of the file, with the line
  /// of a text: cut off, more triangles announced than are there, a number that is none or lies
  /// beyond kFarthest_mm, too many triangles.
  [[nodiscard]] base::Outcome<TriangleMesh> finish();

  static constexpr double kFarthest_mm = 100'000;

 private:
  void begin();

  Settings settings_;
  std::string head_;  // until it is known what it is
  std::unique_ptr<StlTriangles> triangles_;
  std::optional<std::string> wrong_;
};

}  // namespace kerf::mesh
