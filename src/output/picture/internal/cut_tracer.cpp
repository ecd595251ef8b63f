#include "output/picture/internal/cut_tracer.hpp"

#include <algorithm>
#include <utility>

#include "math/math.hpp"
#include "output/picture/internal/sleeve.hpp"

namespace kerf::output::plot {
namespace {

constexpr double kFlat = 0.06;      // pixels: corners off a straight line by less go
constexpr double kSameInk = 0.25;   // pixels: lines whose ends are that close coincide
constexpr double kShortest = 0.75;  // pixels: shorter runs are left to those beside them

double distance(Point a, Point b) { return math::hypot(a.x - b.x, a.y - b.y); }
Point between(Point a, Point b, double t) { return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t}; }
Knot on_paper(Point p) { return {p.x, p.y, 0, 0}; }
Point point_of(const Knot& knot) { return {knot[kX], knot[kY]}; }

double length_of(const std::vector<Point>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length += distance(points[i - 1], points[i]);
  return length;
}

std::vector<Point> simplified(const std::vector<Point>& points) {
  Sleeve sleeve(kFlat);
  sleeve.start(on_paper(points.front()));
  std::vector<Point> kept{points.front()};
  for (const Point point : points) {
    if (sleeve.add(on_paper(point))) kept.push_back(point_of(sleeve.anchor()));
  }
  kept.push_back(points.back());
  return kept;
}

}  // namespace

CutTracer::CutTracer(const View& view, const Path& path, const CutScale& scale)
    : view_(view), scale_(scale), lines_(scale.shades()), dots_(scale.shades()) {
  seen_.clear(kSameInk);
  for (std::size_t i = 0; i < path.strokes.size(); ++i) trace(path.vertices_of(i));
}

std::size_t CutTracer::point_count() const {
  std::size_t count = 0;
  for (const Outline& outline : lines_) count += outline.points.size();
  for (const Outline& outline : dots_) count += outline.points.size();
  return count;
}

void CutTracer::trace(std::span<const Path::Vertex> stroke) {
  for (std::size_t i = 1; i < stroke.size(); ++i) split(stroke[i - 1], stroke[i]);
  draw(std::exchange(runs_, {}));
}

// Shade by shade, from the one that it begins in to the one that it ends in.
void CutTracer::split(const Path::Vertex& from, const Path::Vertex& to) {
  const auto v0 = static_cast<double>(from.value), v1 = static_cast<double>(to.value);
  const Point start = view_.map(from.at), end = view_.map(to.at);
  const std::size_t last = scale_.shade(v1);
  std::size_t shade = scale_.shade(v0);
  Point at = start;
  while (shade != last) {
    const bool upward = shade < last;
    const double leave = scale_.border(upward ? shade + 1 : shade);
    const Point next = between(start, end, std::clamp((leave - v0) / (v1 - v0), 0.0, 1.0));
    piece(at, next, shade);
    at = next;
    shade = upward ? shade + 1 : shade - 1;
  }
  piece(at, end, shade);
}

void CutTracer::piece(Point from, Point to, std::size_t shade) {
  const auto part = clipped(from, to, view_.frame());
  if (!part) return;
  const auto [start, end] = *part;
  const bool goes_on = !runs_.empty() && runs_.back().points.back() == start;
  if (!goes_on || runs_.back().shade != shade) runs_.push_back({shade, {start}});
  runs_.back().points.push_back(end);
}

// A short run beside one of a lower shade is left to the run behind it, so that no gap shows. The
// first and the last one of a stroke have nothing beside them that could be lower.
void CutTracer::draw(std::vector<Run> runs) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Run& run = runs[i];
    const bool goes_on = i + 1 < runs.size() && runs[i + 1].points.front() == run.points.back();
    const bool beside_a_lower_one =
        (i > 0 && runs[i - 1].shade < run.shade) || (goes_on && runs[i + 1].shade < run.shade);
    const double length = length_of(run.points);
    if (beside_a_lower_one && length < kShortest) {
      if (goes_on) runs[i + 1].points.front() = run.points.front();
      continue;
    }
    draw_line(run);
    if (!beside_a_lower_one && runs.size() > 1 && length < kDot) draw_dot(run);
  }
}

void CutTracer::draw_line(const Run& run) {
  const std::vector<Point> points = simplified(run.points);
  Outline& outline = lines_[run.shade];
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point from = points[i - 1], to = points[i];
    const auto label = static_cast<std::uint32_t>(run.shade);
    if (!seen_.insert({from.x, from.y, 0}, {to.x, to.y, 0}, label)) continue;
    if (outline.empty() || outline.points.back() != from) outline.move_to(from);
    outline.line_to(to);
  }
}

void CutTracer::draw_dot(const Run& run) {
  const Point at = between(run.points.front(), run.points.back(), 0.5);
  const auto label = static_cast<std::uint32_t>(scale_.shades() + run.shade);
  if (seen_.insert({at.x, at.y, 0}, {at.x, at.y, 0}, label)) dots_[run.shade].segment(at, at);
}

}  // namespace kerf::output::plot
