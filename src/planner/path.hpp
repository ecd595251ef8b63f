#pragma once

#include <cstdint>
#include <limits>

#include "motion/curve.hpp"
#include "motion/mark.hpp"
#include "motion/path_speed.hpp"
#include "motion/spindle_speeds.hpp"
#include "planner/cell_limits.hpp"
#include "planner/ring.hpp"

namespace kerf::planner {

/// A part of a curve with what the program wants there, or a dwell between two of them.
struct PathPiece {
  double begin = 0;  ///< the part of the curve, by its parameter
  double end = 0;
  motion::PathSpeed speed;  ///< that the program wants, > 0; infinite for rapids
  double dwell_s = 0;       ///< > 0: the axes rest this long; there is no curve then
  /// > 0: a dwell until the spindle, at this speed, is `mark_deg` behind its mark; `dwell_s` is a
  /// turn.
  double mark_rpm = 0;
  double mark_deg = 0;
  /// A dwell until the spindle has its speed, at most `dwell_s`.
  bool until_speed = false;
  motion::SpindleName spindle = motion::SpindleName::main;  ///< of either
  CellLimits::Use use = CellLimits::Use::path;
  bool rapid = false;
  bool fixed_override = false;  ///< the operator cannot change the feed
  bool stop = false;            ///< the axes come to rest at its end
  bool thread = false;          ///< a feed hold waits for its end
  motion::Curve curve;

  [[nodiscard]] bool waits_for_spindle() const { return mark_rpm > 0 || until_speed; }
};

/// Where on the path a motion ends.
struct PathMark {
  std::uint64_t piece = 0;  ///< its number
  double way = 0;           ///< parameter of its curve
  motion::Mark mark;
};

/// From where on a spindle goes to another speed: the axes rest there.
struct SpindleChange {
  std::uint64_t piece = 0;  ///< that begins there
  motion::SpindleTurn turn;
};

/// The path ahead of the tool, and the motions that it belongs to.
struct Path {
  static constexpr std::size_t kPieces = 2048;
  static constexpr std::size_t kMarks = 16384;

  Ring<PathPiece> pieces{kPieces};
  Ring<PathMark> marks{kMarks};
  Ring<SpindleChange> spindle_changes{(motion::kSpindles + 1) * kPieces};
};

}  // namespace kerf::planner
