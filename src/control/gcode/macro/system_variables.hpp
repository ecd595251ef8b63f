#pragma once

#include <cstdint>
#include <functional>

#include "control/gcode/acts/state.hpp"
#include "control/gcode/macro/offset_variables.hpp"
#include "lang/gcode/name_table.hpp"
#include "lang/vm/interpreter.hpp"

namespace kerf::control {

/// Variables by number: locals, commons and the system variables from #1000 on
/// (docs/dialect.md §2, §3). Values count in the program's input unit.
class SystemVariables {
 public:
  /// What #3000, #3006 and the like make happen.
  struct Event {
    enum class Kind : std::uint8_t { none, alarm, message } kind = Kind::none;
    double number = 0;
  };

  SystemVariables(State& state, const gcode::NameTable& names)
      : state_(state), offsets_(state), names_(names) {}

  void attach(vm::Interpreter* interpreter, std::function<std::uint32_t()> program_number) {
    interpreter_ = interpreter;
    program_number_ = std::move(program_number);
  }

  /// Whether the variable tells or sets the time: #3001, #3002, #3011, #3012.
  [[nodiscard]] static bool is_clock(double number) {
    return number == 3001 || number == 3002 || number == 3011 || number == 3012;
  }
  /// #1000 to #1015 and #1032 to #1035.
  [[nodiscard]] static bool is_input(double number) { return number >= 1000 && number <= 1035; }
  /// False: an alarm was raised (PS0115, PS1115).
  [[nodiscard]] bool read(double number, double& value);
  /// False: an alarm was raised (PS0115, PS0116, PS0032 …). `event` tells what else must happen.
  [[nodiscard]] bool write(double number, double value, Event& event);
  /// Writes one from outside, before the start. Failure: why not.
  [[nodiscard]] base::Outcome<void> set(std::uint32_t number, double value);
  /// SETVN. False: PS1098 family.
  void name(const std::string& name, std::uint32_t number) {
    state_.memory.names[name] = number;
    ++state_.memory.revision;
  }

 private:
  bool read_system(std::uint32_t number, double& value);
  bool write_system(std::uint32_t number, double value, Event& event);
  bool read_interface(std::uint32_t number, double& value);
  bool read_clock(std::uint32_t number, double& value);
  bool read_modal(std::uint32_t number, double& value);
  bool read_position(std::uint32_t number, double& value);
  bool read_compiler_variable(std::uint32_t number, double& value);
  bool read_parameter(std::uint32_t number, double& value);
  bool write_interface(std::uint32_t number, double value);
  bool write_clock(std::uint32_t number, double value, Event& event);
  bool write_offset(const OffsetVariables::Place& place, double value, double most);
  double* common_or_local(std::uint32_t number);
  bool resolve(double number, std::uint32_t& result);
  bool missing(std::uint32_t number);
  void assume(std::uint32_t key, const char* what);
  [[nodiscard]] bool is_linear(std::size_t axis) const { return !state_.axes.axes[axis].rotary; }
  [[nodiscard]] double to_unit(double value, bool linear) const;
  [[nodiscard]] double from_unit(double value, bool linear) const;

  State& state_;
  OffsetVariables offsets_;
  const gcode::NameTable& names_;
  vm::Interpreter* interpreter_ = nullptr;
  std::function<std::uint32_t()> program_number_;
  double clock_start_s_ = 0;  // of #3001
  double hours_start_s_ = 0;  // of #3002
  double settings_ = 0;       // #3005, the bits that mean nothing here
};

}  // namespace kerf::control
