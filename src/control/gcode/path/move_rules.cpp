#include "control/gcode/path/move_rules.hpp"

#include "base/decimal.hpp"

namespace kerf::control {

bool has_bit(double variable, unsigned bit) {
  return variable != 0 && (static_cast<std::uint64_t>(base::round_away(variable)) & bit) != 0;
}

MoveRules move_rules(const Words& words, const ModalState& modal, double feed_control) {
  const Meaning mode = modal[Group::stop_mode];
  const bool stops = !has_bit(feed_control, FeedControl::no_exact_stop);
  return {.every_move_stops =
              stops && (words.has_g(Meaning::exact_stop) || words.has_g(Meaning::single_direction)),
          .every_cut_stops = stops && mode == Meaning::exact_stop_mode,
          .fixed_override =
              mode == Meaning::tapping_mode || has_bit(feed_control, FeedControl::no_override)};
}

void mark(motion::Motion& motion, const MoveRules& rules) {
  const bool cut = motion::is_cut(motion);
  const bool probe = std::holds_alternative<motion::Probe>(motion.action);
  const bool moves = cut || probe || std::holds_alternative<motion::Rapid>(motion.action);
  motion.exact_stop = probe || (moves && rules.every_move_stops) || (cut && rules.every_cut_stops);
  motion.fixed_override = probe || std::holds_alternative<motion::Thread>(motion.action) ||
                          (cut && rules.fixed_override);
}

}  // namespace kerf::control
