#include "output/internal/plot/path_painter.hpp"

#include <cmath>

#include "output/internal/plot/palette.hpp"
#include "output/internal/plot/segment_set.hpp"
#include "output/internal/plot/text.hpp"

namespace kerf::output::plot {
namespace {

constexpr double kSameInk = 0.25;  // pixels: lines whose ends are that close are drawn once
constexpr double kNoStep = 0.05;   // pixels: corners closer to each other are drawn as one

double distance(Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); }
Point3 on_paper(Point p) { return {p.x, p.y, 0}; }

// An outline under construction, with its length and extents.
struct Trail {
  Outline outline;
  double length = 0;
  Box3 extents;

  void line(Point from, Point to) {
    reach(from, to);
    outline.line_to(to);
  }
  void curve(Point from, Point control1, Point control2, Point to) {
    reach(from, to);
    outline.curve_to(control1, control2, to);
  }

 private:
  void reach(Point from, Point to) {
    if (outline.empty() || outline.points.back() != from) outline.move_to(from);
    length += distance(from, to);
    extents.add(on_paper(from));
    extents.add(on_paper(to));
  }
};

// Turns the strokes of the path into one trail for travelling and one for each tool.
class Tracer {
 public:
  Tracer(const View& view, const Subject& subject)
      : view_(view), path_(subject.path), cuts_(subject.tool_color.size()) {
    seen_.clear(kSameInk);
    for (std::size_t i = 0; i < path_.strokes.size(); ++i) {
      if (path_.strokes[i].pen.trace == Trace::cut) {
        cut(i);
      } else {
        travel(i);
      }
    }
  }

  [[nodiscard]] Trail& travels() { return travels_; }
  [[nodiscard]] std::vector<Trail>& cuts() { return cuts_; }

 private:
  void cut(std::size_t stroke) {
    const auto vertices = path_.vertices_of(stroke);
    const std::uint32_t tool = path_.strokes[stroke].pen.tool;
    Trail& trail = cuts_[tool];
    Point at = view_.map(vertices.front().at);
    for (std::size_t i = 1; i < vertices.size(); ++i) {
      if (vertices[i].arc != Path::kNoArc) {
        at = cut_arc(trail, tool, at, path_.arcs[vertices[i].arc]);
        continue;
      }
      const Point to = view_.map(vertices[i].at);
      const bool last = i + 1 == vertices.size();
      if (!last && distance(at, to) < kNoStep) continue;
      if (seen_.insert(on_paper(at), on_paper(to), tool)) trail.line(at, to);
      at = to;
    }
  }

  Point cut_arc(Trail& trail, std::uint32_t tool, Point at, const ArcPath& arc) {
    constexpr std::uint32_t kCurve = 0x10000;
    for (std::size_t i = 0; i < arc.span_count(); ++i) {
      const Bezier span = arc.span(i);
      const Point control1 = view_.map(span.control1), control2 = view_.map(span.control2);
      const Point to = view_.map(span.to);
      if (seen_.insert(on_paper(control1), on_paper(control2), tool | kCurve)) {
        trail.curve(at, control1, control2, to);
      }
      at = to;
    }
    return at;
  }

  // The beam of a laser may be off in an arc: those are chords, fine enough for thin dashes.
  void travel(std::size_t stroke) {
    const auto vertices = path_.vertices_of(stroke);
    Point at = view_.map(vertices.front().at);
    for (const Path::Vertex& vertex : vertices.subspan(1)) {
      const bool straight = vertex.arc == Path::kNoArc;
      const std::size_t chords = straight ? 1 : 8 * path_.arcs[vertex.arc].span_count();
      for (std::size_t i = 1; i <= chords; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(chords);
        const Point to = view_.map(straight ? vertex.at : path_.arcs[vertex.arc].at(t));
        travel_line(at, to);
        at = to;
      }
    }
  }

  void travel_line(Point from, Point to) {
    const auto part = clipped(from, to, view_.frame());
    if (!part || distance(part->first, part->second) < kNoStep) return;
    constexpr std::uint32_t kTravel = 0x20000;
    if (!seen_.insert(on_paper(part->first), on_paper(part->second), kTravel)) return;
    travels_.line(part->first, part->second);
  }

  const View& view_;
  const Path& path_;
  SegmentSet seen_;
  Trail travels_;
  std::vector<Trail> cuts_;
};

// Lines whose width is `share` of their mean distance, within limits.
double width_for(double length, const Box3& extents, double share, double thinnest, double widest) {
  if (extents.empty() || length == 0) return widest;
  constexpr double kNarrow = 40;  // pixels: a single line is not dense
  const double area = std::max(extents.size()[0], kNarrow) * std::max(extents.size()[1], kNarrow);
  return std::clamp(share * area / length, thinnest, widest);
}

double cut_width(const std::vector<Trail>& trails) {
  double length = 0;
  Box3 extents;
  for (const Trail& trail : trails) {
    length += trail.length;
    if (trail.extents.empty()) continue;
    extents.add(trail.extents.low());
    extents.add(trail.extents.high());
  }
  return width_for(length, extents, 0.4, 0.35, 1.6);
}

constexpr double kMarkSize = 6;  // pixels from the middle
constexpr double kLabelSize = 12;

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
  sheet.add(Text{{plate.center().x, plate.bottom() - 4}, name, kLabelSize, Anchor::middle, kDark});
}

}  // namespace

void draw_path(DisplayList& sheet, const View& view, const Subject& subject) {
  Tracer tracer(view, subject);
  Trail& travels = tracer.travels();
  const double travel_width = width_for(travels.length, travels.extents, 0.08, 0.4, 0.9);
  sheet.add(std::move(travels.outline), {kTravel, travel_width, true, {}});
  const double width = cut_width(tracer.cuts());
  for (std::size_t tool = 0; tool < tracer.cuts().size(); ++tool) {
    sheet.add(std::move(tracer.cuts()[tool].outline), {subject.tool_color[tool], width, false, {}});
  }
}

void draw_start_mark(DisplayList& sheet, Point at) {
  Outline triangle;
  triangle.move_to({at.x - 0.7 * kMarkSize, at.y - kMarkSize});
  triangle.line_to({at.x + kMarkSize, at.y});
  triangle.line_to({at.x - 0.7 * kMarkSize, at.y + kMarkSize});
  triangle.close();
  sheet.add(std::move(triangle), {kDark, 1.4, false, kWhite});
}

void draw_end_mark(DisplayList& sheet, Point at) {
  Outline square;
  square.rectangle(around(at, 0.6 * kMarkSize));
  sheet.add(std::move(square), {kWhite, 1, false, kDark});
}

void draw_ends(DisplayList& sheet, const View& view, const Subject& subject, LabelPlacer& labels) {
  const Point start = view.map(subject.recorded.start());
  const Point end = view.map(subject.recorded.end());
  draw_start_mark(sheet, start);
  draw_end_mark(sheet, end);
  labels.reserve(around(start, kMarkSize));
  labels.reserve(around(end, kMarkSize));
}

void draw_tool_labels(DisplayList& sheet, const View& view, const Subject& subject,
                      LabelPlacer& labels) {
  constexpr std::size_t kMostLabels = 24;
  if (subject.cutters.size() < 2) return;
  for (std::size_t i = 0; i < std::min(subject.cutters.size(), kMostLabels); ++i) {
    const std::size_t tool = subject.cutters[i];
    const Point cut = view.map(subject.recorded.tools()[tool].first_cut);
    const std::string name = subject.tool_name(tool);
    const double width = text_width(name, kLabelSize) + 8;
    const auto plate = labels.place(cut, width, kLabelSize + 5, 8);
    if (plate) draw_plate(sheet, *plate, cut, name, subject.tool_color[tool]);
  }
}

}  // namespace kerf::output::plot
