#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "control/gcode/block_acts.hpp"
#include "control/gcode/block_reader.hpp"
#include "control/gcode/shape_reader.hpp"
#include "lang/gcode/code_library.hpp"
#include "lang/vm/interpreter.hpp"

namespace kerf::control {

/// Leads the program through the blocks of a shape, from P to Q of G70 to G73
/// (docs/dialect/turning.md, cycles along a shape): G71 to G73 read them and go on behind them, G70
/// makes them, goes back to where the tool stood and goes on behind itself.
class ShapeBlocks {
 public:
  ShapeBlocks(State& state, BlockActs& acts, BlockReader& reader, BlockBuffer& buffer,
              vm::Interpreter& interpreter, gcode::CodeLibrary& library)
      : state_(state),
        acts_(acts),
        blocks_(reader),
        buffer_(buffer),
        interpreter_(interpreter),
        library_(library),
        reader_(state, acts.targets(), buffer) {}

  /// The executing block's cycle has asked for a shape: the program goes to its first block. False:
  /// an alarm was raised.
  [[nodiscard]] bool go(ReadBlock& cycle, std::span<const gcode::Word> words);
  [[nodiscard]] bool active() const { return stretch_.has_value(); }
  /// Whether a shape that is read or made may have a block with these words; false: an alarm was
  /// raised.
  [[nodiscard]] bool admits(const Words& words) const;
  /// What the blocks command is a shape, and moves nothing.
  [[nodiscard]] bool reading() const { return reader_.reading(); }
  /// Whether the executing block, which has this sequence number, stands behind the shape: its last
  /// one commands nothing.
  [[nodiscard]] bool is_behind(std::uint32_t sequence) const;
  /// Whether a block is the last one of the shape.
  [[nodiscard]] bool is_last(const ReadBlock& block) const {
    return active() && block.number == stretch_->last && interpreter_.depth() == stretch_->depth;
  }
  /// A block of a shape that is read is over. False: an alarm was raised.
  [[nodiscard]] bool end_block(const ReadBlock& block) { return reader_.end_block(block.words); }
  /// The shape is read: `block` is that of the cycle again, which makes its passes now. The program
  /// goes on behind the shape, or behind the cycle where that stands behind its shape. False: an
  /// alarm was raised. Precondition: `block` is the last one, or the executing block stands behind
  /// that.
  [[nodiscard]] bool finish_reading(ReadBlock& block);
  /// The shape is made: home, and behind the block of G70. False: an alarm was raised.
  [[nodiscard]] bool finish_making();
  /// The program ended within the shape: an alarm. Always false.
  bool miss_last();
  /// The cycle is over, wherever it was.
  void drop();

 private:
  struct Stretch {
    std::uint32_t last = 0;  ///< sequence number
    vm::CodeId code{};
    vm::Address end;  ///< of the block with that number
    std::size_t depth = 0;
    vm::Address behind;  ///< the block of the cycle
    base::PathPoint home;
    // The block of the cycle.
    base::BlockId block;
    std::uint32_t number = 0;
    std::uint32_t line = 0;
    std::vector<gcode::Word> words;
    Auxiliary::Codes codes;
  };

  [[nodiscard]] std::optional<vm::Address> find_last(const ShapeCycles::Request& request) const;

  State& state_;
  BlockActs& acts_;
  BlockReader& blocks_;
  BlockBuffer& buffer_;
  vm::Interpreter& interpreter_;
  gcode::CodeLibrary& library_;
  ShapeReader reader_;
  std::optional<Stretch> stretch_;
  std::vector<gcode::Word> words_;  // of the cycle's block, once more
};

}  // namespace kerf::control
