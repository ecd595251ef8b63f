#include "drawing/dxf/internal/kinds.hpp"

#include <array>
#include <utility>

namespace kerf::drawing::dxf {
namespace {

constexpr std::array<Kind, 15> kKinds{{{"LINE", Frame::world, draw_line},
                                       {"LWPOLYLINE", Frame::own, draw_lwpolyline},
                                       {"ARC", Frame::own, draw_arc},
                                       {"CIRCLE", Frame::own, draw_circle},
                                       {"SPLINE", Frame::world, draw_spline},
                                       {"ELLIPSE", Frame::axes, draw_ellipse},
                                       {"POINT", Frame::world, draw_point},
                                       {"TEXT", Frame::own, draw_text},
                                       {"MTEXT", Frame::axes, draw_mtext},
                                       {"ATTRIB", Frame::own, draw_attribute},
                                       {"ATTDEF", Frame::own, draw_attribute},
                                       {"HATCH", Frame::own, draw_hatch},
                                       {"SOLID", Frame::own, draw_solid},
                                       {"TRACE", Frame::own, draw_solid},
                                       {"3DFACE", Frame::world, draw_face}}};

constexpr std::string_view kBody = "a body has no outline of its own";
constexpr std::string_view kEndless = "it has no end";
constexpr std::string_view kNote = "notes and dimensions are not made";
constexpr std::string_view kPicture = "a picture inside of a DXF is not read";

constexpr std::array<std::pair<std::string_view, std::string_view>, 24> kNotDrawn{
    {{"DIMENSION", kNote},
     {"ARC_DIMENSION", kNote},
     {"LARGE_RADIAL_DIMENSION", kNote},
     {"LEADER", kNote},
     {"MLEADER", kNote},
     {"MULTILEADER", kNote},
     {"TOLERANCE", kNote},
     {"ACAD_TABLE", "tables are not drawn: break it up into lines and texts"},
     {"XLINE", kEndless},
     {"RAY", kEndless},
     {"IMAGE", kPicture},
     {"OLEFRAME", kPicture},
     {"OLE2FRAME", kPicture},
     {"WIPEOUT", "it only covers what lies below"},
     {"VIEWPORT", "it only shows what is drawn elsewhere"},
     {"3DSOLID", kBody},
     {"BODY", kBody},
     {"REGION", kBody},
     {"SURFACE", kBody},
     {"MESH", kBody},
     {"MLINE", "multiple lines are not drawn: break it up"},
     {"SHAPE", "its strokes are in a file of shapes"},
     {"ACAD_PROXY_ENTITY", "only the program that made it knows what it is"},
     {"VERTEX", "it belongs to no POLYLINE"}}};

}  // namespace

const Kind* find_kind(std::string_view name) {
  for (const Kind& kind : kKinds)
    if (kind.name == name) return &kind;
  return nullptr;
}

std::string_view why_not_drawn(std::string_view kind) {
  for (const auto& [name, why] : kNotDrawn)
    if (name == kind) return why;
  return "entities of this kind are not drawn";
}

}  // namespace kerf::drawing::dxf
