#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/mesh/corner_pool.hpp"
#include "geometry/mesh/stl_reader.hpp"

namespace kerf::mesh {

/// Of ASCII letters; words of the format may be written either way.
[[nodiscard]] constexpr char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// What is wrong, a sentence.
using Wrong = std::optional<std::string>;

/// One of the two forms of STL as it comes in.
class StlTriangles {
 public:
  explicit StlTriangles(const StlReader::Settings& settings) : settings_(settings) {}
  virtual ~StlTriangles() = default;
  StlTriangles(const StlTriangles&) = delete;
  StlTriangles& operator=(const StlTriangles&) = delete;

  [[nodiscard]] virtual Wrong take(std::string_view bytes) = 0;
  /// Nothing more comes.
  [[nodiscard]] virtual Wrong end() = 0;

  [[nodiscard]] TriangleMesh mesh() && {
    return {.points = std::move(corners_).take(), .triangles = std::move(triangles_)};
  }

 protected:
  [[nodiscard]] const StlReader::Settings& settings() const { return settings_; }
  void reserve(std::size_t triangles);
  /// In units of the file.
  [[nodiscard]] Wrong add_corner(geometry::Vec3 corner);

 private:
  StlReader::Settings settings_;
  CornerPool corners_;
  std::vector<Triangle> triangles_;
  Triangle open_{};
  std::size_t corner_ = 0;  // of the open one
};

/// 80 bytes, u32 count, 50 bytes a triangle: normal, three corners (f32), two bytes more.
class BinaryStl final : public StlTriangles {
 public:
  explicit BinaryStl(const StlReader::Settings& settings) : StlTriangles(settings) {}
  [[nodiscard]] Wrong take(std::string_view bytes) override;
  [[nodiscard]] Wrong end() override;

  static constexpr std::size_t kHead = 84;
  static constexpr std::size_t kRecord = 50;
  /// `head` has kHead bytes.
  [[nodiscard]] static std::uint64_t count_in(std::string_view head);

 private:
  [[nodiscard]] Wrong use(std::string_view piece);
  [[nodiscard]] Wrong begin(std::string_view head);

  std::string carried_;  // of what is not complete
  bool has_begun_ = false;
  std::uint64_t expected_ = 0;
  std::uint64_t read_ = 0;
};

/// solid [name] { facet normal x y z  outer loop  { vertex x y z }3  endloop  endfacet }
/// endsolid [name], words in any case, one solid behind another.
class TextStl final : public StlTriangles {
 public:
  explicit TextStl(const StlReader::Settings& settings);
  [[nodiscard]] Wrong take(std::string_view bytes) override;
  [[nodiscard]] Wrong end() override;

 private:
  [[nodiscard]] Wrong take_character(char c);
  [[nodiscard]] Wrong end_word();
  [[nodiscard]] Wrong take_word();
  [[nodiscard]] Wrong take_number();
  [[nodiscard]] Wrong at_line(const std::string& what) const;

  std::string word_;
  std::size_t expected_;  // of the words of the grammar
  std::uint64_t line_ = 1;
  bool is_name_ = false;  // the rest of the line
  geometry::Vec3 vertex_;
};

}  // namespace kerf::mesh
