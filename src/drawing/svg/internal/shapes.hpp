#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drawing/pen.hpp"
#include "drawing/svg/internal/lengths.hpp"
#include "drawing/svg/internal/tree.hpp"

namespace kerf::drawing::svg {

/// The lengths of an element's attributes.
class Attributes {
 public:
  Attributes(const Tree& tree, ElementId id, const Measures& measures)
      : tree_(tree), id_(id), measures_(measures) {}

  /// None: it does not say it, or `auto`, or no length, which mistake() tells then.
  [[nodiscard]] std::optional<double> given(Key key, Along along);
  [[nodiscard]] double of(Key key, Along along) { return given(key, along).value_or(0); }
  [[nodiscard]] std::string_view text(Key key) const { return tree_.text(id_, key); }

  /// Of the last attribute that was none; empty: there was none.
  [[nodiscard]] const std::string& mistake() const { return mistake_; }

 private:
  const Tree& tree_;
  ElementId id_;
  Measures measures_;
  std::string mistake_;
};

/// The corners of `points`; with `mistake` what stops them.
struct Corners {
  std::vector<Vec2> corners;
  std::string mistake;
};
[[nodiscard]] Corners corners_of(std::string_view points);

/// What a basic shape is, in user units, before it is drawn.
struct Shape {
  enum class Kind : std::uint8_t { nothing, rect, ellipse, line, corners, path } kind{};
  Vec2 corner;  ///< of a rect; where a line begins; the middle of an ellipse
  Vec2 size;    ///< of a rect; where a line ends; the radii of an ellipse
  Vec2 radii;   ///< of a rect's corners
  std::vector<Vec2> corners;
  bool is_closed = true;
  std::string mistake;
};

/// Of rect, circle, ellipse, line, polyline, polygon and path. Nothing: it has no size, for which
/// the standard draws nothing.
[[nodiscard]] Shape shape_of(Tag tag, Attributes& attributes);

/// Draws a shape that is no path.
void draw_shape(const Shape& shape, Pen& pen);

}  // namespace kerf::drawing::svg
