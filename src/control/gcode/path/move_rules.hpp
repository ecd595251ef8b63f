#pragma once

#include "control/gcode/codes/modal_state.hpp"
#include "control/gcode/words/words.hpp"
#include "motion/motion.hpp"

namespace kerf::control {

/// Bits of #3004.
struct FeedControl {
  static constexpr unsigned no_feed_hold = 1;
  static constexpr unsigned no_override = 2;
  static constexpr unsigned no_exact_stop = 4;
};
[[nodiscard]] bool has_bit(double variable, unsigned bit);

/// How the moves of a block end, and whether the operator can change their feed
/// (docs/dialect/motion.md §8.1).
struct MoveRules {
  bool every_move_stops = false;  ///< G09, G60
  bool every_cut_stops = false;   ///< G61
  bool fixed_override = false;    ///< of the cuts: G63, #3004, tapping cycles
};

/// What a block says of its moves, in the modal state in which it is executed. `feed_control` is
/// #3004; while it switches the exact stop off, nothing stops.
[[nodiscard]] MoveRules move_rules(const Words& words, const ModalState& modal,
                                   double feed_control);

/// Marks a motion by the rules of its block. Probes stop in any case, and neither their feed nor
/// that of threads can be changed.
void mark(motion::Motion& motion, const MoveRules& rules);

}  // namespace kerf::control
