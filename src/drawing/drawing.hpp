#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/place.hpp"
#include "drawing/affine.hpp"
#include "drawing/names.hpp"
#include "geometry/contour/contour.hpp"

namespace kerf::drawing {

/// Red, green and blue, a byte each: 0xRRGGBB.
enum class Colour : std::uint32_t {};
/// "#ff0000"
[[nodiscard]] std::string text_of(Colour colour);

enum class FillRule : std::uint8_t { even_odd, non_zero };

inline constexpr std::uint32_t kEveryCopy = 0xffffffffU;

/// What an entity of a file says of itself.
struct Entity {
  base::FileId file = base::kNoFile;
  std::uint32_t line = 0;  ///< of its group 0, or of its tag
  Name layer{};
  Name kind{};     ///< as the file names it: LWPOLYLINE, path
  Name handle{};   ///< or id
  Name classes{};  ///< parted by blanks
  Name dashes{};   ///< lengths on and off along its paths, mm, parted by blanks; empty: none
  Colour colour{};
  FillRule rule = FillRule::even_odd;
  /// Of an array: the copy that alone has it; kEveryCopy as nearly always.
  std::uint32_t copy = kEveryCopy;
};

using EntityId = std::uint32_t;

/// Entities that may be the same or be joined: of one layer, and of one copy.
using Group = std::uint64_t;
[[nodiscard]] inline Group group_of(const Entity& entity) {
  return (Group{entity.copy} << 32U) | static_cast<std::uint32_t>(entity.layer);
}

/// Lines and arcs of one entity; a stretch of Drawing::vertices, whose owner is the entity. The
/// last vertex of an open path has no edge.
struct Path {
  std::size_t first = 0;
  std::uint32_t count = 0;
  bool is_closed = false;
};

/// A place without a way: what drills holes makes of it a hole.
struct Point {
  Vec2 at;
  EntityId entity = 0;
};

enum class Across : std::uint8_t { left, centre, right, aligned, fit };
enum class Upright : std::uint8_t { base_line, bottom, middle, top };

/// Words to be drawn with a font. In their own plane they begin at (0, 0) and go along +X on the
/// base line; `to_mm` brings that plane to its place.
struct Text {
  std::string words;  ///< UTF-8; a new line: a line below
  Affine to_mm;
  double height = 0;   ///< of capitals, in the plane of the words
  double width = 0;    ///< of Across::aligned and fit, in the same plane; 0: as wide as they are
  double stretch = 1;  ///< of the letters along the line
  Across across = Across::left;
  Upright upright = Upright::base_line;
  EntityId entity = 0;
};

/// A picture of pixels, as bytes of a PNG or JPEG file.
struct Image {
  std::string bytes;
  /// Where its lower left corner, and from there its right and upper ones lie: of the unit square.
  Affine to_mm;
  bool size_is_known = false;  ///< else the picture itself, or the job, has to say how large it is
  EntityId entity = 0;
};

/// What was told of a drawing, with where it belongs.
struct Finding {
  base::Diagnostic diagnostic;
  Name layer{};
  Name entity{};
};

/// What is in a file and is not drawn.
struct Ignored {
  std::string what;
  std::size_t count = 0;
  std::uint32_t line = 0;  ///< of the first one
  std::string why;
};

/// What a file says of itself.
struct FileFacts {
  base::FileId file = base::kNoFile;
  std::string format;     ///< dxf, svg, image, trace, contours
  std::string version;    ///< AC1015, 1.1
  std::string unit;       ///< mm, in
  std::string unit_from;  ///< what says so: $INSUNITS, viewBox, --unit, assumed
  double scale_mm = 1;    ///< a unit, mm
  Vec2 page_mm{};         ///< from zero to the upper right corner of the page; 0: it has none
  std::map<std::string, std::size_t> entities;  ///< what was drawn, by kind
  std::vector<Ignored> ignored;
};

/// One or more files, mm, X to the right, Y up, each about its own zero.
struct Drawing {
  Names names;
  std::vector<FileFacts> files;
  std::vector<Entity> entities;
  std::vector<contour::Vertex> vertices;
  std::vector<Path> paths;  ///< in the order of the files
  std::vector<Point> points;
  std::vector<Text> texts;
  std::vector<Image> images;
  std::vector<Finding> findings;
  /// The most that an arc is away from the curve that it stands for, mm.
  double error_mm = 0;
};

[[nodiscard]] contour::Contour contour_of(const Drawing& drawing, const Path& path);

}  // namespace kerf::drawing
