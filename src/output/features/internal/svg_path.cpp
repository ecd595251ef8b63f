#include "output/features/internal/svg_path.hpp"

#include <string_view>

#include "base/decimal.hpp"

namespace kerf::output {
namespace {

constexpr int kDigits = 4;

std::string coordinate(double value) { return base::rounded_text(value, kDigits); }

std::string point_text(contour::Vec2 at) { return coordinate(at.u) + " " + coordinate(at.v); }

// No edge turns by more than half a circle, so that the large arc is never meant.
std::string edge_text(const contour::Edge& edge, contour::Vec2 by) {
  if (edge.bulge == 0) return "L" + point_text(edge.to + by);
  const std::string radius = coordinate(contour::radius(edge));
  const std::string_view sense = edge.bulge > 0 ? "1 " : "0 ";
  return "A" + radius + " " + radius + " 0 0 " + std::string(sense) + point_text(edge.to + by);
}

std::string_view escaped(char c) {
  switch (c) {
    case '&': return "&amp;";
    case '<': return "&lt;";
    case '>': return "&gt;";
    case '"': return "&quot;";
    default: return {};
  }
}

}  // namespace

std::string svg_path(const std::vector<contour::Contour>& contours, contour::Vec2 by) {
  std::string text;
  for (const contour::Contour& contour : contours) {
    if (contour.vertices.empty()) continue;
    text += "M" + point_text(contour.vertices.front().point + by);
    for (std::size_t i = 0; i < contour::edge_count(contour); ++i)
      text += edge_text(contour::edge_of(contour, i), by);
    if (contour.is_closed) text += "Z";
  }
  return text;
}

std::string xml_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const std::string_view name = escaped(c);
    if (name.empty()) {
      out += c;
    } else {
      out += name;
    }
  }
  return out;
}

}  // namespace kerf::output
