#pragma once

#include <string>

#include "control/core/program_control.hpp"
#include "motion/motion.hpp"

namespace kerf::control {

/// The control of a language that is a list of records, a block each: no variables and no calls, no
/// tool, no work offset, no modes. No record asks for a stop, none can be skipped.
class RecordControl : public ProgramControl {
 public:
  // Control
  Halt run(std::uint64_t instructions) override;
  void reset() override;
  [[nodiscard]] base::AxisVector tool_length() const override { return {}; }
  [[nodiscard]] base::AxisVector work_origin() const override { return {}; }
  [[nodiscard]] ModalView modal() const override { return {}; }
  [[nodiscard]] std::vector<std::string> modal_text(const ModalView& /*modal*/) const override {
    return {};
  }
  void set_optional_stop(bool /*on*/) override {}
  void set_block_skip(std::uint32_t /*levels*/) override {}
  void interrupt() override { miss_interrupt(); }

 protected:
  /// Both must outlive the control.
  RecordControl(vm::CodeSource& records, motion::MotionSink& sink);

  /// Stands at the head of a program that alarms call `name`.
  void stand_at_head(vm::CodeId program, std::string name);
  /// What follows a record that was executed.
  [[nodiscard]] vm::Verdict behind_record();

  motion::MotionSink& sink_;

 private:
  // vm::Host: the code of such a language neither reads nor writes, and calculates nothing.
  vm::Verdict read(double number, double& value) override;
  vm::Verdict write(double number, double value) override;
  void fault(vm::Fault fault) override;

  // ProgramControl
  vm::Interpreter* interpreter() override { return &interpreter_; }
  std::string name_of_level(std::size_t /*level*/) const override { return name_; }
  bool single_block_traces() const override { return false; }

  // Whereabouts
  [[nodiscard]] std::string program_name() const override { return name_; }
  std::string callers() override { return {}; }

  vm::Interpreter interpreter_;
  std::string name_;
};

}  // namespace kerf::control
