#pragma once

#include <optional>

#include "control/gcode/acts/state.hpp"

namespace kerf::control {

/// What a block may change before the alarm that it raises, as it was when the block began: a
/// search for mistakes leaves such a block out (Control::pass_alarm()). Nothing is kept unless it
/// is switched on. No allocation.
class BlockMemory {
 public:
  void switch_on() { on_ = true; }

  /// A block begins.
  void keep(const State& state) {
    if (on_) kept_.emplace(Kept{state.modal, state.words, state.coordinates, state.wanted_length});
  }

  /// Modes, words and coordinate systems as they were.
  void restore(State& state) const {
    if (!kept_) return;
    state.modal = kept_->modal;
    state.words = kept_->words;
    state.coordinates = kept_->coordinates;
    state.wanted_length = kept_->wanted_length;
    state.refresh_format();
  }

  /// The programmed point is where the tool is: a block that has moved before its alarm has moved.
  /// Compensation and a held corner end.
  static void settle(State& state) {
    if (state.path.holds_moves()) state.modal.set(Meaning::compensation_off);
    state.path.reset();
    const base::PathPoint at(state.path.tip().numbers());
    if (state.coordinates.path() != at) state.coordinates.arrive_at(at);
  }

 private:
  struct Kept {
    ModalState modal;
    ModalWords words;
    Coordinates coordinates;
    double wanted_length = 0;
  };
  std::optional<Kept> kept_;
  bool on_ = false;
};

}  // namespace kerf::control
