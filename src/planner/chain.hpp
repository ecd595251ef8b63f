#pragma once

#include <array>
#include <cstdint>

#include "motion/axis_norms.hpp"
#include "motion/curve.hpp"
#include "motion/mark.hpp"
#include "planner/follower.hpp"
#include "planner/ring.hpp"

namespace kerf::planner {

/// How fast the program wants a move, as long as it is not known where on the path.
struct Pace {
  double value = 0;             ///< mm (degrees) a second, or mm per turn
  bool per_turn = false;        ///< of a spindle whose speed follows the tip's radius
  bool fixed_override = false;  ///< the operator cannot change it

  bool operator==(const Pace&) const = default;
};

/// Makes one smooth curve of a chain of short lines, as they come from CAM systems: what was a
/// curve before it was written as points becomes a curve again, free of the rounding of its points.
///
/// The curve goes through some of the points, its nodes, with the direction and curvature of a
/// parabola through neighbours; between nodes it is a polynomial of degree 5, so position,
/// direction and curvature have no steps. It leaves the lines by `tolerance` at most: every point
/// between two nodes is asked, and nodes move together until that holds and the driven axes can
/// follow.
///
/// Lines join a chain while the arc that they may stand for stays within the tolerance. Bounded
/// memory, no allocation after the first motion.
class ChainSmoother {
 public:
  /// What came out: a curve over the points `first` < n <= `last`, which stay readable by point()
  /// until the next call.
  struct Piece {
    motion::Curve curve;
    bool joined = false;  ///< goes on from the piece before with its direction and curvature
    std::uint64_t first = 0;
    std::uint64_t last = 0;
    double begin_off_mm = 0;  ///< of a piece that is not joined: from its first point
    double begin_turn = 0;    ///< from its first line to the curve, as a difference of directions
    double end_turn = 0;      ///< and from the curve to its last line
  };

  struct Point {
    base::TipPoint at;
    double way = 0;  ///< from the begin of the chain along the lines
    Pace pace;       ///< of the line that ends here
    motion::Mark mark;
  };

  /// The follower must outlive this.
  ChainSmoother(double tolerance_mm, std::size_t axes, const motion::LinearAxes& linear,
                Follower& follower);

  [[nodiscard]] bool empty() const { return points_.size() < 2; }
  /// Whether a line from the chain's end to `to` goes on with it.
  [[nodiscard]] bool accepts(const base::TipPoint& to, double length) const;
  /// A chain begins here. Precondition: empty().
  void start(const base::TipPoint& from);
  /// Precondition: accepts(), or empty() and start() was called; room for one more is there after
  /// next() returned false.
  void add(const base::TipPoint& to, double length, const Pace& pace, const motion::Mark& mark);

  /// The next piece; false when it needs more lines. With `ended` the chain ends at its last point,
  /// and after the last piece it is empty.
  bool next(bool ended, Piece& piece);
  [[nodiscard]] const Point& point(std::uint64_t number) const { return points_[number]; }

 private:
  struct Node {
    base::TipJet jet;
    std::uint64_t spread = 1;  // to the neighbours that its parabola goes through
  };

  [[nodiscard]] Node node_at(std::uint64_t number, std::uint64_t last, std::uint64_t spread) const;
  [[nodiscard]] base::TipJet parabola(std::uint64_t a, std::uint64_t b, std::uint64_t c,
                                      std::uint64_t at) const;
  [[nodiscard]] base::TipJet cubic(std::uint64_t first, std::uint64_t last, std::uint64_t at) const;
  [[nodiscard]] bool fits(const base::TipJet& jet, std::uint64_t at, std::uint64_t first,
                          std::uint64_t last) const;
  [[nodiscard]] bool follows(const motion::Curve& curve, std::uint64_t last) const;
  [[nodiscard]] std::uint64_t furthest(std::uint64_t last) const;
  [[nodiscard]] double turn(const base::AxisVector& direction, std::uint64_t line) const;
  void line_piece(Piece& piece);
  void forget(bool ended);

  double tolerance_;
  std::size_t axes_;
  motion::AxisNorms norms_;
  Follower& follower_;
  Ring<Point> points_;
  Node node_;                 // where the next piece begins
  std::uint64_t at_ = 0;      // number of its point
  std::uint64_t origin_ = 0;  // point that no parabola may look behind
  bool node_known_ = false;
};

}  // namespace kerf::planner
