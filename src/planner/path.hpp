#pragma once

#include <cstdint>
#include <limits>

#include "motion/curve.hpp"
#include "motion/mark.hpp"
#include "planner/cell_limits.hpp"
#include "planner/ring.hpp"

namespace kerf::planner {

/// A part of a curve with what the program wants there, or a dwell between two of them.
struct PathPiece {
  double begin = 0;  ///< the part of the curve, by its parameter
  double end = 0;
  double feed = 0;     ///< units of the parameter a second, > 0; infinite for rapids
  double dwell_s = 0;  ///< > 0: the axes rest this long; there is no curve then
  CellLimits::Use use = CellLimits::Use::path;
  bool rapid = false;
  bool fixed_override = false;  ///< the operator cannot change the feed
  bool stop = false;            ///< the axes come to rest at its end
  motion::Curve curve;
};

/// Where on the path a motion ends.
struct PathMark {
  std::uint64_t piece = 0;  ///< its number
  double way = 0;           ///< parameter of its curve
  motion::Mark mark;
};

/// The path ahead of the tool, and the motions that it belongs to.
struct Path {
  static constexpr std::size_t kPieces = 2048;
  static constexpr std::size_t kMarks = 16384;

  Ring<PathPiece> pieces{kPieces};
  Ring<PathMark> marks{kMarks};
};

}  // namespace kerf::planner
