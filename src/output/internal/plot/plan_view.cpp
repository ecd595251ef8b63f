#include "output/internal/plot/plan_view.hpp"

#include <algorithm>
#include <cmath>

#include "output/internal/plot/label_placer.hpp"
#include "output/internal/plot/palette.hpp"
#include "output/internal/plot/path_painter.hpp"
#include "output/internal/plot/ruler.hpp"
#include "output/internal/plot/segment_set.hpp"
#include "output/internal/plot/text.hpp"

namespace kerf::output::plot {
namespace {

constexpr double kTickText = 12;
constexpr double kLargestHole = 6, kSmallestHole = 2;  // radius of a mark, pixels

// Steps between labels that leave room for the widest of them.
double horizontal_step(const View& view, double factor) {
  const double widest = std::max(text_width(rounded(view.left_mm() * factor, 1), kTickText),
                                 text_width(rounded(view.right_mm() * factor, 1), kTickText));
  return std::max(56.0, widest + 24) / view.scale();
}

// Lines and marks of one ruler; grid lines go through the whole frame.
struct RulerInk {
  Outline grid, zero, ticks;
  void draw(DisplayList& sheet) {
    sheet.add(std::move(grid), {kGrid, 1, false, {}});
    sheet.add(std::move(zero), {kAxis, 1.4, false, {}});
    sheet.add(std::move(ticks), {kFrame, 1, false, {}});
  }
};

void draw_horizontal_ruler(DisplayList& sheet, const View& view, double factor) {
  const Rect& frame = view.frame();
  RulerInk ink;
  for (const Tick& tick :
       ruler(view.left_mm(), view.right_mm(), horizontal_step(view, factor), factor)) {
    const double x = view.x_of(tick.value);
    ink.ticks.segment({x, frame.bottom()}, {x, frame.bottom() + (tick.major ? 7 : 4)});
    if (!tick.major) continue;
    (tick.value == 0 ? ink.zero : ink.grid).segment({x, frame.top}, {x, frame.bottom()});
    sheet.add(Text{{x, frame.bottom() + 21}, tick.label, kTickText, Anchor::middle, kDark});
  }
  ink.draw(sheet);
}

void draw_vertical_ruler(DisplayList& sheet, const View& view, double factor) {
  const Rect& frame = view.frame();
  RulerInk ink;
  for (const Tick& tick : ruler(view.bottom_mm(), view.top_mm(), 48 / view.scale(), factor)) {
    const double y = view.y_of(tick.value);
    ink.ticks.segment({frame.left, y}, {frame.left - (tick.major ? 7 : 4), y});
    if (!tick.major) continue;
    (tick.value == 0 ? ink.zero : ink.grid).segment({frame.left, y}, {frame.right(), y});
    sheet.add(Text{{frame.left - 11, y + 4.3}, tick.label, kTickText, Anchor::end, kDark});
  }
  ink.draw(sheet);
}

void draw_axis_names(DisplayList& sheet, const Rect& frame, const std::string& horizontal,
                     const std::string& vertical) {
  sheet.add(Text{{frame.right(), frame.bottom() + 40}, horizontal, 13, Anchor::end, kDark, true});
  sheet.add(Text{{frame.left - 11, frame.top - 10}, vertical, 13, Anchor::end, kDark, true});
}

void add_hole(Outline& outline, Point at, double radius) {
  const double arm = 1.5 * radius;
  outline.circle(at, radius);
  outline.segment({at.x - arm, at.y}, {at.x + arm, at.y});
  outline.segment({at.x, at.y - arm}, {at.x, at.y + arm});
}

// Marks that would lie on one another are drawn once, and marks shrink where holes are close.
std::vector<Hole> holes_apart(const View& view, const Subject& subject) {
  SegmentSet seen;
  seen.clear(2 * kSmallestHole);
  std::vector<Hole> apart;
  for (const Hole& hole : subject.recorded.hole_finder().holes()) {
    const Point at = view.map({hole.x, hole.y, 0});
    if (seen.insert({at.x, at.y, 0}, {}, 0)) apart.push_back(hole);
  }
  return apart;
}

// Smallest distance between two points: neighbours along x are looked at up to the best one so far.
double smallest_distance(std::vector<Point> points, double at_most) {
  std::ranges::sort(points, {}, [](Point p) { return std::pair(p.x, p.y); });
  double best = at_most;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size() && points[j].x - points[i].x < best; ++j) {
      best = std::min(best, std::hypot(points[j].x - points[i].x, points[j].y - points[i].y));
    }
  }
  return best;
}

void draw_holes(DisplayList& sheet, const View& view, const Subject& subject) {
  const std::vector<Hole> holes = holes_apart(view, subject);
  std::vector<Point> middles;
  for (const Hole& hole : holes) middles.push_back(view.map({hole.x, hole.y, 0}));
  const double room = smallest_distance(middles, 4 * kLargestHole);
  const double radius = std::clamp(room / 3.5, kSmallestHole, kLargestHole);
  std::vector<Outline> by_tool(subject.tool_color.size());
  for (std::size_t i = 0; i < holes.size(); ++i) {
    add_hole(by_tool[holes[i].tool], middles[i], radius);
  }
  for (std::size_t tool = 0; tool < by_tool.size(); ++tool) {
    sheet.add(std::move(by_tool[tool]), {subject.tool_color[tool], radius / 4.5, false, {}});
  }
}

}  // namespace

void draw_plan(DisplayList& sheet, const View& view, const Subject& subject) {
  const Rect& frame = view.frame();
  const bool from_above = subject.recorded.has_y();
  draw_horizontal_ruler(sheet, view, from_above ? subject.x_factor() : 1);
  draw_vertical_ruler(sheet, view, from_above ? 1 : subject.x_factor());
  Outline border;
  border.rectangle(frame);
  sheet.add(std::move(border), {kFrame, 1, false, {}});
  const std::string diameter = subject.x_factor() == 1 ? "" : "\u2300 ";
  draw_axis_names(sheet, frame, from_above ? "X mm" : "Z mm",
                  from_above ? "Y mm" : "X " + diameter + "mm");
  LabelPlacer labels(frame.shrunk(3));
  draw_path(sheet, view, subject);
  if (from_above) draw_holes(sheet, view, subject);
  draw_ends(sheet, view, subject, labels);
  draw_tool_labels(sheet, view, subject, labels);
}

void draw_hole_mark(DisplayList& sheet, Point at) {
  Outline outline;
  add_hole(outline, at, kLargestHole);
  sheet.add(std::move(outline), {kDark, 1.4, false, {}});
}

}  // namespace kerf::output::plot
