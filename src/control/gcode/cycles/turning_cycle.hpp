#pragma once

#include <memory>
#include <vector>

#include "control/gcode/acts/moves.hpp"
#include "control/gcode/acts/state.hpp"
#include "control/gcode/cycles/stepped.hpp"
#include "control/gcode/cycles/turning_passes.hpp"

namespace kerf::control {

/// Makes the moves of a turning cycle: in the plane of Z and X, where the programmed path lies in
/// the machine's coordinates.
class TurningCycle : public Stepped {
 public:
  TurningCycle(State& state, Moves& moves) : state_(state), moves_(moves) {}

  /// What the moves of a cycle have besides their places.
  struct Manner {
    motion::Feed feed;
    double lead = 0;                      ///< of the threads, mm
    double height = 0;                    ///< of the thread, mm of radius; 0: not known
    std::vector<base::BlockId> blocks{};  ///< of the shape, by TurningMove::block
    bool repeats = false;                 ///< a modal cycle that has run in a block before
  };
  /// The axes of the plane. False: the machine lacks one, an alarm was raised.
  [[nodiscard]] bool plane(motion::PlaneAxes& axes);
  /// Where the programmed path is in that plane.
  [[nodiscard]] static geometry::Vec2 place(const Coordinates& coordinates,
                                            const motion::PlaneAxes& axes) {
    return axes.project(coordinates.path());
  }
  void begin(Meaning cycle, std::unique_ptr<TurningPasses> passes, const motion::PlaneAxes& axes,
             Manner manner);

  [[nodiscard]] bool running() const override { return passes_ != nullptr; }
  [[nodiscard]] bool step() override;
  void stop() override { passes_ = nullptr; }

 private:
  bool make(const TurningMove& move);
  bool emit_with_nose(const TurningMove& move, const base::PathPoint& to);
  bool emit(const TurningMove& move, const base::PathPoint& to);

  State& state_;
  Moves& moves_;
  std::unique_ptr<TurningPasses> passes_;
  motion::PlaneAxes axes_;
  Manner manner_;
};

}  // namespace kerf::control
