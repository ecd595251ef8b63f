#pragma once

#include "control/core/program_control.hpp"
#include "control/teach/taught_moves.hpp"
#include "lang/teach/teach_library.hpp"
#include "lang/vm/interpreter.hpp"

namespace kerf::control {

/// The control of a machine that goes to taught points: executes the records of a .tch file, one
/// block each, as TaughtMoves says. There are no variables, no calls, no tool and no work offset:
/// points are where the machine was.
class TeachControl final : public ProgramControl {
 public:
  /// All must outlive the control.
  TeachControl(const motion::AxisSetup& axes, const TaughtFor& machine,
               teach::TeachLibrary& library, Surroundings& surroundings, motion::MotionSink& sink);

  /// Stands at the head of the library's program, which has been loaded. `name` is what alarms call
  /// it.
  void start(std::string name);

  // Control
  Halt run(std::uint64_t instructions) override;
  void reset() override;
  [[nodiscard]] base::MachinePoint machine_position() const override {
    return base::MachinePoint(moves_.tip().numbers());
  }
  [[nodiscard]] base::AxisVector tool_length() const override { return {}; }
  [[nodiscard]] base::AxisVector work_origin() const override { return {}; }
  void stand_at(const base::TipPoint& tip) override { moves_.stand_at(tip); }
  [[nodiscard]] bool can_be_moved() const override { return true; }
  [[nodiscard]] std::string running_program() const override { return name_; }
  [[nodiscard]] ModalView modal() const override { return {}; }
  [[nodiscard]] std::vector<std::string> modal_text(const ModalView& /*modal*/) const override {
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
  void undo_block() override { outlet_.reset(); }

  // Whereabouts
  [[nodiscard]] std::string program_name() const override { return name_; }
  std::string callers() override { return {}; }

  motion::MotionSink& sink_;
  bool checks_strokes_;
  StrokeLimits strokes_;
  Outlet outlet_;
  TaughtMoves moves_;
  vm::Interpreter interpreter_;
  std::string name_;
};

}  // namespace kerf::control
