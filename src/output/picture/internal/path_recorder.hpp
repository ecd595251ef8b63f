#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"
#include "output/picture/drawing/space.hpp"
#include "output/picture/internal/hole_finder.hpp"
#include "output/picture/internal/path_store.hpp"
#include "output/picture/tip_in_space.hpp"

namespace kerf::output::plot {

/// What the picture says of one tool.
struct Tool {
  std::uint32_t number = 0;  ///< 0: no tool was called yet
  bool thread = false;       ///< of a lathe: the threads that it cuts, told beside its other cuts
  bool cuts = false;
  Point3 first_cut{};  ///< where its first cut starts; when it cuts
};

/// Takes motions and keeps what the picture needs of them: the path, holes, tools and extents.
/// Starts where the axes start. Bounded memory; about 20 ns for a short line.
class PathRecorder {
 public:
  explicit PathRecorder(const motion::AxisSetup& axes);

  void take(const motion::Motion& motion);
  /// A place on the way of the next move, a rapid.
  void travel_through(const base::TipPoint& place);

  [[nodiscard]] const PathStore& store() const { return store_; }
  [[nodiscard]] const HoleFinder& hole_finder() const { return holes_; }
  /// By the index of Pen and Hole, in order of first use. More than kMaxTools share the last one.
  [[nodiscard]] std::span<const Tool> tools() const { return tools_; }
  [[nodiscard]] const Tool& tool() const { return tools_[tool_]; }  ///< at work now
  [[nodiscard]] const Point3& position() const { return position_; }
  [[nodiscard]] const Box3& cut_extents() const { return cuts_; }  ///< empty without cuts
  [[nodiscard]] Box3 all_extents() const;                          ///< with the start
  [[nodiscard]] std::uint64_t move_count() const { return moves_; }
  [[nodiscard]] bool has_y() const { return space_.has(kY); }
  /// X is drawn in true shape, as a radius, and told as a diameter.
  [[nodiscard]] bool turns() const { return turns_; }
  /// Where the first cut starts and the last one ends; without cuts, the path.
  [[nodiscard]] const Point3& start() const { return first_cut_; }
  [[nodiscard]] const Point3& end() const { return cuts_.empty() ? position_ : last_cut_; }

  static constexpr std::size_t kMaxTools = 256;

 private:
  void straight(const base::TipPoint& to, Trace trace);
  void go(const base::TipPoint& to, Trace trace);
  void rapid(const motion::Rapid& rapid);
  void arc(const motion::Arc& arc);
  void space_arc(const motion::SpaceArc& arc);
  void surface_move(const motion::SurfaceMove& move);
  void chord(const Point3& to);
  void thread(const motion::Thread& thread);
  void select_tool(std::uint32_t number, bool thread = false);
  Pen pen_for(Trace trace);
  void arrive(const Point3& to, Trace trace);
  [[nodiscard]] Point3 point_of(const base::TipPoint& to) const {
    return space_.point_of(to, position_);
  }
  [[nodiscard]] bool can_bend(const motion::Arc& arc) const;
  [[nodiscard]] Trace at_feed() const { return beam_off_ ? Trace::travel : Trace::cut; }

  const motion::AxisSetup& axes_;
  bool turns_;
  base::TipPoint tip_;  // where the last motion ended
  TipInSpace space_;
  Point3 position_{};
  Trace last_ = Trace::travel;
  bool beam_off_ = false;  // known only on machines that have a beam
  std::uint16_t tool_ = 0;
  std::vector<Tool> tools_{Tool{}};
  PathStore store_;
  HoleFinder holes_;
  Box3 cuts_, travels_;
  Point3 first_cut_{}, last_cut_{};
  std::uint64_t moves_ = 0;
};

}  // namespace kerf::output::plot
