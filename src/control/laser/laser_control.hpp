#pragma once

#include <memory>
#include <string>
#include <vector>

#include "control/core/memory.hpp"
#include "control/core/parameters.hpp"
#include "control/core/program_control.hpp"
#include "control/laser/laser_moves.hpp"
#include "control/laser/laser_print.hpp"
#include "lang/basic/basic_program.hpp"
#include "lang/vm/interpreter.hpp"

namespace kerf::control {

/// The control of a laser that runs laser BASIC (docs/laser-basic.md): gives the statements of a
/// program their meaning. There are no blocks to skip, no optional stops and no tools; the work
/// origin is that of G54.
class LaserControl final : public ProgramControl {
 public:
  /// All must outlive the control.
  LaserControl(const Parameters& parameters, const motion::AxisSetup& axes, const Memory& memory,
               basic::BasicProgram& program, Surroundings& surroundings, motion::MotionSink& sink);

  /// Stands at the head of the program, which has been loaded and has no findings, with no variable
  /// but PI.
  void start();
  /// By the variable's number; before the start it has no effect.
  [[nodiscard]] double variable(std::uint32_t number);
  void set_variable(std::uint32_t number, double value);

  /// What an expression beside the program reads of the control; nothing: it would have to ask the
  /// operator.
  [[nodiscard]] std::optional<double> peek(double number) const;
  /// For such expressions. Precondition: started.
  [[nodiscard]] vm::Interpreter::Settings evaluation_settings();

  // Control
  Halt run(std::uint64_t instructions) override;
  void reset() override;
  [[nodiscard]] base::MachinePoint machine_position() const override {
    return base::MachinePoint(moves_.tip().numbers());
  }
  [[nodiscard]] base::AxisVector tool_length() const override { return {}; }
  [[nodiscard]] base::AxisVector work_origin() const override { return moves_.origin(); }
  void stand_at(const base::TipPoint& tip) override { moves_.stand_at(tip); }
  [[nodiscard]] bool can_be_moved() const override { return true; }
  [[nodiscard]] ModalView modal() const override;
  [[nodiscard]] std::vector<std::string> modal_text(const ModalView& modal) const override;
  void set_optional_stop(bool /*on*/) override {}
  void set_block_skip(std::uint32_t /*levels*/) override {}
  void interrupt() override { miss_interrupt(); }

  /// What programs without a number are called.
  static constexpr const char* kName = "O0000";

 private:
  // vm::Host
  vm::Verdict execute(const vm::CodePage& page, std::uint32_t block,
                      const double* registers) override;
  vm::Verdict read(double number, double& value) override;
  vm::Verdict write(double number, double value) override;
  void fault(vm::Fault fault) override;
  vm::Verdict end_of_code() override;
  vm::Verdict begin_block(const vm::CodePage& page, const vm::BlockMark& mark) override;

  // ProgramControl
  vm::Interpreter* interpreter() override { return interpreter_.get(); }
  std::string name_of_level(std::size_t /*level*/) const override { return kName; }
  // Behind every statement.
  bool single_block_traces() const override { return true; }
  void undo_block() override { outlet_.reset(); }

  // Whereabouts
  [[nodiscard]] std::string program_name() const override { return kName; }
  std::string callers() override;

  [[nodiscard]] bool move(const basic::Statement& statement, std::span<const double> arguments);
  void print(const basic::BasicPage& page, const basic::Statement& statement,
             const double* registers);
  vm::Verdict read_input(double& value);
  vm::Verdict end_of_program();

  const Parameters& parameters_;
  const Memory& memory_;
  basic::BasicProgram& program_;
  Surroundings& surroundings_;
  motion::MotionSink& sink_;
  Outlet outlet_;
  LaserMoves moves_;
  LaserPrint print_;
  std::vector<double> globals_;  // variables that do not live in registers
  std::unique_ptr<vm::Interpreter> interpreter_;
};

}  // namespace kerf::control
