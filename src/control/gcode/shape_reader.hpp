#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "control/gcode/acts/state.hpp"
#include "control/gcode/acts/targets.hpp"
#include "control/gcode/cycles/shape_cycles.hpp"
#include "control/gcode/cycles/turning_shape.hpp"
#include "control/gcode/path/block_buffer.hpp"
#include "lang/vm/code_page.hpp"

namespace kerf::control {

/// Reads the shape of a roughing cycle: its blocks are executed as ever, but what they command
/// becomes the shape instead of motion, and behind the last one everything is as before the first.
/// Tools and functions of the blocks mean nothing here; macro statements have run. With
/// `cycle_nose` = 1 the shape is the path of the imaginary tip along what the blocks say.
class ShapeReader : public motion::MotionSink {
 public:
  ShapeReader(State& state, const Targets& targets, BlockBuffer& buffer)
      : state_(state), targets_(targets), buffer_(buffer) {}

  /// From the block that executes on. False: an alarm was raised.
  [[nodiscard]] bool begin(const motion::PlaneAxes& axes);
  [[nodiscard]] bool reading() const { return kept_.has_value(); }
  /// A block of the shape is over. False: an alarm was raised, as by the first one if it is no
  /// straight move.
  [[nodiscard]] bool end_block(const Words& words);
  /// The last block is over. False: an alarm was raised.
  [[nodiscard]] bool end();
  /// The cycle ends here: everything is as before the shape.
  void drop();

  [[nodiscard]] const TurningShape& shape() const { return shape_; }
  [[nodiscard]] std::vector<base::BlockId> take_blocks() { return std::move(blocks_); }

  // MotionSink
  void take(const motion::Motion& motion) override;

 private:
  struct Kept {
    ModalState modal;
    ModalState before;
    ModalWords words;
    Coordinates coordinates;
    base::AxisVector wanted_offset;
    base::BlockId cycle;
    base::TipPoint tip;
    std::optional<Toolpath::Paused> compensation;
  };

  void add(const motion::Motion& motion);
  bool compensate();
  bool hand_on(const ShapePiece& piece, const std::vector<base::BlockId>& blocks);
  [[nodiscard]] bool begins_straight(const Words& words) const;
  void restore();

  State& state_;
  const Targets& targets_;
  BlockBuffer& buffer_;
  std::optional<Kept> kept_;
  motion::PlaneAxes axes_;
  TurningShape shape_;
  std::vector<base::BlockId> blocks_;
  geometry::Vec2 at_;
  bool has_nose_ = false;      // the shape is compensated
  bool in_first_ = false;      // the first block executes
  bool awaits_first_ = false;  // its move has not come
};

/// Whether a shape may have a block with these words; false: an alarm was raised (PS0325, PS0210).
[[nodiscard]] bool admits_in_shape(State& state, const Targets& targets, const Words& words);

/// Whether nothing of the shape waits for a block behind its last one; false: an alarm was raised
/// (PS0069, PS0326).
[[nodiscard]] bool ends_complete(State& state);

}  // namespace kerf::control
