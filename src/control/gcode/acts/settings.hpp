#pragma once

#include "control/gcode/acts/moves.hpp"
#include "control/gcode/acts/state.hpp"
#include "control/gcode/acts/targets.hpp"

namespace kerf::control {

/// What blocks set without moving: modal codes and everything that they switch (coordinate systems,
/// tool length, cutter compensation, scaling, mirror image, rotation), and the one-shot codes G10,
/// G52, G92 (docs/dialect.md §7.4, §8.3 to §8.5, §9).
class Settings {
 public:
  Settings(State& state, Targets& targets, Moves& moves)
      : state_(state), targets_(targets), moves_(moves) {}

  /// Takes the modal codes of a block over; checks each.
  [[nodiscard]] bool read_codes(const Words& words, const Words::G*& one_shot);
  /// Carries out what the modal codes of the block switch, before its motion.
  [[nodiscard]] bool apply_codes(const Words& words);

  [[nodiscard]] bool local_system(const Words& words);  ///< G52
  [[nodiscard]] bool preset(const Words& words);        ///< G92
  [[nodiscard]] bool clear_shifts(const Words& words);  ///< G92.1
  [[nodiscard]] bool set_data(const Words& words);      ///< G10
  [[nodiscard]] bool enter_parameter(const Words& words,
                                     std::uint32_t number);  ///< between G10 L50 and G11: N, R

  /// True when the words X, Y, … of the block are data of its codes, not a move.
  [[nodiscard]] bool takes_axis_words(const Words& words) const;

  /// The length offset that H selects, mm.
  [[nodiscard]] double length_of(std::int64_t number) const;
  [[nodiscard]] double radius_of(std::int64_t number) const;

 private:
  bool enter_bits(const gcode::Word& word, std::uint32_t number);
  bool check_parallel_axes(const Words& words);
  bool check_css_axis(const gcode::Word& word);
  bool check_code(const Words& words, const Words::G& g);
  bool select_work(const Words& words, const CodeRow& row);
  bool find_length_axis(const Words& words, base::Axis& axis) const;
  bool set_length(const Words& words, bool switched);
  bool set_compensation(const Words& words, bool switched);
  bool set_scaling(const Words& words);
  bool scale_factor(const Words& words, char letter, double& factor);
  bool set_mirror(const Words& words, bool on);
  bool set_rotation(const Words& words);
  bool set_work_offset(const Words& words);
  bool set_tool_offset(const Words& words, std::int64_t kind);

  State& state_;
  Targets& targets_;
  Moves& moves_;
};

}  // namespace kerf::control
