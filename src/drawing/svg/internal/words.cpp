#include "drawing/svg/internal/words.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace kerf::drawing::svg {
namespace {

template <typename T>
using Row = std::pair<std::string_view, T>;

constexpr auto kTags = std::to_array<Row<Tag>>({{"a", Tag::a},
                                                {"circle", Tag::circle},
                                                {"clipPath", Tag::clip_path},
                                                {"defs", Tag::defs},
                                                {"ellipse", Tag::ellipse},
                                                {"filter", Tag::filter},
                                                {"flowRoot", Tag::flow_root},
                                                {"foreignObject", Tag::foreign_object},
                                                {"g", Tag::g},
                                                {"image", Tag::image},
                                                {"line", Tag::line},
                                                {"linearGradient", Tag::linear_gradient},
                                                {"marker", Tag::marker},
                                                {"mask", Tag::mask},
                                                {"path", Tag::path},
                                                {"pattern", Tag::pattern},
                                                {"polygon", Tag::polygon},
                                                {"polyline", Tag::polyline},
                                                {"radialGradient", Tag::radial_gradient},
                                                {"rect", Tag::rect},
                                                {"style", Tag::style},
                                                {"svg", Tag::svg},
                                                {"switch", Tag::switch_},
                                                {"symbol", Tag::symbol},
                                                {"text", Tag::text},
                                                {"textPath", Tag::text_path},
                                                {"tref", Tag::tref},
                                                {"tspan", Tag::tspan},
                                                {"use", Tag::use}});

constexpr auto kKeys = std::to_array<Row<Key>>({{"class", Key::class_},
                                                {"clip-path", Key::clip_path},
                                                {"color", Key::color},
                                                {"cx", Key::cx},
                                                {"cy", Key::cy},
                                                {"d", Key::d},
                                                {"display", Key::display},
                                                {"dx", Key::dx},
                                                {"dy", Key::dy},
                                                {"fill", Key::fill},
                                                {"fill-opacity", Key::fill_opacity},
                                                {"fill-rule", Key::fill_rule},
                                                {"filter", Key::filter},
                                                {"font-size", Key::font_size},
                                                {"height", Key::height},
                                                {"href", Key::href},
                                                {"id", Key::id},
                                                {"marker", Key::marker},
                                                {"marker-end", Key::marker_end},
                                                {"marker-mid", Key::marker_mid},
                                                {"marker-start", Key::marker_start},
                                                {"mask", Key::mask},
                                                {"opacity", Key::opacity},
                                                {"overflow", Key::overflow},
                                                {"points", Key::points},
                                                {"preserveAspectRatio", Key::preserve_aspect_ratio},
                                                {"r", Key::r},
                                                {"requiredExtensions", Key::required_extensions},
                                                {"rotate", Key::rotate},
                                                {"rx", Key::rx},
                                                {"ry", Key::ry},
                                                {"stroke", Key::stroke},
                                                {"stroke-dasharray", Key::stroke_dasharray},
                                                {"stroke-dashoffset", Key::stroke_dashoffset},
                                                {"stroke-opacity", Key::stroke_opacity},
                                                {"style", Key::style},
                                                {"systemLanguage", Key::system_language},
                                                {"text-anchor", Key::text_anchor},
                                                {"transform", Key::transform},
                                                {"version", Key::version},
                                                {"viewBox", Key::view_box},
                                                {"visibility", Key::visibility},
                                                {"width", Key::width},
                                                {"x", Key::x},
                                                {"x1", Key::x1},
                                                {"x2", Key::x2},
                                                {"y", Key::y},
                                                {"y1", Key::y1},
                                                {"y2", Key::y2}});

template <typename T, std::size_t N>
T found(const std::array<Row<T>, N>& rows, std::string_view name, T otherwise) {
  const auto place =
      std::lower_bound(rows.begin(), rows.end(), name,
                       [](const Row<T>& row, std::string_view word) { return row.first < word; });
  return place != rows.end() && place->first == name ? place->second : otherwise;
}

template <typename T, std::size_t N>
constexpr bool is_sorted(const std::array<Row<T>, N>& rows) {
  for (std::size_t i = 1; i < N; ++i)
    if (!(rows[i - 1].first < rows[i].first)) return false;
  return true;
}
static_assert(is_sorted(kTags) && is_sorted(kKeys));

}  // namespace

Tag tag_of(std::string_view name) { return found(kTags, name, Tag::other); }

std::string_view name_of(Tag tag) {
  for (const auto& [name, value] : kTags)
    if (value == tag) return name;
  return "?";
}

Key key_of(std::string_view name) { return found(kKeys, name, Key::unknown); }

Key key_of(std::string_view name_space, std::string_view name) {
  if (name_space == "http://www.w3.org/1999/xlink" && name == "href") return Key::href;
  if (name_space == "http://www.w3.org/XML/1998/namespace" && name == "space")
    return Key::xml_space;
  if (name_space != "http://www.inkscape.org/namespaces/inkscape") return Key::unknown;
  if (name == "label") return Key::label;
  if (name == "groupmode") return Key::groupmode;
  return name == "version" ? Key::inkscape_version : Key::unknown;
}

}  // namespace kerf::drawing::svg
