#pragma once

#include <string_view>

#include "drawing/dxf/internal/subject.hpp"

namespace kerf::drawing::dxf {

/// In what plane the coordinates of an entity are.
enum class Frame : std::uint8_t {
  world,  ///< the drawing's; where its extrusion points to does not matter
  axes,   ///< the drawing's, but the extrusion says which way it turns
  own     ///< that of its extrusion
};

/// A kind of entities that is one record.
struct Kind {
  std::string_view name;
  Frame frame;
  void (*draw)(Subject& subject);
};

/// Null: it is not drawn, or not by one record.
[[nodiscard]] const Kind* find_kind(std::string_view name);
/// Why entities of a kind are not drawn.
[[nodiscard]] std::string_view why_not_drawn(std::string_view kind);

void draw_line(Subject& subject);
void draw_point(Subject& subject);
void draw_arc(Subject& subject);
void draw_circle(Subject& subject);
void draw_ellipse(Subject& subject);
void draw_solid(Subject& subject);
void draw_face(Subject& subject);
void draw_lwpolyline(Subject& subject);
void draw_spline(Subject& subject);
void draw_hatch(Subject& subject);
void draw_text(Subject& subject);
void draw_attribute(Subject& subject);
void draw_mtext(Subject& subject);

}  // namespace kerf::drawing::dxf
