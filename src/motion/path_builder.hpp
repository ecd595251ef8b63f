#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "control/axis_setup.hpp"
#include "control/motion.hpp"
#include "motion/axis_norms.hpp"
#include "motion/cell_limits.hpp"
#include "motion/chain.hpp"
#include "motion/corner.hpp"
#include "motion/mark.hpp"
#include "motion/move_curves.hpp"
#include "motion/path.hpp"

namespace kerf::motion {

/// Turns motions into a path that the axes can follow: smooth chains of short lines, rounded
/// corners, and stops where there must be some.
///
/// It keeps back what the next motion may still change: a curve whose end may be rounded, and up to
/// some hundred short lines. Bounded memory, no allocation after the first motion.
class PathBuilder {
 public:
  /// The limits are those of the driven axes, `linkage` is null when these are the program's.
  /// Everything but the settings must outlive the builder.
  PathBuilder(const control::AxisSetup& axes, const CellLimits& limits, const Settings& settings,
              Path& path, const Linkage* linkage = nullptr);

  /// Whether the path has room for what one more motion may add.
  [[nodiscard]] bool room() const;
  /// Adds a motion; those that move nothing are either stops or passed over. Precondition: room().
  void take(const control::Motion& motion);
  /// The axes come to rest behind what was taken so far; nothing is kept back. Precondition:
  /// room().
  void stop();

  /// Something that was taken is not on the path yet.
  [[nodiscard]] bool keeps_back() const { return is_open_ || !chain_.empty(); }
  /// Where the last motion ended.
  [[nodiscard]] const base::AxisVector& at() const { return at_; }
  /// Forgets what it keeps back; the next motion begins at `at`.
  void clear(const base::AxisVector& at);
  void set_spindle_speed(double rpm) { speed_rpm_ = rpm; }
  /// What the operator makes of spindle speeds, > 0; feeds per revolution follow from the next
  /// motion on.
  void set_spindle_override(double factor) { spindle_override_ = factor; }

 private:
  /// A curve whose end is still open.
  struct Open {
    Curve curve;
    double begin = 0;  // behind the rounding of the corner before
    double feed = 0;
    double begin_turn = 0;  // from the programmed line to the curve, at its begin and end
    double end_turn = 0;
    bool fixed_override = false;
    std::uint64_t last_mark = 0;  // behind the marks of the curve
  };

  void add_line(const control::Motion& motion, const base::AxisVector& to,
                const control::Feed& feed);
  void add_rapid(const control::Motion& motion, const control::Rapid& rapid);
  void add_arc(const control::Motion& motion, const base::AxisVector& to,
               const control::Feed& feed);
  void add_curves(std::span<const Curve> curves, const Mark& mark_of_last, double speed,
                  bool fixed_override);
  void add_dwell(const control::Motion& motion, double seconds);
  void drain_chain(bool ended);
  void add_piece(const ChainSmoother::Piece& piece);
  void add_curve(const Curve& curve, double feed, bool fixed_override, bool joined,
                 double begin_off_mm = 0, double begin_turn = 0, double end_turn = 0);
  void close_open(bool with_stop);
  void round(const Rounding& rounding, double feed);
  [[nodiscard]] double way_in_space(const Curve& curve, double at) const;
  [[nodiscard]] double pitch_of(const Curve& curve) const;
  [[nodiscard]] double length_per_parameter(const Curve& curve, double begin, double end) const;
  PathPiece& emit(const Curve& curve, double begin, double end, double feed);
  void mark(double way, const Mark& mark);
  void place_marks(std::uint64_t last, double up_to, double shift);
  [[nodiscard]] double speed_of(const control::Feed& feed, double length) const;
  [[nodiscard]] Mark mark_of(const control::Motion& motion, MoveKind kind, double speed = 0) const;

  const control::AxisSetup& axes_;
  AxisNorms norms_;
  double tolerance_mm_;
  Follower follower_;
  CornerRounder corners_;
  ChainSmoother chain_;
  MoveCurves curves_;
  Path& path_;
  Open open_;
  bool is_open_ = false;
  bool rapid_ = false;        // the curves are those of a rapid
  bool rotary_only_ = false;  // the parameter counts degrees
  std::uint64_t placed_ = 0;  // marks before this one know their cell
  base::AxisVector at_;
  double speed_rpm_ = 0;
  double spindle_override_ = 1;
  control::Power power_;
  std::uint32_t tool_ = 0;
  std::uint64_t motions_ = 0;  // taken
};

}  // namespace kerf::motion
