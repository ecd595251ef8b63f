#include "drawing/svg/internal/style.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "drawing/svg/internal/colours.hpp"
#include "drawing/svg/internal/lengths.hpp"
#include "drawing/svg/internal/scanner.hpp"

namespace kerf::drawing::svg {
namespace {

/// A property's value into a style. What is no value of it leaves it as it was.
using Set = void (*)(Style& style, const Style& parent, std::string_view value);

void set_paint(Paint& paint, std::string_view value) {
  if (value == "none") {
    paint = {};
  } else if (same_letters(value, "currentColor")) {
    paint = {Paint::Kind::current, {}, {}};
  } else if (is_reference(value)) {
    paint = {Paint::Kind::server, {}, value};
  } else if (const auto colour = colour_of(value)) {
    const bool is_seen = colour->alpha > 0;
    paint = {is_seen ? Paint::Kind::colour : Paint::Kind::none, colour->colour, {}};
  }
}

void set_opacity(double& opacity, std::string_view value) {
  Scanner in(value);
  const auto number = in.number();
  if (number) opacity = std::clamp(in.take('%') ? *number / 100 : *number, 0.0, 1.0);
}

void set_color(Style& style, const Style&, std::string_view value) {
  if (const auto colour = colour_of(value)) style.color = colour->colour;
}
void set_display(Style& style, const Style&, std::string_view value) {
  style.is_displayed = value != "none";
}
void set_fill(Style& style, const Style&, std::string_view value) { set_paint(style.fill, value); }
void set_fill_opacity(Style& style, const Style&, std::string_view value) {
  set_opacity(style.fill_opacity, value);
}
void set_fill_rule(Style& style, const Style&, std::string_view value) {
  if (value == "evenodd") style.rule = FillRule::even_odd;
  if (value == "nonzero") style.rule = FillRule::non_zero;
}
void set_stroke(Style& style, const Style&, std::string_view value) {
  set_paint(style.stroke, value);
}
void set_stroke_opacity(Style& style, const Style&, std::string_view value) {
  set_opacity(style.stroke_opacity, value);
}
void set_visibility(Style& style, const Style&, std::string_view value) {
  if (value == "visible") style.is_visible = true;
  if (value == "hidden" || value == "collapse") style.is_visible = false;
}
void set_element_opacity(Style& style, const Style&, std::string_view value) {
  set_opacity(style.opacity, value);
}
void set_markers(Style& style, const Style&, std::string_view value) {
  style.has_markers = value != "none";
}
void set_dashes(Style& style, const Style&, std::string_view value) {
  style.dashes = value == "none" ? std::string_view{} : value;
}
void set_dash_shift(Style& style, const Style&, std::string_view value) {
  const auto length = length_of(value);
  style.are_dashes_shifted = length && length->number != 0;
}
void set_clip_path(Style& style, const Style&, std::string_view value) {
  style.clip_path = value == "none" ? std::string_view{} : value;
}
void set_mask(Style& style, const Style&, std::string_view value) {
  style.mask = value == "none" ? std::string_view{} : value;
}
void set_filter(Style& style, const Style&, std::string_view value) {
  style.filter = value == "none" ? std::string_view{} : value;
}
void set_transform(Style& style, const Style&, std::string_view value) { style.transform = value; }

void set_overflow(Style& style, const Style&, std::string_view value) {
  style.may_overflow = value == "visible" || value == "auto";
}

void set_anchor(Style& style, const Style&, std::string_view value) {
  if (value == "start") style.anchor = Across::left;
  if (value == "middle") style.anchor = Across::centre;
  if (value == "end") style.anchor = Across::right;
}

void set_font_size(Style& style, const Style& parent, std::string_view value) {
  constexpr std::array<std::pair<std::string_view, double>, 7> kNamed{{{"xx-small", 9},
                                                                       {"x-small", 10},
                                                                       {"small", 13},
                                                                       {"medium", 16},
                                                                       {"large", 18},
                                                                       {"x-large", 24},
                                                                       {"xx-large", 32}}};
  for (const auto& [name, size] : kNamed)
    if (name == value) style.font_size = size;
  const auto length = length_of(value);
  if (!length || length->number < 0) return;
  const Measures measures{{parent.font_size, parent.font_size}, parent.font_size};
  style.font_size = in_units(*length, Along::x, measures).value_or(style.font_size);
}

Set setter_of(Key property) {
  switch (property) {
    case Key::clip_path: return set_clip_path;
    case Key::color: return set_color;
    case Key::display: return set_display;
    case Key::fill: return set_fill;
    case Key::fill_opacity: return set_fill_opacity;
    case Key::fill_rule: return set_fill_rule;
    case Key::filter: return set_filter;
    case Key::font_size: return set_font_size;
    case Key::marker:
    case Key::marker_end:
    case Key::marker_mid:
    case Key::marker_start: return set_markers;
    case Key::mask: return set_mask;
    case Key::opacity: return set_element_opacity;
    case Key::overflow: return set_overflow;
    case Key::stroke: return set_stroke;
    case Key::stroke_dasharray: return set_dashes;
    case Key::stroke_dashoffset: return set_dash_shift;
    case Key::stroke_opacity: return set_stroke_opacity;
    case Key::text_anchor: return set_anchor;
    case Key::transform: return set_transform;
    case Key::visibility: return set_visibility;
    default: return nullptr;
  }
}

/// `inherit` takes what the parent has; of properties that are not inherited that is seldom meant.
void inherit(Style& style, const Style& parent, Key property) {
  switch (property) {
    case Key::color: style.color = parent.color; break;
    case Key::fill: style.fill = parent.fill; break;
    case Key::stroke: style.stroke = parent.stroke; break;
    case Key::fill_opacity: style.fill_opacity = parent.fill_opacity; break;
    case Key::stroke_opacity: style.stroke_opacity = parent.stroke_opacity; break;
    case Key::fill_rule: style.rule = parent.rule; break;
    case Key::visibility: style.is_visible = parent.is_visible; break;
    case Key::stroke_dasharray: style.dashes = parent.dashes; break;
    case Key::font_size: style.font_size = parent.font_size; break;
    case Key::text_anchor: style.anchor = parent.anchor; break;
    case Key::opacity: style.opacity = parent.opacity; break;
    case Key::display: style.is_displayed = parent.is_displayed; break;
    default: break;
  }
}

void apply(Style& style, const Style& parent, const Declaration& declaration) {
  if (declaration.value == "inherit") return inherit(style, parent, declaration.property);
  setter_of(declaration.property)(style, parent, declaration.value);
}

Style inherited(const Style& parent) {
  Style style = parent;
  const Style initial;
  style.is_displayed = true;
  style.opacity = 1;
  style.may_overflow = false;
  style.clip_path = style.mask = style.filter = style.transform = initial.clip_path;
  return style;
}

}  // namespace

bool is_reference(std::string_view value) { return value.starts_with("url("); }

bool Style::is_painted() const {
  return (fill.kind != Paint::Kind::none && fill_opacity > 0) ||
         (stroke.kind != Paint::Kind::none && stroke_opacity > 0);
}

Style style_of(const Tree& tree, const StyleSheet& sheet, ElementId id, const Style& parent) {
  Style style = inherited(parent);
  std::string_view own;
  tree.each_attribute(id, [&](Key key, std::string_view value) {
    if (is_property(key)) apply(style, parent, {key, trimmed(value)});
    if (key == Key::style) own = value;
  });
  if (own.empty() && sheet.is_empty()) return style;
  std::vector<Declaration> declarations;
  if (!sheet.is_empty()) sheet.append_matching(tree, id, declarations);
  append_declarations(own, declarations);
  for (const bool is_important : {false, true})
    for (const Declaration& declaration : declarations)
      if (declaration.is_important == is_important) apply(style, parent, declaration);
  return style;
}

}  // namespace kerf::drawing::svg
