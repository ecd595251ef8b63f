#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "drawing/colour_index.hpp"
#include "drawing/contours/contours_writer.hpp"
#include "drawing/contours/internal/piece_writer.hpp"

namespace kerf::drawing {
namespace {

/// Writes groups; a word and its number each on a line of its own.
class GroupWriter {
 public:
  explicit GroupWriter(const WritePiece& write) : out_(write) {}

  void operator()(int code, std::string_view text) {
    out_ << fmt::format("{:3}\n", code) << text << "\n";
  }
  void operator()(int code, int number) { (*this)(code, fmt::format("{:6}", number)); }
  void operator()(int code, double number) {
    out_ << fmt::format("{:3}\n", code) << number << "\n";
  }
  void point(Vec2 at) {
    (*this)(10, at.u);
    (*this)(20, at.v);
    (*this)(30, 0.0);
  }

 private:
  PieceWriter out_;
};

/// The next character of UTF-8, which is taken off.
char32_t take_character(std::string_view& text) {
  const auto first = static_cast<unsigned char>(text.front());
  std::size_t length = 1;
  if (first >= 0xF0)
    length = 4;
  else if (first >= 0xE0)
    length = 3;
  else if (first >= 0xC0)
    length = 2;
  length = std::min(length, text.size());
  char32_t character = length == 1 ? first : first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i)
    character = (character << 6U) | (static_cast<unsigned char>(text[i]) & 0x3FU);
  text.remove_prefix(length);
  return character;
}

/// A name in ASCII, other characters by their numbers.
std::string plain_name(std::string_view name) {
  if (name.empty()) return "0";
  std::string plain;
  while (!name.empty()) {
    const char32_t c = take_character(name);
    if (c >= 0x20 && c < 0x7F)
      plain += static_cast<char>(c);
    else if (c < 0x10000)
      plain += c < 0x20 ? "_" : fmt::format("\\U+{:04X}", static_cast<std::uint32_t>(c));
    else
      plain += fmt::format("\\U+{:04X}\\U+{:04X}", 0xD800 + ((c - 0x10000) >> 10U),
                           0xDC00 + ((c - 0x10000) & 0x3FFU));
  }
  return plain;
}

void write_header(GroupWriter& group) {
  group(0, "SECTION");
  group(2, "HEADER");
  group(9, "$ACADVER");
  group(1, "AC1009");
  group(9, "$INSUNITS");
  group(70, 4);
  group(0, "ENDSEC");
}

void write_layers(const std::vector<ContourLayer>& layers, GroupWriter& group) {
  group(0, "SECTION");
  group(2, "TABLES");
  group(0, "TABLE");
  group(2, "LTYPE");
  group(70, 1);
  group(0, "LTYPE");
  group(2, "CONTINUOUS");
  group(70, 0);
  group(3, "Solid line");
  group(72, 65);
  group(73, 0);
  group(40, 0.0);
  group(0, "ENDTAB");
  group(0, "TABLE");
  group(2, "LAYER");
  group(70, static_cast<int>(std::min<std::size_t>(layers.size(), 32767)));
  for (const ContourLayer& layer : layers) {
    group(0, "LAYER");
    group(2, plain_name(layer.name));
    group(70, 0);
    group(62, nearest_index(layer.colour));
    group(6, "CONTINUOUS");
  }
  group(0, "ENDTAB");
  group(0, "ENDSEC");
}

void write_polyline(const contour::Contour& contour, std::string_view layer, GroupWriter& group) {
  group(0, "POLYLINE");
  group(8, layer);
  group(66, 1);
  group.point({});
  group(70, contour.is_closed ? 1 : 0);
  for (const contour::Vertex& vertex : contour.vertices) {
    group(0, "VERTEX");
    group(8, layer);
    group.point(vertex.point);
    if (vertex.bulge != 0) group(42, vertex.bulge);
  }
  group(0, "SEQEND");
  group(8, layer);
}

void write_contour(const contour::Contour& contour, std::string_view layer, GroupWriter& group) {
  if (contour.vertices.size() > 1) return write_polyline(contour, layer, group);
  if (contour.vertices.empty()) return;
  group(0, "POINT");
  group(8, layer);
  group.point(contour.vertices.front().point);
}

}  // namespace

void write_contours_dxf(const std::vector<ContourLayer>& layers, const WritePiece& write) {
  GroupWriter group(write);
  write_header(group);
  write_layers(layers, group);
  group(0, "SECTION");
  group(2, "ENTITIES");
  for (const ContourLayer& layer : layers) {
    const std::string name = plain_name(layer.name);
    for (const contour::Contour& contour : layer.contours) write_contour(contour, name, group);
  }
  group(0, "ENDSEC");
  group(0, "EOF");
}

}  // namespace kerf::drawing
