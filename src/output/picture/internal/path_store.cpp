#include "output/picture/internal/path_store.hpp"

#include <utility>

namespace kerf::output::plot {
namespace {

// A Bezier curve takes three points to draw.
std::size_t cost_of(const ArcPath& arc) { return 3 * arc.span_count(); }

Knot chord_end(const ArcPath& arc, std::size_t number, std::size_t count) {
  return knot(arc.at(static_cast<double>(number) / static_cast<double>(count)), 0);
}

Knot knot_of(const Path::Vertex& vertex) {
  return knot(vertex.at, static_cast<double>(vertex.value));
}

Path::Vertex vertex_of(const Knot& knot, std::uint32_t arc) {
  return {place_of(knot), static_cast<float>(knot[kValue]), arc};
}

double largest_extent(const Path& path) {
  Box3 cuts, all;
  for (std::size_t i = 0; i < path.strokes.size(); ++i) {
    for (const Path::Vertex& vertex : path.vertices_of(i)) {
      Box3& box = path.strokes[i].pen.trace == Trace::cut ? cuts : all;
      if (vertex.arc != Path::kNoArc) path.arcs[vertex.arc].extend(box);
      box.add(vertex.at);
    }
  }
  return (cuts.empty() ? all : cuts).largest_side();
}

}  // namespace

std::span<const Path::Vertex> Path::vertices_of(std::size_t stroke) const {
  const std::size_t first = strokes[stroke].first;
  const std::size_t end = stroke + 1 < strokes.size() ? strokes[stroke + 1].first : vertices.size();
  return std::span(vertices).subspan(first, end - first);
}

void PathStore::line(Pen pen, const Point3& from, const Point3& to) {
  line(pen, knot(from, 0), knot(to, 0));
}

void PathStore::line(Pen pen, const Knot& from, const Knot& to) {
  use(pen, from);
  largest_ = std::max(largest_, to[kValue]);
  if (tolerance_ > 0) {
    simplified_line(to);
  } else {
    append(to, Path::kNoArc);
  }
  if (cost_ > kBudget) coarsen();
}

void PathStore::arc(Pen pen, const ArcPath& arc) {
  const Knot from = knot(arc.from(), 0);
  use(pen, from);
  if (tolerance_ > 0) {
    const std::size_t chords = arc.chord_count(tolerance_);
    for (std::size_t i = 1; i <= chords; ++i) line(pen, from, chord_end(arc, i, chords));
    return;
  }
  path_.arcs.push_back(arc);
  append(knot(arc.to(), 0), static_cast<std::uint32_t>(path_.arcs.size() - 1));
  cost_ += cost_of(arc);
  if (cost_ > kBudget) coarsen();
}

Path PathStore::path() const {
  PathStore copy = *this;
  copy.finish_stroke();
  return std::move(copy.path_);
}

void PathStore::use(Pen pen, const Knot& from) {
  if (begun_ && pen == pen_) return;
  finish_stroke();
  begin(pen, from);
}

void PathStore::lift() {
  if (begun_) finish_stroke();
  begun_ = false;
}

void PathStore::begin(Pen pen, const Knot& from) {
  begun_ = true;
  pen_ = pen;
  tail_ = from;
  stroke_open_ = false;
  sleeve_.start(from);
}

void PathStore::finish_stroke() {
  if (tolerance_ > 0 && sleeve_.end() != tail_) keep(sleeve_.end());
}

void PathStore::simplified_line(const Knot& to) {
  if (sleeve_.add(to)) keep(sleeve_.anchor());
}

// A segment seen before leaves a gap between strokes, which the segment seen before closes.
void PathStore::keep(const Knot& to) {
  if (seen_.insert(place_of(tail_), place_of(to), label_of(tail_, to))) {
    append(to, Path::kNoArc);
  } else {
    stroke_open_ = false;
  }
  tail_ = to;
}

// The pen and, as fine as they are kept, the values, without regard to direction.
std::uint32_t PathStore::label_of(const Knot& from, const Knot& to) const {
  constexpr std::uint32_t kPens = 0x20000;
  const double value = (from[kValue] + to[kValue]) / (2 * value_tolerance_);
  const auto level = static_cast<std::uint32_t>(std::min(value, 30'000.0));
  return level * kPens + pen_.tool * 2U + static_cast<std::uint32_t>(pen_.trace);
}

void PathStore::append(const Knot& to, std::uint32_t arc) {
  if (!stroke_open_) {
    path_.strokes.push_back({pen_, static_cast<std::uint32_t>(path_.vertices.size())});
    path_.vertices.push_back(vertex_of(tail_, Path::kNoArc));
    ++cost_;
    stroke_open_ = true;
  }
  path_.vertices.push_back(vertex_of(to, arc));
  ++cost_;
  tail_ = to;
}

void PathStore::coarsen() {
  finish_stroke();
  const Path original = std::exchange(path_, {});
  const Pen pen = pen_;
  const Knot at = tail_;
  constexpr double kCoarser = 1.5;
  const double first = std::max(largest_extent(original) * kFinest, kLeastTolerance);
  const double finest_value = std::max(largest_ * kFinestValue, kLeastTolerance);
  double tolerance = tolerance_ > 0 ? tolerance_ * kCoarser : first;
  while (!rebuild(original, tolerance, finest_value * std::max(1.0, tolerance / first))) {
    tolerance *= kCoarser;
  }
  begin(pen, at);
}

// False, with the work half done, as soon as three quarters of the budget are not enough.
bool PathStore::rebuild(const Path& path, double tolerance, double value_tolerance) {
  tolerance_ = tolerance;
  value_tolerance_ = value_tolerance;
  sleeve_ = Sleeve(tolerance, value_tolerance);
  seen_.clear(2 * tolerance);
  path_ = {};
  cost_ = 0;
  for (std::size_t i = 0; i < path.strokes.size(); ++i) {
    const auto vertices = path.vertices_of(i);
    begin(path.strokes[i].pen, knot_of(vertices.front()));
    for (const Path::Vertex& vertex : vertices.subspan(1)) {
      if (!rebuild_vertex(path, vertex)) return false;
    }
    finish_stroke();
  }
  return true;
}

bool PathStore::rebuild_vertex(const Path& path, const Path::Vertex& vertex) {
  const bool straight = vertex.arc == Path::kNoArc;
  const std::size_t chords = straight ? 1 : path.arcs[vertex.arc].chord_count(tolerance_);
  for (std::size_t i = 1; i <= chords; ++i) {
    simplified_line(straight ? knot_of(vertex) : chord_end(path.arcs[vertex.arc], i, chords));
    if (cost_ > kBudget / 4 * 3) return false;
  }
  return true;
}

}  // namespace kerf::output::plot
