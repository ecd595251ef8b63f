#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "motion/axis_norms.hpp"
#include "motion/axis_setup.hpp"
#include "motion/mark.hpp"
#include "motion/motion.hpp"
#include "motion/move_curves.hpp"
#include "motion/spindle_speeds.hpp"
#include "planner/cell_limits.hpp"
#include "planner/chain.hpp"
#include "planner/corner.hpp"
#include "planner/path.hpp"

namespace kerf::planner {

/// Turns motions into a path that the axes can follow: smooth chains of short lines, rounded
/// corners, and stops where there must be some.
///
/// It keeps back what the next motion may still change: a curve whose end may be rounded, and up to
/// some hundred short lines. Bounded memory, no allocation after the first motion.
class PathBuilder {
 public:
  /// The limits are those of the driven axes, `linkage` is null when these are the program's.
  /// Everything but the settings must outlive the builder.
  PathBuilder(const motion::AxisSetup& axes, const CellLimits& limits, const Settings& settings,
              Path& path, const Linkage* linkage = nullptr);

  /// Whether the path has room for what one more motion may add.
  [[nodiscard]] bool room() const;
  /// Adds a motion; those that move nothing are either stops or passed over. Precondition: room().
  void take(const motion::Motion& motion);
  /// The axes come to rest behind what was taken so far; nothing is kept back. Precondition:
  /// room().
  void stop();

  /// Something that was taken is not on the path yet.
  [[nodiscard]] bool keeps_back() const { return is_open_ || !chain_.empty(); }
  /// Where the last motion ended.
  [[nodiscard]] const base::TipPoint& at() const { return at_; }
  /// Forgets what it keeps back; the next motion begins at `at`.
  void clear(const base::TipPoint& at);
  /// What the operator makes of spindle speeds, > 0; feeds per revolution follow from the next
  /// motion on.
  void set_spindle_override(double factor) { spindles_.set_override(factor); }

 private:
  /// How a curve is driven.
  struct Drive {
    motion::PathSpeed speed;
    bool fixed_override = false;
    bool thread = false;
  };

  /// A curve whose end is still open.
  struct Open {
    motion::Curve curve;
    double begin = 0;  // behind the rounding of the corner before
    Drive drive;
    double begin_turn = 0;  // from the programmed line to the curve, at its begin and end
    double end_turn = 0;
    double tolerance_mm = 0;      // of a corner at its end
    std::uint64_t last_mark = 0;  // behind the marks of the curve
  };

  void add_line(const motion::Motion& motion, const base::TipPoint& to, const motion::Feed& feed);
  void add_rapid(const motion::Motion& motion, const motion::Rapid& rapid);
  void add_arc(const motion::Motion& motion, const base::TipPoint& to, const motion::Feed& feed);
  void add_surface_move(const motion::Motion& motion, const motion::SurfaceMove& move);
  [[nodiscard]] double corner_tolerance(const motion::SurfaceMove& move) const;
  void add_thread(const motion::Motion& motion, const motion::Thread& thread);
  void begin_thread(const motion::Motion& motion, const motion::Thread& thread);
  void end_thread();
  void note(const motion::SpindleTurn& turn);
  void await_spindles(const motion::Motion& motion);
  void add_curves(std::span<const motion::Curve> curves, const motion::Mark& mark_of_last,
                  const Drive& drive);
  void add_dwell(const motion::Motion& motion, double seconds);
  void drain_chain(bool ended);
  void add_piece(const ChainSmoother::Piece& piece);
  void add_curve(const motion::Curve& curve, const Drive& drive, bool joined,
                 double begin_off_mm = 0, double begin_turn = 0, double end_turn = 0);
  void close_open(bool with_stop);
  void round(const Rounding& rounding, const Drive& drive);
  [[nodiscard]] Drive drive_of_corner(const motion::Curve& out, const Drive& drive,
                                      const Passage& passage) const;
  [[nodiscard]] double way_in_space(const motion::Curve& curve, double at) const;
  [[nodiscard]] double pitch_of(const motion::Curve& curve) const;
  [[nodiscard]] double length_per_parameter(const motion::Curve& curve, double begin,
                                            double end) const;
  PathPiece& emit(const motion::Curve& curve, double begin, double end, const Drive& drive);
  PathPiece& emit_dwell(const motion::Motion& motion, double seconds);
  void mark(double way, const motion::Mark& mark);
  void place_marks(std::uint64_t last, double up_to, double shift);
  [[nodiscard]] Pace pace_of(const motion::Motion& motion, const motion::Feed& feed,
                             double length) const;
  [[nodiscard]] Drive drive_at(const Pace& pace) const;
  [[nodiscard]] double speed_at(const Pace& pace, const base::TipPoint& tip) const;
  [[nodiscard]] motion::Mark mark_of(const motion::Motion& motion, motion::MoveKind kind,
                                     double speed = 0) const;

  const motion::AxisSetup& axes_;
  motion::AxisNorms norms_;
  double tolerance_mm_;
  double curve_tolerance_mm_;  // of corners at either end of a curve that is added
  double surface_tolerance_mm_;
  Follower follower_;
  CornerRounder corners_;
  ChainSmoother chain_;
  motion::MoveCurves curves_;
  Path& path_;
  Open open_;
  bool is_open_ = false;
  bool rapid_ = false;        // the curves are those of a rapid
  bool rotary_only_ = false;  // the parameter counts degrees
  std::uint64_t placed_ = 0;  // marks before this one know their cell
  base::TipPoint at_;
  bool keeps_spindle_angle_;
  motion::SpindleSpeeds spindles_;
  double thread_rpm_ = 0;      // of the thread under way
  bool in_thread_ = false;     // the last move was a thread
  bool thread_stops_ = false;  // and the program wants a stop behind it
  motion::Power power_;
  std::uint32_t tool_ = 0;
  std::uint64_t motions_ = 0;  // taken
};

}  // namespace kerf::planner
