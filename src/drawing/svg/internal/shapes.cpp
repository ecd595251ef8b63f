#include "drawing/svg/internal/shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "drawing/svg/internal/scanner.hpp"

namespace kerf::drawing::svg {
namespace {

constexpr double kQuarter_rad = 0.5 * std::numbers::pi;

/// One radius that is not given is the other one; none is more than half of the side.
Shape rect_of(Attributes& attributes) {
  Shape shape;
  shape.corner = {attributes.of(Key::x, Along::x), attributes.of(Key::y, Along::y)};
  shape.size = {attributes.of(Key::width, Along::x), attributes.of(Key::height, Along::y)};
  if (!(shape.size.u > 0) || !(shape.size.v > 0)) return shape;
  const auto rx = attributes.given(Key::rx, Along::x);
  const auto ry = attributes.given(Key::ry, Along::y);
  const double across = rx && *rx >= 0 ? *rx : ry.value_or(0);
  const double down = ry && *ry >= 0 ? *ry : rx.value_or(0);
  shape.radii = {std::clamp(across, 0.0, 0.5 * shape.size.u),
                 std::clamp(down, 0.0, 0.5 * shape.size.v)};
  if (!(shape.radii.u > 0) || !(shape.radii.v > 0)) shape.radii = {};
  shape.kind = Shape::Kind::rect;
  return shape;
}

Shape ellipse_of(Tag tag, Attributes& attributes) {
  Shape shape;
  shape.corner = {attributes.of(Key::cx, Along::x), attributes.of(Key::cy, Along::y)};
  if (tag == Tag::circle) {
    const double radius = attributes.of(Key::r, Along::both);
    shape.size = {radius, radius};
  } else {
    const auto rx = attributes.given(Key::rx, Along::x);
    const auto ry = attributes.given(Key::ry, Along::y);
    shape.size = {rx.value_or(ry.value_or(0)), ry.value_or(rx.value_or(0))};
  }
  const bool has_size = shape.size.u > 0 && shape.size.v > 0;
  shape.kind = has_size ? Shape::Kind::ellipse : Shape::Kind::nothing;
  return shape;
}

Shape line_of(Attributes& attributes) {
  Shape shape;
  shape.kind = Shape::Kind::line;
  shape.corner = {attributes.of(Key::x1, Along::x), attributes.of(Key::y1, Along::y)};
  shape.size = {attributes.of(Key::x2, Along::x), attributes.of(Key::y2, Along::y)};
  return shape;
}

Shape poly_of(Tag tag, Attributes& attributes) {
  Shape shape;
  Corners corners = corners_of(attributes.text(Key::points));
  shape.mistake = std::move(corners.mistake);
  shape.corners = std::move(corners.corners);
  shape.is_closed = tag == Tag::polygon;
  if (!shape.corners.empty()) shape.kind = Shape::Kind::corners;
  return shape;
}

/// A quarter from `middle + into` to `middle + out`, which is `to`.
void round_corner(Pen& pen, Vec2 middle, Vec2 into, Vec2 out, Vec2 to) {
  pen.ellipse({middle, into, out}, 0, kQuarter_rad);
  pen.end_at(to);
}

void line_unless_there(Pen& pen, Vec2 to) {
  if (pen.at() != to) pen.line_to(to);
}

/// As the standard says: from the end of the upper left corner to the right, and round.
void draw_rounded(Vec2 low, Vec2 size, Vec2 r, Pen& pen) {
  const Vec2 high = low + size;
  const Vec2 x{r.u, 0};
  const Vec2 y{0, r.v};
  pen.begin({low.u + r.u, low.v});
  line_unless_there(pen, {high.u - r.u, low.v});
  round_corner(pen, {high.u - r.u, low.v + r.v}, -y, x, {high.u, low.v + r.v});
  line_unless_there(pen, {high.u, high.v - r.v});
  round_corner(pen, {high.u - r.u, high.v - r.v}, x, y, {high.u - r.u, high.v});
  line_unless_there(pen, {low.u + r.u, high.v});
  round_corner(pen, {low.u + r.u, high.v - r.v}, y, -x, {low.u, high.v - r.v});
  line_unless_there(pen, {low.u, low.v + r.v});
  round_corner(pen, {low.u + r.u, low.v + r.v}, -x, -y, {low.u + r.u, low.v});
  pen.close();
}

void draw_corners(const std::vector<Vec2>& corners, bool is_closed, Pen& pen) {
  pen.begin(corners.front());
  for (std::size_t i = 1; i < corners.size(); ++i)
    if (corners[i] != pen.at()) pen.line_to(corners[i]);
  if (is_closed)
    pen.close();
  else
    pen.end();
}

}  // namespace

std::optional<double> Attributes::given(Key key, Along along) {
  const auto text = tree_.attribute(id_, key);
  if (!text || trimmed(*text) == "auto") return std::nullopt;
  const auto length = length_of(*text);
  const auto units = length ? in_units(*length, along, measures_) : std::nullopt;
  if (!units) mistake_ = fmt::format("'{}' is no length", text->substr(0, 40));
  return units;
}

Corners corners_of(std::string_view points) {
  Corners result;
  Scanner in(points);
  in.skip_blanks();
  while (!in.is_done()) {
    const auto u = in.number();
    in.skip_comma();
    const auto v = in.number();
    in.skip_comma();
    if (!u || !v) {
      result.mistake = fmt::format("a number of point {} is missing", result.corners.size() + 1);
      return result;
    }
    result.corners.push_back({*u, *v});
  }
  return result;
}

Shape shape_of(Tag tag, Attributes& attributes) {
  Shape shape;
  switch (tag) {
    case Tag::rect: shape = rect_of(attributes); break;
    case Tag::circle:
    case Tag::ellipse: shape = ellipse_of(tag, attributes); break;
    case Tag::line: shape = line_of(attributes); break;
    case Tag::polyline:
    case Tag::polygon: shape = poly_of(tag, attributes); break;
    default:
      if (!trimmed(attributes.text(Key::d)).empty()) shape.kind = Shape::Kind::path;
  }
  if (!attributes.mistake().empty()) shape.mistake = attributes.mistake();
  return shape;
}

void draw_shape(const Shape& shape, Pen& pen) {
  const Vec2 corner = shape.corner;
  const Vec2 size = shape.size;
  switch (shape.kind) {
    case Shape::Kind::rect:
      if (shape.radii.u > 0) return draw_rounded(corner, size, shape.radii, pen);
      return draw_corners(
          {corner, {corner.u + size.u, corner.v}, corner + size, {corner.u, corner.v + size.v}},
          true, pen);
    case Shape::Kind::ellipse: return pen.whole({corner, {size.u, 0}, {0, size.v}});
    case Shape::Kind::line: return draw_corners({corner, size}, false, pen);
    case Shape::Kind::corners: return draw_corners(shape.corners, shape.is_closed, pen);
    case Shape::Kind::path:
    case Shape::Kind::nothing: return;
  }
}

}  // namespace kerf::drawing::svg
