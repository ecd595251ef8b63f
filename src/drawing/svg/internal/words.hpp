#pragma once

#include <cstdint>
#include <string_view>

namespace kerf::drawing::svg {

/// The elements that mean something here. `words` is a stretch of text between tags.
enum class Tag : std::uint8_t {
  other,
  words,
  a,
  circle,
  clip_path,
  defs,
  ellipse,
  filter,
  flow_root,
  foreign_object,
  g,
  image,
  line,
  linear_gradient,
  marker,
  mask,
  path,
  pattern,
  polygon,
  polyline,
  radial_gradient,
  rect,
  style,
  svg,
  switch_,
  symbol,
  text,
  text_path,
  tref,
  tspan,
  use,
};

[[nodiscard]] Tag tag_of(std::string_view name);
/// As the file writes it.
[[nodiscard]] std::string_view name_of(Tag tag);

/// Attributes and properties that mean something here; properties stand first.
enum class Key : std::uint8_t {
  unknown,
  clip_path,
  color,
  display,
  fill,
  fill_opacity,
  fill_rule,
  filter,
  font_size,
  marker,
  marker_end,
  marker_mid,
  marker_start,
  mask,
  opacity,
  overflow,
  stroke,
  stroke_dasharray,
  stroke_dashoffset,
  stroke_opacity,
  text_anchor,
  transform,
  visibility,
  last_property = visibility,
  class_,
  cx,
  cy,
  d,
  dx,
  dy,
  groupmode,
  height,
  href,
  id,
  inkscape_version,
  label,
  points,
  preserve_aspect_ratio,
  r,
  required_extensions,
  rotate,
  rx,
  ry,
  style,
  system_language,
  version,
  view_box,
  width,
  words,  ///< the text of Tag::words
  x,
  x1,
  x2,
  xml_space,
  y,
  y1,
  y2,
};

[[nodiscard]] constexpr bool is_property(Key key) {
  return key != Key::unknown && key <= Key::last_property;
}

/// Of an attribute without a namespace, or a property.
[[nodiscard]] Key key_of(std::string_view name);
/// Of xlink, inkscape and xml.
[[nodiscard]] Key key_of(std::string_view name_space, std::string_view name);

}  // namespace kerf::drawing::svg
