#pragma once

#include <memory>
#include <string>
#include <vector>

#include "control/core/outlet.hpp"
#include "control/core/program_control.hpp"
#include "control/plan/motion_maker.hpp"
#include "motion/axis_setup.hpp"

namespace kerf::control {

/// The control of a machine that makes planned motions, a block each. No variables, no calls, no
/// tool, no work offset, no modes.
class PlanControl final : public ProgramControl {
 public:
  /// All must outlive the control.
  PlanControl(const motion::AxisSetup& axes, bool checks_strokes, const MotionMaker& maker,
              Surroundings& surroundings, motion::MotionSink& sink);

  /// Stands before the first motion.
  void start();

  // Control
  Halt run(std::uint64_t instructions) override;
  void reset() override;
  [[nodiscard]] base::MachinePoint machine_position() const override {
    return base::MachinePoint(tip_.numbers());
  }
  [[nodiscard]] base::AxisVector tool_length() const override { return {}; }
  [[nodiscard]] base::AxisVector work_origin() const override { return {}; }
  [[nodiscard]] ModalView modal() const override { return {}; }
  [[nodiscard]] std::vector<std::string> modal_text(const ModalView& /*modal*/) const override {
    return {};
  }
  void stand_at(const base::TipPoint& tip) override { tip_ = tip; }
  [[nodiscard]] bool can_be_moved() const override { return true; }
  [[nodiscard]] std::vector<OpenCall> open_calls() override;
  void set_optional_stop(bool /*on*/) override {}
  void set_block_skip(std::uint32_t /*levels*/) override {}
  void interrupt() override { miss_interrupt(); }
  [[nodiscard]] bool pass_alarm() override { return false; }

 private:
  // vm::Host: there is no code.
  vm::Verdict execute(const vm::CodePage&, std::uint32_t, const double*) override;
  vm::Verdict read(double, double&) override { return vm::Verdict::stop; }
  vm::Verdict write(double, double) override { return vm::Verdict::stop; }
  void fault(vm::Fault) override {}
  vm::Verdict end_of_code() override { return vm::Verdict::stop; }

  // ProgramControl
  vm::Interpreter* interpreter() override { return nullptr; }
  [[nodiscard]] std::string name_of_level(std::size_t) const override { return maker_.name(); }
  [[nodiscard]] bool single_block_traces() const override { return false; }
  void undo_block() override {}

  // Whereabouts
  base::Place place() override { return base::place_of(block_); }
  base::BlockId block() override { return block_; }
  [[nodiscard]] std::string program_name() const override { return maker_.name(); }
  std::string callers() override { return {}; }

  [[nodiscard]] bool make(const motion::Motion& motion);
  [[nodiscard]] const motion::Motion* upcoming();

  const MotionMaker& maker_;
  motion::MotionSink& sink_;
  StrokeLimits strokes_;
  Outlet outlet_;
  base::TipPoint start_;
  base::TipPoint tip_;
  base::BlockId block_;
  std::unique_ptr<MotionStream> stream_;
  std::vector<motion::Motion> waiting_;
  std::size_t next_ = 0;
};

}  // namespace kerf::control
