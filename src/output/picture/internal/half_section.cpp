#include "output/picture/internal/half_section.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "output/picture/drawing/label_placer.hpp"
#include "output/picture/drawing/palette.hpp"
#include "output/picture/internal/marks.hpp"
#include "output/picture/internal/path_painter.hpp"
#include "output/picture/internal/plan_view.hpp"
#include "output/picture/internal/sleeve.hpp"
#include "output/picture/internal/turned_profile.hpp"

namespace kerf::output::plot {
namespace {

constexpr Color kPart{240, 243, 246}, kSection{222, 229, 236}, kHatch{150, 165, 180};
constexpr double kColumnPixels = 0.5;  // pixels
constexpr double kHatchApart = 9;      // pixels
constexpr double kFinestLead = 5;      // pixels: a finer thread is only its path
constexpr double kInsertEdge = 66;     // pixels at most, and
constexpr double kInsertEdge_mm = 12;

// Above the axis of rotation, or below.
enum class Side : std::int8_t { below = -1, above = 1 };

double middle_of_turned(const std::vector<ToolWay>& ways, const Subject& subject) {
  const Box3& cuts = subject.recorded.cut_extents();
  double low = 0, high = 0;
  bool any = false;
  for (const ToolWay& way : ways) {
    if (!way.along || way.on_axis) continue;
    const auto [first, last] = std::minmax(way.first[kZ], way.last[kZ]);
    low = any ? std::min(low, first) : first;
    high = any ? std::max(high, last) : last;
    any = true;
  }
  if (any) return (low + high) / 2;
  return cuts.empty() ? 0 : (cuts.low()[kZ] + cuts.high()[kZ]) / 2;
}

/// The columns of a profile on the sheet.
class Section {
 public:
  Section(const View& view, const TurnedProfile& profile) : view_(view), profile_(profile) {}

  /// Calls `visit(first, end)` for the columns of each piece of the part.
  template <typename Visit>
  void for_pieces(Visit visit) const {
    const auto columns = profile_.columns();
    for (std::size_t i = 0; i < columns.size();) {
      std::size_t end = i;
      while (end < columns.size() && columns[end].has_material()) ++end;
      if (end > i) visit(i, end);
      i = std::max(end, i + 1);
    }
  }

  void fill(DisplayList& sheet, Side side, Color color) const {
    Outline area;
    for_pieces([&](std::size_t first, std::size_t end) {
      const auto outer = contour(first, end, side, &TurnedProfile::Column::outer);
      const auto inner = contour(first, end, side, &TurnedProfile::Column::inner);
      area.move_to(outer.front());
      for (std::size_t i = 1; i < outer.size(); ++i) area.line_to(outer[i]);
      for (std::size_t i = inner.size(); i-- > 0;) area.line_to(inner[i]);
      area.close();
    });
    sheet.add(std::move(area), {{}, 1, false, color});
  }

  void outline(DisplayList& sheet, Side side, const Ink& ink) const {
    Outline lines;
    for_pieces([&](std::size_t first, std::size_t end) {
      const auto outer = contour(first, end, side, &TurnedProfile::Column::outer);
      const auto inner = contour(first, end, side, &TurnedProfile::Column::inner);
      lines.move_to(inner.front());
      for (const Point& point : outer) lines.line_to(point);
      lines.line_to(inner.back());
      for (std::size_t i = inner.size() - 1; has_bore(first, end) && i-- > 0;)
        lines.line_to(inner[i]);
    });
    sheet.add(std::move(lines), ink);
  }

  // Lines that fall to the right, where they are inside of the part.
  void hatch(DisplayList& sheet, const Ink& ink) const {
    const Rect& frame = view_.frame();
    Outline lines;
    for (double c = view_.y_of(0) - frame.width; c < frame.bottom(); c += kHatchApart)
      hatch_line(lines, c);
    sheet.add(std::move(lines), ink);
  }

 private:
  using Radius = double TurnedProfile::Column::*;

  // Stock around a bore may be wider than the frame.
  [[nodiscard]] Point at(std::size_t column, Side side, Radius radius) const {
    const double x = profile_.columns()[column].*radius * static_cast<double>(side);
    const Rect& frame = view_.frame();
    return {view_.x_of(profile_.z_of(column)),
            std::clamp(view_.y_of(x), frame.top, frame.bottom())};
  }

  [[nodiscard]] bool has_bore(std::size_t first, std::size_t end) const {
    const auto piece = profile_.columns().subspan(first, end - first);
    return std::ranges::any_of(piece, [](const auto& column) { return column.inner > 0; });
  }

  // Without the points that a straight line hides.
  [[nodiscard]] std::vector<Point> contour(std::size_t first, std::size_t end, Side side,
                                           Radius radius) const {
    constexpr double kHidden = 0.1;  // pixels
    const auto knot_of = [&](std::size_t column) {
      const Point point = at(column, side, radius);
      return knot({point.x, point.y, 0}, 0);
    };
    Sleeve sleeve(kHidden, kHidden);
    std::vector<Point> points{at(first, side, radius)};
    sleeve.start(knot_of(first));
    for (std::size_t i = first + 1; i < end; ++i) {
      if (sleeve.add(knot_of(i))) points.push_back({sleeve.anchor()[kX], sleeve.anchor()[kY]});
    }
    points.push_back({sleeve.end()[kX], sleeve.end()[kY]});
    return points;
  }

  void hatch_line(Outline& lines, double c) const {
    const double left = view_.frame().left, axis = view_.y_of(0);
    Point begin;
    Point last;
    bool is_inside = false;
    for (std::size_t i = 0; i < profile_.columns().size(); ++i) {
      const TurnedProfile::Column& column = profile_.columns()[i];
      const double x = view_.x_of(profile_.z_of(i)), y = c + x - left;
      const double r = (y - axis) / view_.scale();
      const bool inside = column.has_material() && r > column.inner && r < column.outer &&
                          y < view_.frame().bottom();
      if (inside && !is_inside) begin = {x, y};
      if (!inside && is_inside) lines.segment(begin, last);
      is_inside = inside;
      last = {x, y};
    }
    if (is_inside) lines.segment(begin, last);
  }

  const View& view_;
  const TurnedProfile& profile_;
};

TurnedProfile profile_of(const View& view, const Subject& subject, const Turning& turning) {
  const auto columns = static_cast<std::size_t>(view.frame().width / kColumnPixels);
  TurnedProfile profile(subject.path, turning.inserts, view.left_mm(), view.right_mm(), columns);
  for (const ThreadCut& thread : turning.recorded.threads()) {
    if (thread.lead * view.scale() >= kFinestLead) profile.cut_thread(thread);
  }
  return profile;
}

void draw_axis_of_rotation(DisplayList& sheet, const View& view) {
  constexpr std::array<double, 4> kDashDot{22, 5, 3, 5};
  const double y = view.y_of(0), right = view.frame().right();
  Outline line;
  std::size_t part = 0;
  for (double x = view.frame().left; x < right; part = (part + 1) % kDashDot.size()) {
    const double end = std::min(x + kDashDot[part], right);
    if (part % 2 == 0) line.segment({x, y}, {end, y});
    x = end;
  }
  sheet.add(std::move(line), {kDark, 1, false, {}});
}

// Of an outer thread what one sees of its turns from the side.
void draw_turns(DisplayList& sheet, const View& view, const ThreadCut& thread, const Ink& ink,
                const TurnedProfile& profile) {
  const double step = view.scale() * thread.lead;
  const auto every = static_cast<int>(std::max(1.0, std::ceil(kFinestLead / step)));
  const double way = thread.to[kZ] - thread.from[kZ];
  const auto turns = static_cast<int>(std::min(std::abs(way) / thread.lead, 1e4));
  const double left = profile.z_of(0), wide = profile.z_of(1) - left;
  Outline lines;
  for (int n = 0; n <= turns; n += every) {
    const double z = thread.from[kZ] + (way < 0 ? -n : n) * thread.lead;
    const double r = std::abs(thread.from[kX] + (thread.to[kX] - thread.from[kX]) * n / turns);
    const auto column = static_cast<std::int64_t>((z - left) / wide);
    if (column < 0 || column >= static_cast<std::int64_t>(profile.columns().size())) continue;
    const TurnedProfile::Column& part = profile.columns()[static_cast<std::size_t>(column)];
    if (!part.has_material() || r < (part.inner + part.outer) / 2) continue;
    lines.segment({view.x_of(z), view.y_of(r)}, {view.x_of(z - thread.lead / 4), view.y_of(0)});
  }
  sheet.add(std::move(lines), ink);
}

void draw_threads(DisplayList& sheet, const View& view, const Subject& subject,
                  const Turning& turning, const TurnedProfile& profile) {
  for (const ThreadCut& thread : turning.recorded.threads()) {
    const auto is_thread = [&](std::size_t pen) { return subject.recorded.tools()[pen].thread; };
    const auto pen = std::ranges::find_if(subject.cutters, is_thread);
    const Color color = pen == subject.cutters.end() ? kSoft : subject.tool_color[*pen];
    draw_turns(sheet, view, thread, {color, 0.7, false, {}}, profile);
  }
}

// Lighter, as ink on the sheet has no transparency.
Color tinted(Color color) {
  const auto lighter = [](std::uint8_t part) {
    return static_cast<std::uint8_t>(255 - (255 - part) / 4);
  };
  return {lighter(color.red), lighter(color.green), lighter(color.blue)};
}

struct Placed {
  Outline outline;
  Rect room;
};

// What of a convex shape lies below a line of the sheet: an insert is longer than the frame is
// high.
std::vector<Point> below(double top, const std::vector<Point>& shape) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const Point& a = shape[i];
    const Point& b = shape[(i + 1) % shape.size()];
    if (a.y >= top) kept.push_back(a);
    if ((a.y < top) == (b.y < top)) continue;
    kept.push_back({a.x + (b.x - a.x) * (top - a.y) / (b.y - a.y), top});
  }
  return kept;
}

Placed placed(const View& view, const std::vector<geometry::Vec2>& shape, const Point3& tip) {
  std::vector<Point> points;
  for (const geometry::Vec2& corner : shape)
    points.push_back({view.x_of(tip[kZ] + corner.u), view.y_of(tip[kX] + corner.v)});
  Placed at;
  Box3 box;
  for (const Point& point : below(view.frame().top, points)) {
    box.empty() ? at.outline.move_to(point) : at.outline.line_to(point);
    box.add({point.x, point.y, 0});
  }
  at.outline.close();
  at.room = {box.low()[0], box.low()[1], box.size()[0], box.size()[1]};
  return at;
}

// Where its last cut ends, unless another insert is there: then where its first one begins, or half
// way.
Placed place_for(const View& view, const std::vector<geometry::Vec2>& shape, const ToolWay& way,
                 LabelPlacer& taken) {
  for (const Point3& tip : {way.last, way.first, way.middle}) {
    Placed at = placed(view, shape, tip);
    if (taken.claim(at.room)) return at;
  }
  return placed(view, shape, way.last);
}

void draw_inserts(DisplayList& sheet, const View& view, const Subject& subject,
                  const Turning& turning, LabelPlacer& taken) {
  const double edge_mm = std::min(kInsertEdge_mm, kInsertEdge / view.scale());
  for (const std::size_t pen : subject.cutters) {
    const auto shape = turning.inserts[pen].outline(edge_mm);
    Placed at = place_for(view, shape, turning.ways[pen], taken);
    const Color color = subject.tool_color[pen];
    sheet.add(std::move(at.outline), {color, 1.4, false, tinted(color)});
    const std::uint32_t number = subject.recorded.tools()[pen].number;
    if (number == 0) continue;
    const Point middle = at.room.center();
    const std::string name = "T" + std::to_string(number);
    sheet.add(Text{{middle.x, middle.y + 4}, name, 12, Anchor::middle, kDark, true});
  }
}

}  // namespace

Turning::Turning(const Subject& subject, const TurningRecorder& recorder)
    : recorded(recorder), ways(ways_of(subject.path, subject.recorded.tools().size())) {
  const double middle_mm = middle_of_turned(ways, subject);
  for (std::size_t pen = 0; pen < ways.size(); ++pen) {
    const Tool& tool = subject.recorded.tools()[pen];
    inserts.push_back(insert_of(recorder.tool(tool.number), ways[pen], tool.thread, middle_mm));
  }
}

Box3 half_section_box(const Subject& subject) {
  Box3 box = subject.box;
  const double most = std::max(std::abs(box.low()[kX]), std::abs(box.high()[kX]));
  box.add({most, box.low()[kY], box.low()[kZ]});
  box.add({-most, box.low()[kY], box.low()[kZ]});
  return box;
}

void draw_half_section(DisplayList& sheet, const View& view, const Subject& subject,
                       const Turning& turning) {
  const TurnedProfile profile = profile_of(view, subject, turning);
  const Section part(view, profile);
  draw_rulers(sheet, view, {"Z mm", "X \u2300 mm", 1, subject.x_factor(), true});
  part.fill(sheet, Side::above, kPart);
  part.fill(sheet, Side::below, kSection);
  part.hatch(sheet, {kHatch, 0.8, false, {}});
  draw_threads(sheet, view, subject, turning, profile);
  part.outline(sheet, Side::above, {kFrame, 1, false, {}});
  part.outline(sheet, Side::below, {kDark, 1.6, false, {}});
  draw_axis_of_rotation(sheet, view);
  draw_path(sheet, view, subject, Shading::Order::in_time);
  LabelPlacer taken(view.frame());
  draw_inserts(sheet, view, subject, turning, taken);
  draw_ends(sheet, view, subject, taken);
}

void draw_section_sample(DisplayList& sheet, const Rect& at) {
  Outline box, lines;
  box.rectangle(at);
  for (double x = 0; x < at.width; x += 6)
    lines.segment({at.left + x, at.top}, {at.left + std::min(x + at.height, at.width),
                                          at.top + std::min(at.height, at.width - x)});
  sheet.add(box, {{}, 1, false, kSection});
  sheet.add(std::move(lines), {kHatch, 0.8, false, {}});
  sheet.add(std::move(box), {kDark, 1.2, false, {}});
}

}  // namespace kerf::output::plot
