#include "stock/tool/insert.hpp"

#include <algorithm>
#include <utility>

#include "base/decimal.hpp"
#include "stock/tool/internal/insert_outline.hpp"
#include "stock/tool/internal/tool_body.hpp"

namespace kerf::stock {
namespace {

using contour::Contour;
using contour::Vec2;
using M = Measure;

/// How the base position becomes that of a tip direction.
struct Placing {
  bool is_symmetric = false;
  bool mirrors_z = false;
  bool mirrors_rho = false;
  bool swaps = false;  ///< Z and ρ
};

// The base positions are T3, and T8 where the insert is symmetric.
Placing placing_of(int tip) {
  switch (tip) {
    case 1: return {.mirrors_z = true, .mirrors_rho = true};
    case 2: return {.mirrors_rho = true};
    case 4: return {.mirrors_z = true};
    case 5: return {.is_symmetric = true, .mirrors_z = true, .swaps = true};
    case 6: return {.is_symmetric = true, .mirrors_rho = true};
    case 7: return {.is_symmetric = true, .swaps = true};
    case 8: return {.is_symmetric = true};
    default: return {};
  }
}

bool has_centre_for_origin(int tip) { return tip == 0 || tip == 9; }

int tip_of(const Tool& tool) { return static_cast<int>(tool[M::tip]); }

/// The direction that it stands as.
int stance_of(const Tool& tool) {
  if (!has_centre_for_origin(tip_of(tool))) return tip_of(tool);
  return static_cast<int>(row_of(tool.kind).key(M::tip)->otherwise);
}

Vec2 placed(Vec2 point, const Placing& placing) {
  if (placing.swaps) std::swap(point.u, point.v);
  if (placing.mirrors_z) point.u = -point.u;
  if (placing.mirrors_rho) point.v = -point.v;
  return point;
}

Contour placed(const Contour& contour, const Placing& placing) {
  Contour out = contour;
  for (contour::Vertex& vertex : out.vertices) vertex.point = placed(vertex.point, placing);
  const int mirrors = static_cast<int>(placing.swaps) + static_cast<int>(placing.mirrors_z) +
                      static_cast<int>(placing.mirrors_rho);
  if (mirrors % 2 == 0) return out;
  for (contour::Vertex& vertex : out.vertices) vertex.bulge = -vertex.bulge;
  return contour::reversed(out);
}

/// In the base position.
Insert base_insert(const Tool& tool, const Placing& placing) {
  switch (tool.kind) {
    case ToolKind::grooving:
    case ToolKind::parting:
    case ToolKind::face_grooving: return blade(tool, placing.is_symmetric);
    case ToolKind::threading: return thread_point(tool, placing.is_symmetric);
    default: return nosed_insert(tool, placing.is_symmetric);
  }
}

// A blade of a face stands along Z: its base position is the other one mirrored at the bisector, T3
// again, but T7 where it is symmetric.
Placing placing_of(const Tool& tool) {
  Placing placing = placing_of(stance_of(tool));
  if (tool.kind == ToolKind::face_grooving && !placing.is_symmetric) placing.swaps = true;
  return placing;
}

void shift(Contour& contour, Vec2 by) {
  for (contour::Vertex& vertex : contour.vertices) vertex.point = vertex.point + by;
}

// A bar for holes points along +Z away from the insert, at the far side of the smallest hole that
// it goes into.
std::optional<Contour> bar_of(const Tool& tool, const Contour& outline, bool points_up) {
  const auto bore = tool.said(M::minimum_bore);
  const auto overhang = tool.said(M::overhang);
  const auto width = tool.said(M::holder_width);
  if (!bore || !overhang || !width) return {};
  const contour::Box box = contour::extents(outline);
  const bool to_right = box.high.u > -box.low.u;
  const double near = to_right ? box.high.u : -*overhang;
  const double far = to_right ? *overhang : box.low.u;
  const double low = points_up ? -*bore : *bore - *width;
  return rectangle({near, low}, {far, low + *width}, InsertPart::back);
}

std::string objection_to_bar(const Tool& tool) {
  const auto bore = tool.said(M::minimum_bore);
  const auto width = tool.said(M::holder_width);
  if (bore && width && *width >= *bore)
    return "holder_width, " + base::number_text(*width) + ", is not less than minimum_bore, " +
           base::number_text(*bore);
  if (!tool.said(M::overhang)) return {};
  const contour::Box box = contour::extents(insert_of(tool).outline);
  const double reach = std::max(box.high.u, -box.low.u);
  if (*tool.said(M::overhang) > reach) return {};
  return "overhang, " + base::number_text(*tool.said(M::overhang)) +
         ", is not more than the insert's own length, " + base::rounded_text(reach, 4);
}

}  // namespace

std::string objection_to_insert(const Tool& tool) {
  if (std::string wrong = objection_to_outline(tool); !wrong.empty()) return wrong;
  return tool.kind == ToolKind::boring_bar ? objection_to_bar(tool) : std::string();
}

Insert insert_of(const Tool& tool) {
  const Placing placing = placing_of(tool);
  Insert insert = base_insert(tool, placing);
  insert.outline = placed(insert.outline, placing);
  insert.nose_centre = placed(insert.nose_centre, placing);
  if (tool.kind == ToolKind::boring_bar)
    insert.holder = bar_of(tool, insert.outline, insert.nose_centre.v <= 0);
  if (!has_centre_for_origin(tip_of(tool))) return insert;
  const Vec2 by = -insert.nose_centre;
  shift(insert.outline, by);
  if (insert.holder) shift(*insert.holder, by);
  insert.nose_centre = {};
  return insert;
}

}  // namespace kerf::stock
