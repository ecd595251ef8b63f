#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "control/gcode/acts/moves.hpp"
#include "control/gcode/acts/state.hpp"
#include "control/gcode/cycles/turning_cycle.hpp"
#include "control/gcode/cycles/turning_shape.hpp"

namespace kerf::control {

/// G70 to G73: cycles along a shape that stands in the blocks P to Q of the program
/// (docs/dialect/turning.md, cycles along a shape). A block without P and Q sets parameters. One
/// with them asks for its shape: whoever runs the program reads it and hands it back.
class ShapeCycles {
 public:
  /// What a block asks for.
  struct Request {
    Meaning cycle = Meaning::none;
    std::uint32_t first = 0;  ///< sequence number ns: P
    std::uint32_t last = 0;   ///< sequence number nf: Q
    vm::Span first_text{};    ///< where they are written
    vm::Span last_text{};
    [[nodiscard]] bool finishes() const { return cycle == Meaning::finishing; }
  };

  ShapeCycles(State& state, Moves& moves, TurningCycle& turning)
      : state_(state), moves_(moves), turning_(turning) {}

  /// A block with one of them. False: an alarm was raised.
  [[nodiscard]] bool execute(Meaning cycle, const Words& words, bool& moved);
  /// The shape that the executing block waits for.
  [[nodiscard]] const std::optional<Request>& request() const { return request_; }
  void drop_request() { request_.reset(); }
  /// The shape of a roughing cycle is read, its tool back where it stood: the passes are the
  /// turning cycle's. `blocks` are those of ShapePiece::block. False: an alarm was raised.
  [[nodiscard]] bool begin(const TurningShape& shape, std::vector<base::BlockId> blocks);

 private:
  bool stands_alone(const Words& words);
  bool set_depth(const Words& words, char depth);
  bool set_pattern(const Words& words);
  bool ask(Meaning cycle, const Words& words);
  bool read_number(const Words& words, char letter, std::uint32_t& number);
  bool read_allowance(const Words& words);
  bool read_one_block(const Words& words);
  bool read_length(const Words& words, char letter, double& mm);
  bool refuse(base::Code code, const base::BlockId& block);
  bool rough(const TurningShape& shape, TurningCycle::Manner manner, const motion::PlaneAxes& axes);

  State& state_;
  Moves& moves_;
  TurningCycle& turning_;
  std::optional<Request> request_;
  geometry::Vec2 allowance_;  // along Z and X, mm of radius
};

}  // namespace kerf::control
