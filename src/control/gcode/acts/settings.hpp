#pragma once

#include "control/gcode/acts/compensation.hpp"
#include "control/gcode/acts/moves.hpp"
#include "control/gcode/acts/state.hpp"
#include "control/gcode/acts/targets.hpp"

namespace kerf::control {

/// What blocks set without moving: modal codes and everything that they switch (coordinate systems,
/// tool length, cutter compensation, scaling, mirror image, rotation), and the one-shot codes G52,
/// G92 (docs/dialect.md §8.3 to §8.5, §9).
class Settings {
 public:
  Settings(State& state, Targets& targets, Moves& moves)
      : state_(state), targets_(targets), moves_(moves), compensation_(state, targets) {}

  /// Takes the modal codes of a block over; checks each.
  [[nodiscard]] bool read_codes(const Words& words, const Words::G*& one_shot);
  /// Carries out what the modal codes of the block switch, before its motion.
  [[nodiscard]] bool apply_codes(const Words& words);

  [[nodiscard]] bool local_system(const Words& words);     ///< G52
  [[nodiscard]] bool preset(const Words& words);           ///< G92
  [[nodiscard]] bool clear_shifts(const Words& words);     ///< G92.1
  [[nodiscard]] bool switch_diameter(const Words& words);  ///< G10.9

  /// True when the words X, Y, … of the block are data of its codes, not a move.
  [[nodiscard]] bool takes_axis_words(const Words& words) const;

  /// The length offset that H selects, mm.
  [[nodiscard]] double length_of(std::int64_t number) const;

 private:
  bool check_parallel_axes(const Words& words);
  bool check_css_axis(const gcode::Word& word);
  bool check_code(const Words& words, const Words::G& g);
  bool select_work(const Words& words, const CodeRow& row);
  bool find_length_axis(const Words& words, base::Axis& axis) const;
  bool set_length(const Words& words, bool switched);
  bool set_scaling(const Words& words);
  bool scale_factor(const Words& words, char letter, double& factor);
  bool set_mirror(const Words& words, bool on);
  void set_turret(bool second);
  bool set_rotation(const Words& words);

  State& state_;
  Targets& targets_;
  Moves& moves_;
  Compensation compensation_;
};

}  // namespace kerf::control
