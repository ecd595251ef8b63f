#include "output/internal/plot/path_store.hpp"

#include <utility>

namespace kerf::output::plot {
namespace {

// A Bezier curve takes three points to draw.
std::size_t cost_of(const ArcPath& arc) { return 3 * arc.span_count(); }

Point3 chord_end(const ArcPath& arc, std::size_t number, std::size_t count) {
  return arc.at(static_cast<double>(number) / static_cast<double>(count));
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
  use(pen, from);
  if (tolerance_ > 0) {
    simplified_line(to);
  } else {
    append(to, Path::kNoArc);
  }
  if (cost_ > kBudget) coarsen();
}

void PathStore::arc(Pen pen, const ArcPath& arc) {
  use(pen, arc.from());
  if (tolerance_ > 0) {
    const std::size_t chords = arc.chord_count(tolerance_);
    for (std::size_t i = 1; i <= chords; ++i) line(pen, arc.from(), chord_end(arc, i, chords));
    return;
  }
  path_.arcs.push_back(arc);
  append(arc.to(), static_cast<std::uint32_t>(path_.arcs.size() - 1));
  cost_ += cost_of(arc);
  if (cost_ > kBudget) coarsen();
}

Path PathStore::path() const {
  PathStore copy = *this;
  copy.finish_stroke();
  return std::move(copy.path_);
}

void PathStore::use(Pen pen, const Point3& from) {
  if (begun_ && pen == pen_) return;
  finish_stroke();
  begin(pen, from);
}

void PathStore::begin(Pen pen, const Point3& from) {
  begun_ = true;
  pen_ = pen;
  tail_ = from;
  stroke_open_ = false;
  sleeve_.start(from);
}

void PathStore::finish_stroke() {
  if (tolerance_ > 0 && sleeve_.end() != tail_) keep(sleeve_.end());
}

void PathStore::simplified_line(const Point3& to) {
  if (sleeve_.add(to)) keep(sleeve_.anchor());
}

// A segment seen before leaves a gap between strokes, which the segment seen before closes.
void PathStore::keep(const Point3& to) {
  const std::uint32_t label = pen_.tool * 2U + static_cast<std::uint32_t>(pen_.trace);
  if (seen_.insert(tail_, to, label)) {
    append(to, Path::kNoArc);
  } else {
    stroke_open_ = false;
  }
  tail_ = to;
}

void PathStore::append(const Point3& to, std::uint32_t arc) {
  if (!stroke_open_) {
    path_.strokes.push_back({pen_, static_cast<std::uint32_t>(path_.vertices.size())});
    path_.vertices.push_back({tail_, Path::kNoArc});
    ++cost_;
    stroke_open_ = true;
  }
  path_.vertices.push_back({to, arc});
  ++cost_;
  tail_ = to;
}

void PathStore::coarsen() {
  finish_stroke();
  const Path original = std::exchange(path_, {});
  const Pen pen = pen_;
  const Point3 at = tail_;
  constexpr double kCoarser = 1.5;
  const double first = std::max(largest_extent(original) * kFinest, kLeastTolerance);
  double tolerance = tolerance_ > 0 ? tolerance_ * kCoarser : first;
  while (!rebuild(original, tolerance)) tolerance *= kCoarser;
  begin(pen, at);
}

// False, with the work half done, as soon as three quarters of the budget are not enough.
bool PathStore::rebuild(const Path& path, double tolerance) {
  tolerance_ = tolerance;
  sleeve_ = Sleeve(tolerance);
  seen_.clear(2 * tolerance);
  path_ = {};
  cost_ = 0;
  for (std::size_t i = 0; i < path.strokes.size(); ++i) {
    const auto vertices = path.vertices_of(i);
    begin(path.strokes[i].pen, vertices.front().at);
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
    simplified_line(straight ? vertex.at : chord_end(path.arcs[vertex.arc], i, chords));
    if (cost_ > kBudget / 4 * 3) return false;
  }
  return true;
}

}  // namespace kerf::output::plot
