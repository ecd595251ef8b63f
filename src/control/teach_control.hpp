#pragma once

#include "control/control.hpp"
#include "control/taught_moves.hpp"
#include "lang/teach/teach_library.hpp"
#include "lang/vm/interpreter.hpp"

namespace kerf::control {

/// The control of a machine that goes to taught points: executes the records of a .tch file, one
/// block each, as TaughtMoves says. There are no variables, no calls, no tool and no work offset:
/// points are where the machine was.
class TeachControl final : public Control, private vm::Host, private Whereabouts {
 public:
  /// All must outlive the control.
  TeachControl(const AxisSetup& axes, const TaughtFor& machine, teach::TeachLibrary& library,
               Surroundings& surroundings, MotionSink& sink);

  /// Stands at the head of the library's program, which has been loaded. `name` is what alarms call
  /// it.
  void start(std::string name);

  // Control
  Halt run(std::uint64_t instructions) override;
  void reset() override;
  [[nodiscard]] Halt halt() const override { return halt_; }
  [[nodiscard]] const std::optional<base::Diagnostic>& alarm() const override {
    return alarms_.alarm();
  }
  [[nodiscard]] const Assumptions& assumptions() const override { return assumptions_; }
  [[nodiscard]] std::uint64_t blocks() const override { return blocks_; }
  [[nodiscard]] base::AxisVector machine_position() const override { return moves_.tip(); }
  [[nodiscard]] base::AxisVector tool_length() const override { return {}; }
  [[nodiscard]] base::AxisVector work_origin() const override { return {}; }
  [[nodiscard]] base::Place standing_at() override { return place(); }
  [[nodiscard]] std::string running_program() const override { return name_; }
  void set_single_block(bool on) override { single_block_ = on; }
  /// No record asks for a stop, none can be skipped, none calls.
  void set_optional_stop(bool /*on*/) override {}
  void set_block_skip(std::uint32_t /*levels*/) override {}
  void interrupt() override {}
  void observe_blocks(BlockObserver observer) override;

 private:
  // vm::Host
  vm::Verdict execute(const vm::CodePage& page, std::uint32_t block,
                      const double* registers) override;
  bool read(double number, double& value) override;
  vm::Verdict write(double number, double value) override;
  void fault(vm::Fault fault) override;
  void failure(const base::Diagnostic& diagnostic) override;
  vm::Verdict end_of_code() override;
  vm::Verdict begin_block(const vm::CodePage& page, const vm::BlockMark& mark) override;

  // Whereabouts
  base::Place place() override;
  [[nodiscard]] std::string program_name() const override { return name_; }
  std::string callers() override { return {}; }

  vm::Verdict stop(Halt halt, vm::Verdict verdict);

  MotionSink& sink_;
  Alarms alarms_;
  Assumptions assumptions_;
  Outlet outlet_;
  TaughtMoves moves_;
  vm::Interpreter interpreter_;
  BlockObserver observer_;
  std::string name_;
  std::uint64_t blocks_ = 0;
  Halt halt_ = Halt::none;
  bool single_block_ = false;
};

}  // namespace kerf::control
