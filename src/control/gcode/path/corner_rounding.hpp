#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "control/core/alarms.hpp"
#include "control/gcode/path/path_step.hpp"
#include "motion/plane_axes.hpp"

namespace kerf::control {

/// Chamfers and corner radii that ",C" and ",R" put between two moves of the plane (alarms PS0050
/// to PS0055). The move that asks for one is held until the next one is known. Those of a lathe
/// stand between lines alone, and one block without a move may come between them
/// (docs/dialect/turning.md, drawing dimensions).
class CornerRounding {
 public:
  enum class Kind : std::uint8_t { chamfer, radius };
  struct Request {
    Kind kind = Kind::radius;
    double size_mm = 0;
    bool between_lines = false;  ///< of a lathe
    /// Where the next move must go, along an axis of the plane; nothing: anywhere.
    std::optional<geometry::Vec2> toward{};
  };
  /// Takes the moves that come out, and whatever stood between them. False: an alarm was raised.
  using Forward = std::function<bool(const PathStep&)>;
  using Pass = std::function<void(const motion::Motion&)>;

  CornerRounding(Alarms& alarms, Forward forward, Pass pass)
      : alarms_(alarms), forward_(std::move(forward)), pass_(std::move(pass)) {}

  /// So far may a move along an axis of a lathe leave it: the least increment of a word.
  static constexpr double kAlongAxis_mm = 0.001;
  /// Blocks without a move that may stand between the lines of a lathe.
  static constexpr int kMostIdleBlocks = 1;

  [[nodiscard]] bool holding() const { return held_.has_value(); }
  [[nodiscard]] const PathStep& held() const { return *held_; }
  [[nodiscard]] motion::Plane plane() const { return plane_; }
  [[nodiscard]] const motion::PlaneAxes& axes() const { return axes_; }

  /// A move; `request` asks for a corner at its end.
  [[nodiscard]] bool move(const PathStep& step, motion::Plane plane, const motion::PlaneAxes& axes,
                          const std::optional<Request>& request);
  /// Anything else while a move is held keeps its place behind it.
  void beside(const motion::Motion& motion) { beside_.push_back(motion); }
  /// A block is over. False: it should have brought the move behind a corner (PS0051).
  [[nodiscard]] bool end_block();
  /// The move behind the corner will not come: PS0051.
  [[nodiscard]] bool refuse() { return refuse(base::Code::corner_missing_move); }
  /// Another move comes in its place, that takes no corner: PS0051, of a lathe PS0052.
  [[nodiscard]] bool refuse_other_move();
  void reset();

 private:
  bool refuse(base::Code code);
  bool check_next(const PathStep& next);
  bool blend(PathStep& next);
  bool let_go();

  Alarms& alarms_;
  Forward forward_;
  Pass pass_;
  std::optional<PathStep> held_;
  Request request_;
  motion::Plane plane_ = motion::Plane::xy;
  motion::PlaneAxes axes_;
  bool fresh_ = false;  // held since this block
  int idle_blocks_ = 0;
  std::vector<motion::Motion> beside_;
};

/// A corner that the block's move asks for at its end, and the plane in which it lies.
struct CornerAtEnd {
  CornerRounding::Request request;
  motion::Plane plane = motion::Plane::xy;
  motion::PlaneAxes axes;
};

}  // namespace kerf::control
