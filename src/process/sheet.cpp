#include "process/sheet.hpp"

#include <cmath>
#include <numbers>

#include "drawing/pen.hpp"

namespace kerf::process {
namespace {

using contour::Box;
using contour::Contour;
using drawing::Affine;

/// 0, 1/2 or 1 of the extents along each axis; the zero of the drawing has none.
Vec2 anchor_of(Anchor anchor, const Box& box) {
  if (anchor == Anchor::origin) return {};
  const auto place = static_cast<unsigned>(anchor) - static_cast<unsigned>(Anchor::lower_left);
  const Vec2 share{0.5 * (place % 3), 0.5 * (place / 3)};  // left to right, row by row from below
  const Vec2 size = box.high - box.low;
  return box.low + Vec2{share.u * size.u, share.v * size.v};
}

double scale_to_fit(const std::array<double, 2>& fit, Vec2 size) {
  const double across = size.u > 0 ? fit[0] / size.u : HUGE_VAL;
  const double up = size.v > 0 ? fit[1] / size.v : HUGE_VAL;
  return std::isfinite(std::min(across, up)) ? std::min(across, up) : 1;
}

Affine scaled(const PlaceWords& place, const Box& extents) {
  if (!place.fit) return Affine::scaled(place.scale[0], place.scale[1]);
  const double scale = scale_to_fit(*place.fit, extents.high - extents.low);
  return Affine::scaled(scale, scale);
}

Affine mirrored(Mirror mirror) {
  switch (mirror) {
    case Mirror::none: break;
    case Mirror::x: return Affine::scaled(-1, 1);
    case Mirror::y: return Affine::scaled(1, -1);
  }
  return {};
}

/// Exact where circles stay circles, else by the pen, which fits them.
Contour mapped(const Contour& path, const Affine& map, double tolerance_mm) {
  if (map.scale()) {
    Contour result = path;
    const double sign = map.determinant() < 0 ? -1 : 1;
    for (contour::Vertex& vertex : result.vertices) {
      vertex.point = map(vertex.point);
      vertex.bulge *= sign;
    }
    return result;
  }
  drawing::Reading reading;
  reading.tolerance_mm = tolerance_mm;
  drawing::Drawing drawn;
  drawing::Canvas canvas(reading, drawn);
  canvas.begin_file({}, "");
  const drawing::EntityId entity = canvas.add(drawing::Entity{});
  {
    drawing::Pen pen(canvas, entity, map);
    pen.begin(path.vertices[0].point);
    for (std::size_t i = 0; i < edge_count(path); ++i) {
      const contour::Edge edge = edge_of(path, i);
      pen.bulge_to(edge.to, edge.bulge);
    }
    if (path.is_closed) pen.close();
  }
  if (drawn.paths.empty()) return {{}, path.is_closed};
  return contour_of(drawn, drawn.paths[0]);
}

Box box_of(const Box& box, const Affine& map) {
  Box result;
  for (const Vec2 corner :
       {box.low, Vec2{box.high.u, box.low.v}, box.high, Vec2{box.low.u, box.high.v}})
    result.take(map(corner));
  return result;
}

Vec2 anchor_in(const Box& extents, const Affine& map, Anchor anchor) {
  return extents.is_empty() ? Vec2{} : anchor_of(anchor, box_of(extents, map));
}

}  // namespace

Affine placement(const PlaceWords& place, const Box& extents) {
  Affine map = then(scaled(place, extents), mirrored(place.mirror));
  map = then(map, Affine::turned(place.rotate_deg * std::numbers::pi / 180));
  return then(map, Affine::moved(place.at - anchor_in(extents, map, place.anchor)));
}

Box extents_of(const drawing::Cleaned& cleaned) {
  Box box;
  for (const drawing::Chain& chain : cleaned.chains) box.take(extents(chain.path));
  for (const drawing::Point& point : cleaned.points) box.take(point.at);
  return box;
}

Sheet placed(const drawing::Drawing& drawing, const drawing::Cleaned& cleaned, const Affine& map,
             double tolerance_mm) {
  Sheet sheet;
  sheet.placed = map;
  for (const drawing::Chain& chain : cleaned.chains) {
    Outline outline;
    outline.path = mapped(chain.path, map, tolerance_mm);
    outline.entity = chain.entity;
    outline.number = static_cast<std::uint32_t>(sheet.outlines.size());
    outline.rule = drawing.entities[chain.entity].rule;
    sheet.outlines.push_back(std::move(outline));
  }
  for (const drawing::Point& point : cleaned.points)
    sheet.points.push_back({map(point.at), point.entity});
  return sheet;
}

}  // namespace kerf::process
