#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "output/picture/drawing/display_list.hpp"
#include "output/picture/drawing/view.hpp"
#include "output/picture/internal/cut_scale.hpp"
#include "output/picture/internal/path_store.hpp"
#include "output/picture/internal/segment_set.hpp"

namespace kerf::output::plot {

/// Brings a path with values onto the sheet: an outline for each shade, clipped to the view's
/// frame. Between two vertices the shade changes where the value, which goes linearly with the way,
/// leaves it. Of lines of one shade that coincide, only the first is drawn.
///
/// A place of a lower shade than before and behind it, slower or with more energy, shows however
/// short it is: as a dot, when it is shorter than kDot pixels.
class CutTracer {
 public:
  CutTracer(const View& view, const Path& path, const CutScale& scale);

  /// By shade.
  [[nodiscard]] std::vector<Outline>& lines() { return lines_; }
  [[nodiscard]] std::vector<Outline>& dots() { return dots_; }

  [[nodiscard]] const CutScale& scale() const { return scale_; }
  [[nodiscard]] std::size_t point_count() const;

  static constexpr double kDot = 3;

 private:
  /// A part of a stroke in one shade, on the sheet.
  struct Run {
    std::size_t shade = 0;
    std::vector<Point> points;
  };

  void trace(std::span<const Path::Vertex> stroke);
  void split(const Path::Vertex& from, const Path::Vertex& to);
  void piece(Point from, Point to, std::size_t shade);
  void draw(std::vector<Run> runs);
  void draw_line(const Run& run);
  void draw_dot(const Run& run);

  const View& view_;
  CutScale scale_;
  std::vector<Run> runs_;  // of the stroke under way
  SegmentSet seen_;
  std::vector<Outline> lines_, dots_;
};

}  // namespace kerf::output::plot
