#pragma once

#include <array>
#include <optional>

#include "control/gcode/acts/moves.hpp"
#include "control/gcode/acts/state.hpp"
#include "control/gcode/acts/targets.hpp"
#include "control/gcode/cycles/turning_cycle.hpp"

namespace kerf::control {

/// G90, G92 and G94 of a lathe: four moves round the tool's place and back, again with each block
/// that names X, Z or R (docs/dialect/turning.md, single cycles).
class SingleCycles {
 public:
  SingleCycles(State& state, Targets& targets, Moves& moves, TurningCycle& turning)
      : state_(state), targets_(targets), moves_(moves), turning_(turning) {}

  /// Whether one of them is in force.
  [[nodiscard]] static bool is_one(Meaning motion) {
    return motion == Meaning::turning_cycle || motion == Meaning::thread_cycle ||
           motion == Meaning::facing_cycle;
  }
  /// A block while one is in force; its moves are the turning cycle's. False: an alarm was raised.
  [[nodiscard]] bool begin(const Words& words, bool& moved);
  /// A code that ends the cycles: X, Z and R are forgotten.
  void forget() {
    data_ = {};
    has_run_ = false;
  }

 private:
  // As written: a point, or a way from where the tool stands.
  struct Word {
    double value = 0;
    bool is_way = false;
  };
  struct Data {
    std::optional<Word> x;
    std::optional<Word> z;
    double taper = 0;  // R: half the difference of the diameters, or along Z for G94
  };

  bool read(const Words& words, const motion::PlaneAxes& axes);
  bool read_word(const Words& words, base::Axis axis, std::optional<Word>& word);
  bool make(const Words& words, const motion::PlaneAxes& axes);
  [[nodiscard]] geometry::Vec2 corner(const motion::PlaneAxes& axes) const;

  State& state_;
  Targets& targets_;
  Moves& moves_;
  TurningCycle& turning_;
  Data data_;
  bool has_run_ = false;  // since it was called
};

}  // namespace kerf::control
