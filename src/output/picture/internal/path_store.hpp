#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "output/picture/drawing/space.hpp"
#include "output/picture/internal/arc_path.hpp"
#include "output/picture/internal/knot.hpp"
#include "output/picture/internal/segment_set.hpp"
#include "output/picture/internal/sleeve.hpp"

namespace kerf::output::plot {

/// Whether the tool cut or only travelled: rapids, probing, a laser with its beam off.
enum class Trace : std::uint8_t { travel, cut };

/// What a part of the path is drawn with.
struct Pen {
  Trace trace = Trace::travel;
  std::uint16_t tool = 0;  ///< index of the tool, 0 when travelling
  friend bool operator==(const Pen&, const Pen&) = default;
};

/// A path as strokes of the pen, in order.
struct Path {
  static constexpr std::uint32_t kNoArc = 0xffffffffU;
  struct Vertex {
    Point3 at;
    float value = 0;             ///< of a path that was given with values: CutMeasure
    std::uint32_t arc = kNoArc;  ///< index of the arc that leads here, or kNoArc: a straight line
  };
  struct Stroke {
    Pen pen;
    std::uint32_t first = 0;  ///< vertex; the stroke ends before the next stroke's first
  };
  std::vector<Vertex> vertices;
  std::vector<ArcPath> arcs;
  std::vector<Stroke> strokes;

  [[nodiscard]] std::span<const Vertex> vertices_of(std::size_t stroke) const;
};

/// Keeps a path of any length in bounded memory.
///
/// While the path is small it is kept exactly. When it outgrows kBudget, it is simplified with a
/// tolerance of kFinest of its extents, half as much again until three quarters of the budget are
/// enough: arcs become chords, corners within the tolerance of a straight line go (Sleeve), and so
/// do segments that repeat an earlier one of the same pen within twice the tolerance (SegmentSet) -
/// a contour that is cut a million times, or hatching finer than any picture. What comes later is
/// simplified as it comes. Everything kept is a point of the true path.
///
/// Values are simplified along with the places, within kFinestValue of the largest at first and
/// coarser as the places are: between two vertices the value goes linearly with the way.
class PathStore {
 public:
  static constexpr std::size_t kBudget = 50'000;     ///< vertices
  static constexpr double kFinest = 1.0 / 8192;      ///< of the largest extent of the cuts
  static constexpr double kFinestValue = 1.0 / 128;  ///< of the largest value
  static constexpr double kLeastTolerance = 1e-6;    ///< mm
  static constexpr double kLargestCoordinate = 1e9;  ///< mm; the caller keeps within

  /// The pen moves from where it is; `from` is that place.
  void line(Pen pen, const Point3& from, const Point3& to);
  void arc(Pen pen, const ArcPath& arc);
  /// With the values at both places.
  void line(Pen pen, const Knot& from, const Knot& to);
  /// The pen leaves the path: the next line may begin anywhere.
  void lift();

  /// What was kept so far.
  [[nodiscard]] Path path() const;

  /// 0: the path is exact. Otherwise every point of the true path is, in each coordinate, within
  /// kMostOff times this of a segment kept: once by Sleeve, twice by SegmentSet, the coarsenings
  /// before add up to twice as much, and once by the chords of arcs. Nearly all are within it.
  [[nodiscard]] double tolerance() const { return tolerance_; }
  static constexpr double kMostOff = 10;

 private:
  void use(Pen pen, const Knot& from);
  void begin(Pen pen, const Knot& from);
  void finish_stroke();
  void simplified_line(const Knot& to);
  void keep(const Knot& to);
  void append(const Knot& to, std::uint32_t arc);
  void coarsen();
  bool rebuild(const Path& path, double tolerance, double value_tolerance);
  [[nodiscard]] std::uint32_t label_of(const Knot& from, const Knot& to) const;
  bool rebuild_vertex(const Path& path, const Path::Vertex& vertex);

  Path path_;
  std::size_t cost_ = 0;
  double tolerance_ = 0;
  bool begun_ = false;
  bool stroke_open_ = false;  // the last stroke of path_ ends at tail_
  Pen pen_;
  Knot tail_{};  // end of what was kept
  double largest_ = 0;
  double value_tolerance_ = 1;
  Sleeve sleeve_;
  SegmentSet seen_;
};

}  // namespace kerf::output::plot
