#include "output/picture/internal/marks.hpp"

#include <algorithm>

#include "math/math.hpp"
#include "output/picture/drawing/palette.hpp"
#include "output/picture/drawing/text.hpp"
#include "output/picture/internal/segment_set.hpp"

namespace kerf::output::plot {
namespace {

// Pixels; of round marks the radius.
constexpr double kEndMark = 6;
constexpr double kHoleMark = 7, kSmallestHoleMark = 3;
constexpr double kLabelText = 12, kLabelGap = 11;
constexpr double kDotCell = 3;                // of holes in one cell, one is marked
constexpr std::size_t kMostHoleMarks = 1500;  // more are dots: they take less room in a file

Rect around(Point at, double reach) { return {at.x - reach, at.y - reach, 2 * reach, 2 * reach}; }

// A plate with the tool's number in the frame of its colour, and a line to the cut.
void draw_plate(DisplayList& sheet, const Rect& plate, Point cut, const std::string& name,
                Color color) {
  Outline leader;
  leader.segment(cut, {std::clamp(cut.x, plate.left, plate.right()),
                       std::clamp(cut.y, plate.top, plate.bottom())});
  sheet.add(std::move(leader), {color, 0.8, false, {}});
  Outline outline;
  outline.rectangle(plate);
  sheet.add(std::move(outline), {color, 1.4, false, kWhite});
  sheet.add(Text{{plate.center().x, plate.bottom() - 4}, name, kLabelText, Anchor::middle, kDark});
}

void add_hole(Outline& outline, Point at, double radius) {
  const double arm = 1.5 * radius;
  outline.circle(at, radius);
  outline.segment({at.x - arm, at.y}, {at.x + arm, at.y});
  outline.segment({at.x, at.y - arm}, {at.x, at.y + arm});
}

struct HoleMark {
  Point at;
  std::uint16_t tool;
};

std::vector<HoleMark> hole_marks(const View& view, const Subject& subject) {
  SegmentSet seen;
  seen.clear(kDotCell);
  std::vector<HoleMark> marks;
  for (const Hole& hole : subject.recorded.hole_finder().holes()) {
    const Point at = view.map({hole.x, hole.y, 0});
    if (seen.insert({at.x, at.y, 0}, {}, 0)) marks.push_back({at, hole.tool});
  }
  return marks;
}

// Smallest distance between two marks, if below `at_most`: neighbours along x are looked at as far
// as the best one found.
double smallest_distance(std::vector<HoleMark> marks, double at_most) {
  std::ranges::sort(marks, {}, [](const HoleMark& m) { return std::pair(m.at.x, m.at.y); });
  double best = at_most;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const Point a = marks[i].at;
    for (std::size_t j = i + 1; j < marks.size() && marks[j].at.x - a.x < best; ++j) {
      best = std::min(best, math::hypot(marks[j].at.x - a.x, marks[j].at.y - a.y));
    }
  }
  return best;
}

}  // namespace

void draw_ends(DisplayList& sheet, const View& view, const Subject& subject, LabelPlacer& labels) {
  const Point start = view.map(subject.recorded.start());
  const Point end = view.map(subject.recorded.end());
  draw_start_mark(sheet, start);
  draw_end_mark(sheet, end);
  labels.reserve(around(start, kEndMark));
  labels.reserve(around(end, kEndMark));
}

void draw_holes(DisplayList& sheet, const View& view, const Subject& subject) {
  const std::vector<HoleMark> marks = hole_marks(view, subject);
  const double room = smallest_distance(marks, 4 * kHoleMark);
  const double radius = std::min(room / 3.5, kHoleMark);
  const bool dots = radius < kSmallestHoleMark || marks.size() > kMostHoleMarks;
  std::vector<Outline> by_tool(subject.tool_color.size());
  for (const HoleMark& mark : marks) {
    if (dots) {
      by_tool[mark.tool].segment(mark.at, mark.at);
    } else {
      add_hole(by_tool[mark.tool], mark.at, radius);
    }
  }
  const double width = dots ? std::clamp(0.5 * room, 2.0, 4.0) : radius / 4.5;
  for (std::size_t tool = 0; tool < by_tool.size(); ++tool) {
    sheet.add(std::move(by_tool[tool]), {subject.tool_color[tool], width, false, {}});
  }
}

void draw_tool_labels(DisplayList& sheet, const View& view, const Subject& subject,
                      LabelPlacer& labels) {
  constexpr std::size_t kMostLabels = 24;
  if (subject.cutters.size() < 2) return;
  for (std::size_t i = 0; i < std::min(subject.cutters.size(), kMostLabels); ++i) {
    const std::size_t tool = subject.cutters[i];
    const Point cut = view.map(subject.recorded.tools()[tool].first_cut);
    const std::string name = subject.tool_name(tool);
    const double width = text_width(name, kLabelText) + 8;
    const auto plate = labels.place(cut, width, kLabelText + 5, kLabelGap);
    if (plate) draw_plate(sheet, *plate, cut, name, subject.tool_color[tool]);
  }
}

void draw_start_mark(DisplayList& sheet, Point at) {
  Outline triangle;
  triangle.move_to({at.x - 0.7 * kEndMark, at.y - kEndMark});
  triangle.line_to({at.x + kEndMark, at.y});
  triangle.line_to({at.x - 0.7 * kEndMark, at.y + kEndMark});
  triangle.close();
  sheet.add(std::move(triangle), {kDark, 1.4, false, kWhite});
}

void draw_end_mark(DisplayList& sheet, Point at) {
  Outline square;
  square.rectangle(around(at, 0.6 * kEndMark));
  sheet.add(std::move(square), {kWhite, 1, false, kDark});
}

void draw_hole_mark(DisplayList& sheet, Point at) {
  Outline outline;
  add_hole(outline, at, kHoleMark);
  sheet.add(std::move(outline), {kDark, 1.4, false, {}});
}

}  // namespace kerf::output::plot
