#include "output/picture/internal/plan_view.hpp"

#include <algorithm>

#include "output/picture/drawing/label_placer.hpp"
#include "output/picture/drawing/palette.hpp"
#include "output/picture/drawing/ruler.hpp"
#include "output/picture/drawing/text.hpp"
#include "output/picture/internal/marks.hpp"

namespace kerf::output::plot {
namespace {

// Marks of the horizontal ruler, labelled so far apart that no label touches the next.
std::vector<Tick> horizontal_ticks(const View& view, double factor) {
  double apart = 56;  // pixels
  while (true) {
    auto ticks = ruler(view.left_mm(), view.right_mm(), apart / view.scale(), factor);
    double widest = 0;
    for (const Tick& tick : ticks) widest = std::max(widest, text_width(tick.label, kTickText));
    if (widest + 16 <= apart) return ticks;
    apart = widest + 20;
  }
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
  for (const Tick& tick : horizontal_ticks(view, factor)) {
    const double x = view.x_of(tick.value);
    ink.ticks.segment({x, frame.bottom()}, {x, frame.bottom() + (tick.major ? 7 : 4)});
    if (!tick.major) continue;
    (tick.value == 0 ? ink.zero : ink.grid).segment({x, frame.top}, {x, frame.bottom()});
    sheet.add(Text{{x, frame.bottom() + 21}, tick.label, kTickText, Anchor::middle, kDark});
  }
  ink.draw(sheet);
}

void draw_vertical_ruler(DisplayList& sheet, const View& view, double factor, bool from_axis) {
  const Rect& frame = view.frame();
  RulerInk ink;
  for (const Tick& tick : ruler(view.bottom_mm(), view.top_mm(), 48 / view.scale(), factor)) {
    const double y = view.y_of(tick.value);
    ink.ticks.segment({frame.left, y}, {frame.left - (tick.major ? 7 : 4), y});
    if (!tick.major) continue;
    (tick.value == 0 ? ink.zero : ink.grid).segment({frame.left, y}, {frame.right(), y});
    std::string label = from_axis && tick.value < 0 ? tick.label.substr(1) : tick.label;
    sheet.add(Text{{frame.left - 11, y + 4.3}, std::move(label), kTickText, Anchor::end, kDark});
  }
  ink.draw(sheet);
}

void draw_axis_names(DisplayList& sheet, const Rect& frame, const std::string& horizontal,
                     const std::string& vertical) {
  sheet.add(Text{{frame.right(), frame.bottom() + 40}, horizontal, 13, Anchor::end, kDark, true});
  sheet.add(Text{{frame.left - 11, frame.top - 10}, vertical, 13, Anchor::end, kDark, true});
}

}  // namespace

void draw_rulers(DisplayList& sheet, const View& view, const Rulers& rulers) {
  draw_horizontal_ruler(sheet, view, rulers.horizontal_factor);
  draw_vertical_ruler(sheet, view, rulers.vertical_factor, rulers.vertical_from_axis);
  Outline border;
  border.rectangle(view.frame());
  sheet.add(std::move(border), {kFrame, 1, false, {}});
  draw_axis_names(sheet, view.frame(), rulers.horizontal, rulers.vertical);
}

Look draw_plan(DisplayList& sheet, const View& view, const Subject& subject) {
  const bool from_above = subject.recorded.has_y();
  draw_rulers(sheet, view, from_above ? Rulers{"X mm", "Y mm"} : Rulers{"Z mm", "X mm"});
  const Look look = draw_path(sheet, view, subject, Shading::Order::in_time);
  LabelPlacer labels(view.frame().shrunk(3));
  draw_ends(sheet, view, subject, labels);
  if (from_above) draw_holes(sheet, view, subject);
  draw_tool_labels(sheet, view, subject, labels);
  return look;
}

}  // namespace kerf::output::plot
