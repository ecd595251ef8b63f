#pragma once

#include <vector>

#include "output/picture/internal/path_store.hpp"

namespace kerf::output::plot {

/// How the path of one pen cuts on a lathe: what tells of the shape of its tool. z and x in mm.
struct ToolWay {
  bool cuts = false;
  bool along = false;           ///< cuts along Z somewhere
  bool across = false;          ///< cuts along X somewhere
  bool on_axis = true;          ///< cuts nowhere but on the axis of rotation
  double outward_mm = 0;        ///< way of the rapids behind its cuts, away from the axis
  double steepest_deg = 0;      ///< steepest way down into the part, from Z; walls do not count
  std::vector<double> plunges;  ///< where it cuts straight along X: z, ascending; not all of many
  Point3 first{}, last{};       ///< where its first cut begins, its last one ends
  Point3 middle{};              ///< half way along its last cut

  /// It goes straight along X, and nowhere else.
  [[nodiscard]] bool only_plunges() const { return across && !along; }
  /// It leaves the cut towards the axis: it stands inside of a bore.
  [[nodiscard]] bool inside() const { return outward_mm < 0; }
};

/// Of every pen, by its index.
[[nodiscard]] std::vector<ToolWay> ways_of(const Path& path, std::size_t pens);

/// Calls `visit` with the ends of the lines of the path's cuts, arcs as chords within `tolerance`
/// mm: `visit(pen, from, to)`.
template <typename Visit>
void for_each_cut(const Path& path, double tolerance, Visit visit) {
  for (std::size_t i = 0; i < path.strokes.size(); ++i) {
    if (path.strokes[i].pen.trace != Trace::cut) continue;
    const auto vertices = path.vertices_of(i);
    Point3 at = vertices.front().at;
    for (const Path::Vertex& vertex : vertices.subspan(1)) {
      const bool straight = vertex.arc == Path::kNoArc;
      const std::size_t chords = straight ? 1 : path.arcs[vertex.arc].chord_count(tolerance);
      for (std::size_t n = 1; n <= chords; ++n) {
        const double t = static_cast<double>(n) / static_cast<double>(chords);
        const Point3 to = straight ? vertex.at : path.arcs[vertex.arc].at(t);
        visit(path.strokes[i].pen, at, to);
        at = to;
      }
    }
  }
}

}  // namespace kerf::output::plot
