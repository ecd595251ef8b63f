#include "output/picture/internal/path_tracer.hpp"

#include "math/math.hpp"

namespace kerf::output::plot {
namespace {

constexpr double kSameInk = 0.25;  // pixels: lines whose ends are that close coincide
constexpr double kNoStep = 0.05;   // pixels: corners closer to each other are drawn as one

// Labels in the set of lines seen, above those of the tools.
constexpr std::uint32_t kCurve = 0x10000;
constexpr std::uint32_t kTravelLine = 0x20000;

double distance(Point a, Point b) { return math::hypot(a.x - b.x, a.y - b.y); }
Point3 on_paper(Point p) { return {p.x, p.y, 0}; }

}  // namespace

void Trail::line(Point from, Point to) {
  reach(from, to);
  outline.line_to(to);
}

void Trail::curve(Point from, Point control1, Point control2, Point to) {
  reach(from, to);
  outline.curve_to(control1, control2, to);
}

void Trail::reach(Point from, Point to) {
  if (outline.empty() || outline.points.back() != from) outline.move_to(from);
  length_ += distance(from, to);
  extents_.add(on_paper(from));
  extents_.add(on_paper(to));
}

PathTracer::PathTracer(const View& view, const Subject& subject, const Shading* shading)
    : view_(view), path_(subject.path), shading_(shading) {
  const std::size_t trails = shading ? shading->layer_count() * Shading::kShades : 1;
  cuts_.resize(subject.tool_color.size() * trails);
  seen_.clear(kSameInk);
  for (std::size_t i = 0; i < path_.strokes.size(); ++i) {
    if (path_.strokes[i].pen.trace == Trace::cut) {
      cut(i);
    } else {
      travel(i);
    }
  }
}

void PathTracer::cut(std::size_t stroke) {
  const std::uint16_t tool = path_.strokes[stroke].pen.tool;
  const auto vertices = path_.vertices_of(stroke);
  Point3 at = vertices.front().at;
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    const Path::Vertex& vertex = vertices[i];
    const std::size_t number = path_.strokes[stroke].first + i;
    const bool last = i + 1 == vertices.size() || vertices[i + 1].arc != Path::kNoArc;
    if (vertex.arc != Path::kNoArc) {
      cut_arc(tool, path_.arcs[vertex.arc], number);
    } else if (last || distance(view_.map(at), view_.map(vertex.at)) >= kNoStep) {
      cut_line(tool, at, vertex.at, number);
    } else {
      continue;
    }
    at = vertex.at;
  }
}

void PathTracer::cut_line(std::uint16_t tool, const Point3& from, const Point3& to,
                          std::size_t vertex) {
  const Point start = view_.map(from), end = view_.map(to);
  if (!seen_.insert(on_paper(start), on_paper(end), tool)) return;
  trail_for(tool, from, to, vertex).line(start, end);
}

void PathTracer::cut_arc(std::uint16_t tool, const ArcPath& arc, std::size_t vertex) {
  Point3 at = arc.from();
  for (std::size_t i = 0; i < arc.span_count(); ++i) {
    const Bezier span = arc.span(i);
    const Point control1 = view_.map(span.control1), control2 = view_.map(span.control2);
    if (seen_.insert(on_paper(control1), on_paper(control2), tool | kCurve)) {
      trail_for(tool, at, span.to, vertex)
          .curve(view_.map(at), control1, control2, view_.map(span.to));
    }
    at = span.to;
  }
}

Trail& PathTracer::trail_for(std::uint16_t tool, const Point3& from, const Point3& to,
                             std::size_t vertex) {
  if (!shading_) return cuts_[tool];
  const double progress = static_cast<double>(vertex) / static_cast<double>(path_.vertices.size());
  const std::size_t layer = tool * shading_->layer_count() + shading_->layer(from, to, progress);
  return cuts_[layer * Shading::kShades + shading_->shade(from, to)];
}

// A laser's beam may be off in an arc: that is drawn in chords, fine enough for thin dashes.
void PathTracer::travel(std::size_t stroke) {
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

void PathTracer::travel_line(Point from, Point to) {
  const auto part = clipped(from, to, view_.frame());
  if (!part || distance(part->first, part->second) < kNoStep) return;
  if (!seen_.insert(on_paper(part->first), on_paper(part->second), kTravelLine)) return;
  travels_.line(part->first, part->second);
}

}  // namespace kerf::output::plot
