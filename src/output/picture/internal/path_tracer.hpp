#pragma once

#include <cstdint>
#include <vector>

#include "output/picture/drawing/display_list.hpp"
#include "output/picture/drawing/view.hpp"
#include "output/picture/internal/segment_set.hpp"
#include "output/picture/internal/shading.hpp"
#include "output/picture/internal/subject.hpp"

namespace kerf::output::plot {

/// Lines on the sheet that are drawn alike, with their length and extents in pixels.
class Trail {
 public:
  void line(Point from, Point to);
  void curve(Point from, Point control1, Point control2, Point to);

  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] const Box3& extents() const { return extents_; }
  Outline outline;

 private:
  void reach(Point from, Point to);
  double length_ = 0;
  Box3 extents_;
};

/// Brings a path onto the sheet: one trail for all travelling, clipped to the view's frame, and one
/// for the cuts of each tool; with shading, one for each tool, layer and shade. Of lines of one
/// tool that coincide, only the first is drawn.
class PathTracer {
 public:
  PathTracer(const View& view, const Subject& subject, const Shading* shading = nullptr);

  [[nodiscard]] Trail& travels() { return travels_; }
  /// Tool by tool; of each its layers, of each layer its shades.
  [[nodiscard]] std::vector<Trail>& cuts() { return cuts_; }

 private:
  void travel(std::size_t stroke);
  void travel_line(Point from, Point to);
  void cut(std::size_t stroke);
  void cut_line(std::uint16_t tool, const Point3& from, const Point3& to, std::size_t vertex);
  void cut_arc(std::uint16_t tool, const ArcPath& arc, std::size_t vertex);
  Trail& trail_for(std::uint16_t tool, const Point3& from, const Point3& to, std::size_t vertex);

  const View& view_;
  const Path& path_;
  const Shading* shading_;
  SegmentSet seen_;
  Trail travels_;
  std::vector<Trail> cuts_;
};

}  // namespace kerf::output::plot
