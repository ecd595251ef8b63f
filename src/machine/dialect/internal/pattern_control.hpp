#pragma once

#include <string>

#include "control/core/program_control.hpp"
#include "lang/vm/interpreter.hpp"
#include "machine/dialect/internal/pattern_library.hpp"
#include "machine/dialect/pattern_motors.hpp"
#include "machine/dialect/pattern_queue.hpp"

namespace kerf::machine {

/// The control of a machine that makes patterns: each line of the listing is a block, its records
/// are pulses counted from where every counter is 0. There are no variables, no calls, no tool and
/// no offset.
///
/// A record that would take a joint beyond its travel is the alarm LIMIT, one that the timers
/// cannot make TIMER_OVERFLOW, and nothing of it is handed out.
class PatternControl final : public control::ProgramControl {
 public:
  /// All must outlive the control. `records` gets the record of each motion that `sink` gets.
  PatternControl(const PatternMachine& machine, PatternLibrary& library, PatternQueue& records,
                 motion::MotionSink& sink);

  /// Stands at the head of the library's program, which has been loaded, with every counter at 0.
  /// `name` is what alarms call it.
  void start(std::string name);

  // Control
  control::Halt run(std::uint64_t instructions) override;
  void reset() override;
  [[nodiscard]] base::MachinePoint machine_position() const override {
    return base::MachinePoint(motors_.tip().numbers());
  }
  [[nodiscard]] base::AxisVector tool_length() const override { return {}; }
  [[nodiscard]] base::AxisVector work_origin() const override { return {}; }
  /// The records behind it count from where the last one has ended.
  void stand_at(const base::TipPoint& /*tip*/) override {}
  [[nodiscard]] bool can_be_moved() const override { return !is_open_; }
  [[nodiscard]] std::string running_program() const override { return name_; }
  [[nodiscard]] control::ModalView modal() const override { return {}; }
  [[nodiscard]] std::vector<std::string> modal_text(
      const control::ModalView& /*modal*/) const override {
    return {};
  }
  /// No record asks for a stop, none can be skipped, none calls.
  void set_optional_stop(bool /*on*/) override {}
  void set_block_skip(std::uint32_t /*levels*/) override {}
  void interrupt() override { miss_interrupt(); }

 private:
  // vm::Host
  vm::Verdict execute(const vm::CodePage& page, std::uint32_t block,
                      const double* registers) override;
  vm::Verdict read(double number, double& value) override;
  vm::Verdict write(double number, double value) override;
  void fault(vm::Fault fault) override;
  vm::Verdict end_of_code() override;

  // ProgramControl
  vm::Interpreter* interpreter() override { return &interpreter_; }
  std::string name_of_level(std::size_t /*level*/) const override { return name_; }
  bool single_block_traces() const override { return false; }
  void undo_block() override {}

  // Whereabouts
  [[nodiscard]] std::string program_name() const override { return name_; }
  std::string callers() override { return {}; }

  bool command(const drive::PatternRecord& record, bool ends_block);
  bool refuse(const PatternMotors& before, base::Diagnostic alarm);
  void hand_out(motion::Motion motion);

  const PatternMachine& machine_;
  PatternQueue& records_;
  motion::MotionSink& sink_;
  CountedOnly counted_;
  PatternMotors motors_;  // as the program has them
  vm::Interpreter interpreter_;
  std::string name_;
  bool is_open_ = false;
};

}  // namespace kerf::machine
