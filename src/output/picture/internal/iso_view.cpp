#include "output/picture/internal/iso_view.hpp"

#include <algorithm>
#include <cmath>

#include "output/picture/drawing/label_placer.hpp"
#include "output/picture/drawing/palette.hpp"
#include "output/picture/drawing/ruler.hpp"
#include "output/picture/drawing/text.hpp"
#include "output/picture/internal/marks.hpp"

namespace kerf::output::plot {
namespace {

constexpr double kShortestEdge = 12;  // pixels: shorter edges of the box get no ruler

// Edge of the box that carries a ruler: along one axis from `corner`, marks going outward.
struct Edge {
  std::size_t axis;
  Point3 corner;
  Point outward;
  Anchor anchor;
  double min_step;  // pixels between labels
  const char* name;
};

// The two lower edges in front and the upright one to the left:
//
//           _.-'-._
//       _.-'       '-._
//     |'-._         _.-'|
//   Z |    '-._ _.-'    |
//     |        |        |
//      '-._    |    _.-'
//      X   '-._|_.-'   Y
//
std::array<Edge, 3> ruled_edges(const Box3& box) {
  const Point3 left = box.low();
  const Point3 front{box.high()[kX], box.low()[kY], box.low()[kZ]};
  return {Edge{kX, left, {-kCos30, 0.5}, Anchor::end, 40, "X"},
          Edge{kY, front, {kCos30, 0.5}, Anchor::start, 40, "Y"},
          Edge{kZ, left, {-1, 0}, Anchor::end, 26, "Z"}};
}

Point3 along(const Point3& from, std::size_t axis, double value) {
  Point3 point = from;
  point[axis] = value;
  return point;
}

Point offset(Point from, Point direction, double by) {
  return {from.x + direction.x * by, from.y + direction.y * by};
}

void draw_box(DisplayList& sheet, const View& view, const Box3& box) {
  Outline edges;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t second = (axis + 1) % 3, third = (axis + 2) % 3;
    for (int corner = 0; corner < 4; ++corner) {
      Point3 from = box.low();
      if ((corner & 1) != 0) from[second] = box.high()[second];
      if ((corner & 2) != 0) from[third] = box.high()[third];
      edges.segment(view.map(from), view.map(along(from, axis, box.high()[axis])));
    }
  }
  sheet.add(std::move(edges), {kAxis, 0.9, false, {}});
}

// Lines across the floor at the labelled marks of one of its edges.
void draw_floor(DisplayList& sheet, const View& view, const Box3& box, const Edge& edge,
                const std::vector<Tick>& ticks) {
  const std::size_t across = edge.axis == kX ? kY : kX;
  Outline grid;
  for (const Tick& tick : ticks) {
    if (!tick.major) continue;
    const Point3 from = along(box.low(), edge.axis, tick.value);
    grid.segment(view.map(from), view.map(along(from, across, box.high()[across])));
  }
  sheet.add(std::move(grid), {kGrid, 1, false, {}});
}

// Room that a text of this width takes, beside `at`.
Rect text_room(Point at, double width, Anchor anchor) {
  const double left = anchor == Anchor::end ? at.x - width : at.x;
  return {left, at.y - kTickText / 2, width, kTickText};
}

void draw_label(DisplayList& sheet, Point at, const std::string& text, Anchor anchor,
                LabelPlacer& labels) {
  if (!labels.claim(text_room(at, text_width(text, kTickText), anchor))) return;
  sheet.add(Text{{at.x, at.y + 4.3}, text, kTickText, anchor, kDark});
}

void draw_edge(DisplayList& sheet, const View& view, const Box3& box, const Edge& edge,
               const std::vector<Tick>& ticks, LabelPlacer& labels) {
  Outline marks;
  double widest = 0;
  for (const Tick& tick : ticks) {
    const Point at = view.map(along(edge.corner, edge.axis, tick.value));
    marks.segment(at, offset(at, edge.outward, tick.major ? 7 : 4));
    if (!tick.major) continue;
    widest = std::max(widest, text_width(tick.label, kTickText));
    draw_label(sheet, offset(at, edge.outward, 12), tick.label, edge.anchor, labels);
  }
  const Point start = view.map(edge.corner);
  const Point end = view.map(along(edge.corner, edge.axis, box.high()[edge.axis]));
  marks.segment(start, end);
  sheet.add(std::move(marks), {kFrame, 1.1, false, {}});
  Point name = offset({(start.x + end.x) / 2, (start.y + end.y) / 2}, edge.outward, 18);
  name.x += (edge.anchor == Anchor::end ? -1 : 1) * (widest + 12);
  sheet.add(Text{{name.x, name.y + 5}, edge.name, 14, edge.anchor, kDark, true});
}

void draw_arrow(DisplayList& sheet, Point from, Point direction, const char* name) {
  constexpr double kLength = 34, kHead = 7;
  const Point tip = offset(from, direction, kLength);
  const Point back = offset(tip, direction, -kHead);
  const Point aside{-direction.y, direction.x};
  Outline arrow;
  arrow.segment(from, tip);
  arrow.segment(offset(back, aside, 0.45 * kHead), tip);
  arrow.line_to(offset(back, aside, -0.45 * kHead));
  sheet.add(std::move(arrow), {kDark, 1.5, false, {}});
  const Point label = offset(tip, direction, 10);
  sheet.add(Text{{label.x, label.y + 4.5}, name, 13, Anchor::middle, kDark, true});
}

// Where the view is empty: a long part leaves the lower left corner free, a deep one the upper
// left.
void draw_triad(DisplayList& sheet, const View& view, const Box3& box) {
  const Rect& frame = view.frame();
  const bool lower = box.size()[kX] >= box.size()[kY];
  const Point origin{frame.left + 30, lower ? frame.bottom() - 44 : frame.top + 66};
  draw_arrow(sheet, origin, {kCos30, 0.5}, "X");
  draw_arrow(sheet, origin, {kCos30, -0.5}, "Y");
  draw_arrow(sheet, origin, {0, -1}, "Z");
}

}  // namespace

Look draw_iso(DisplayList& sheet, const View& view, const Subject& subject) {
  LabelPlacer labels(view.frame().shrunk(3));
  const Box3& box = subject.box;
  const std::array<Edge, 3> edges = ruled_edges(box);
  std::array<std::vector<Tick>, 3> ticks;
  for (const auto& edge : edges) {
    const std::size_t i = edge.axis;
    if (box.size()[i] * view.scale() < kShortestEdge) continue;
    ticks[i] = ruler(box.low()[i], box.high()[i], edge.min_step / view.scale(),
                     i == kX ? subject.x_factor() : 1);
    if (i != kZ) draw_floor(sheet, view, box, edge, ticks[i]);
  }
  draw_box(sheet, view, box);
  const Look look = draw_path(sheet, view, subject, Shading::Order::back_to_front);
  for (const auto& edge : edges) {
    if (!ticks[edge.axis].empty()) draw_edge(sheet, view, box, edge, ticks[edge.axis], labels);
  }
  draw_ends(sheet, view, subject, labels);
  draw_tool_labels(sheet, view, subject, labels);
  draw_triad(sheet, view, box);
  return look;
}

}  // namespace kerf::output::plot
