#pragma once

#include <cstdint>

#include "control/gcode/acts/state.hpp"
#include "control/gcode/acts/targets.hpp"

namespace kerf::control {

/// G10: work offsets, tool offsets, and the entry of parameters up to G11 (docs/dialect/macros.md
/// §7.4).
class DataSetting {
 public:
  DataSetting(State& state, Targets& targets) : state_(state), targets_(targets) {}

  /// A block with G10. False: an alarm was raised.
  [[nodiscard]] bool execute(const Words& words);
  /// A block between G10 L50 and G11: the parameter `number`, its N, becomes R; P is the
  /// axis of one that each axis has.
  [[nodiscard]] bool enter_parameter(const Words& words, std::uint32_t number);

 private:
  bool name_axis(const Words& words, std::string& key);
  bool set_parameter(const gcode::Word& word, const std::string& key, double value);
  bool enter_bits(const gcode::Word& word, std::uint32_t number);
  bool set_work_offset(const Words& words);
  bool set_tool_offset(const Words& words, std::int64_t l);
  bool set_turning_offset(const Words& words);
  bool set_work_shift(const Words& words);
  bool set_part(const Words& words, char letter, char increment, double& part);

  State& state_;
  Targets& targets_;
};

}  // namespace kerf::control
