#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "control/core/alarms.hpp"
#include "control/gcode/path/path_step.hpp"
#include "motion/plane_axes.hpp"

namespace kerf::control {

/// Chamfers and corner radii that ",C" and ",R" put between two moves of the plane (alarms PS0050
/// to PS0055). The move that asks for one is held until the next one is known.
class CornerRounding {
 public:
  enum class Kind : std::uint8_t { chamfer, radius };
  struct Request {
    Kind kind = Kind::radius;
    double size_mm = 0;
  };
  /// Takes the moves that come out, and whatever stood between them. False: an alarm was raised.
  using Forward = std::function<bool(const PathStep&)>;
  using Pass = std::function<void(const motion::Motion&)>;

  CornerRounding(Alarms& alarms, Forward forward, Pass pass)
      : alarms_(alarms), forward_(std::move(forward)), pass_(std::move(pass)) {}

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
  [[nodiscard]] bool refuse();
  void reset();

 private:
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
  std::vector<motion::Motion> beside_;
};

}  // namespace kerf::control
