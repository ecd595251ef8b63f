#pragma once

#include <string_view>

#include "drawing/drawing.hpp"
#include "drawing/svg/internal/style_sheet.hpp"

namespace kerf::drawing::svg {

/// What fills or strokes.
struct Paint {
  enum class Kind : std::uint8_t { none, colour, current, server } kind = Kind::none;
  Colour colour{};
  std::string_view server;  ///< of Kind::server: "url(#name) fallback"
};

/// The properties of an element that mean something here. Views are of the tree.
struct Style {
  // What children inherit.
  Colour color{};
  Paint fill{Paint::Kind::colour, {}, {}};
  Paint stroke{};
  double fill_opacity = 1;
  double stroke_opacity = 1;
  FillRule rule = FillRule::non_zero;
  bool is_visible = true;
  bool has_markers = false;
  std::string_view dashes;  ///< empty: none
  bool are_dashes_shifted = false;
  double font_size = 16;  ///< user units
  Across anchor = Across::left;
  // What they do not.
  bool is_displayed = true;
  double opacity = 1;
  bool may_overflow = false;  ///< a viewport does not clip
  std::string_view clip_path;
  std::string_view mask;
  std::string_view filter;
  std::string_view transform;

  /// Whether it leaves anything on the paper.
  [[nodiscard]] bool is_painted() const;
};

/// The style of an element below one that has the style `parent`: attributes, then style sheets by
/// their weight, then its attribute `style`, then what is !important.
[[nodiscard]] Style style_of(const Tree& tree, const StyleSheet& sheet, ElementId id,
                             const Style& parent);

/// Whether it is "url(…)".
[[nodiscard]] bool is_reference(std::string_view value);

}  // namespace kerf::drawing::svg
