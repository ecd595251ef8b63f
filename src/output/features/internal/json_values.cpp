#include "output/features/internal/json_values.hpp"

#include "base/decimal.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::output {
namespace {

constexpr int kDecimals = 6;

}  // namespace

std::string rounded(double value) { return base::rounded_text(value, kDecimals); }

std::string rounded_or_null(const std::optional<double>& value) {
  return value ? rounded(*value) : "null";
}

std::string pair_json(double first, double second) {
  return "[" + rounded(first) + "," + rounded(second) + "]";
}

std::string point_json(geometry::Vec2 at) { return pair_json(at.u, at.v); }

std::string contour_json(const contour::Contour& contour) {
  std::string text = "[";
  for (const contour::Vertex& vertex : contour.vertices) {
    if (text.size() > 1) text += ',';
    text += "[" + rounded(vertex.point.u) + "," + rounded(vertex.point.v) + "," +
            base::rounded_text(vertex.bulge, 9) + "]";
  }
  return text + "]";
}

std::string contours_json(const std::vector<contour::Contour>& contours) {
  std::vector<std::string> items;
  items.reserve(contours.size());
  for (const contour::Contour& contour : contours) items.push_back(contour_json(contour));
  return json_array(items);
}

std::string rounded_numbers_json(const std::vector<double>& values) {
  std::vector<std::string> items;
  items.reserve(values.size());
  for (const double value : values) items.push_back(rounded(value));
  return json_array(items);
}

std::string lines_json(const LineRange& lines) {
  std::string text = "[";
  base::append_integer(text, lines.first);
  text += ',';
  base::append_integer(text, lines.last);
  return text + "]";
}

std::string id_of(std::string_view letter, std::size_t place) {
  std::string text = "\"";
  text += letter;
  base::append_integer(text, static_cast<std::int64_t>(place) + 1);
  return text + "\"";
}

}  // namespace kerf::output
