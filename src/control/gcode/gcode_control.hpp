#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "control/core/program_control.hpp"
#include "control/gcode/acts/state.hpp"
#include "control/gcode/block_acts.hpp"
#include "control/gcode/block_calls.hpp"
#include "control/gcode/block_memory.hpp"
#include "control/gcode/block_reader.hpp"
#include "control/gcode/call_reader.hpp"
#include "control/gcode/codes/modal_list.hpp"
#include "control/gcode/macro/interrupt.hpp"
#include "control/gcode/macro/printer.hpp"
#include "control/gcode/macro/program_calls.hpp"
#include "control/gcode/macro/system_variables.hpp"
#include "control/gcode/path/block_buffer.hpp"
#include "control/gcode/shape_blocks.hpp"
#include "lang/gcode/code_library.hpp"
#include "lang/gcode/math_rules.hpp"
#include "lang/vm/interpreter.hpp"

namespace kerf::control {

/// The control of a machining centre or of a lathe: executes the blocks that the interpreter hands
/// it and emits what the machine must do. Reads all its settings from the machine; knows neither
/// time nor files.
class GcodeControl : public ProgramControl {
 public:
  /// `codes`: of the dialect.
  GcodeControl(const CodeTable& codes, const Parameters& parameters, const motion::AxisSetup& axes,
               Memory& memory, gcode::CodeLibrary& library, ProgramFinder& finder,
               Surroundings& surroundings, motion::MotionSink& sink);

  /// Where a program ends: by M02, M30 or M99, or else it is an alarm; of an entry in MDI also
  /// where its text does.
  enum class Ends : std::uint8_t { by_code, with_text };
  /// Power-on state of everything but memory and position, standing at the head of `main`.
  void start(vm::CodeId main, Ends ends = Ends::by_code);

  [[nodiscard]] const Coordinates& coordinates() const { return state_.coordinates; }
  /// What the path that goes out is compensated for; nothing: it is the programmed one.
  [[nodiscard]] std::optional<Cutter> cutter() const { return state_.path.cutter(); }
  /// What G92 has left behind, which outlives a reset.
  void set_shift(const base::AxisVector& shift) { state_.coordinates.set_shift(shift); }
  /// Offsets in the memory were changed by the operator.
  void offsets_changed() { state_.coordinates.offsets_changed(); }
  /// A variable as a program would read it, without an alarm; nothing: it cannot be read.
  [[nodiscard]] std::optional<double> peek(double number);
  /// For expressions beside the program.
  [[nodiscard]] vm::Interpreter::Settings evaluation_settings();
  [[nodiscard]] std::span<double> first_level_locals() {
    return interpreter_.locals_of_first_level();
  }
  [[nodiscard]] std::span<double> running_locals() { return interpreter_.locals(); }

  // Control

  Halt run(std::uint64_t instructions) override;
  /// Volatile variables vacant; offsets and the G92 shift stay.
  void reset() override;
  /// As #5021 reads them.
  [[nodiscard]] base::MachinePoint machine_position() const override;
  [[nodiscard]] base::AxisVector tool_length() const override {
    return state_.coordinates.length();
  }
  [[nodiscard]] base::AxisSet commanded() const override { return state_.commanded; }
  [[nodiscard]] std::optional<motion::Plane> plane() const override { return state_.modal.plane(); }
  [[nodiscard]] WorkSystem work_system() const override { return state_.coordinates.work(); }
  [[nodiscard]] base::AxisVector work_origin() const override {
    return state_.coordinates.origin();
  }
  void stand_at(const base::TipPoint& tip) override;
  [[nodiscard]] bool can_be_moved() const override { return !state_.path.holds_moves(); }
  [[nodiscard]] std::string running_program() const override { return programs_.running_name(); }
  [[nodiscard]] ModalView modal() const override { return state_.modal_view(); }
  [[nodiscard]] std::vector<std::string> modal_text(const ModalView& modal) const override {
    return modal_list(modal);
  }
  [[nodiscard]] const std::vector<CycleCount>& cycles() const override {
    return state_.cycles.list();
  }
  void set_optional_stop(bool on) override { optional_stop_ = on; }
  void set_block_skip(std::uint32_t levels) override { interpreter_.set_switches(levels); }
  void interrupt() override { interrupt_.signal(); }
  void allow_passing() override {
    ProgramControl::allow_passing();
    block_memory_.switch_on();
  }

  /// Writes a variable from outside, before the start: `#number`. Failure: why not.
  [[nodiscard]] base::Outcome<void> set_variable(std::uint32_t number, double value) {
    return variables_.set(number, value);
  }

  // vm::Host
  vm::Verdict execute(const vm::CodePage& page, std::uint32_t block,
                      const double* registers) override;
  vm::Verdict read(double number, double& value) override;
  vm::Verdict write(double number, double value) override;
  void fault(vm::Fault fault) override;
  vm::Verdict end_of_code() override;
  vm::Verdict begin_block(const vm::CodePage& page, const vm::BlockMark& mark) override;

 private:
  // ProgramControl
  vm::Interpreter* interpreter() override { return &interpreter_; }
  std::string name_of_level(std::size_t level) const override { return programs_.name_at(level); }
  base::ProgramNumber number_of_level(std::size_t level) const override {
    return base::ProgramNumber{programs_.number_at(level)};
  }
  // Behind every NC block; behind macro statements only with parameter SBM.
  bool single_block_traces() const override { return parameters_.stop_at_macro; }
  void undo_block() override;

  // Whereabouts
  // Before the start no program runs that a wrong variable could be told of.
  [[nodiscard]] bool started() const { return interpreter_.depth() > 0; }
  std::string program_name() const override { return started() ? programs_.running_name() : ""; }
  std::string callers() override { return programs_.callers(); }

  bool resume();
  void settle_alarm();
  void learn_parameters();

  // A block of words, from its begin to its end.
  void begin(const gcode::GcodePage& page, const gcode::Statement& statement);
  vm::Verdict execute_words(const gcode::GcodePage& page, const gcode::Statement& statement,
                            const double* registers);
  vm::Verdict execute_call(std::span<const gcode::Word> words, const BlockCall& call);
  bool call_program(std::span<const gcode::Word> words, const BlockCall& call);
  vm::Verdict continue_block();
  vm::Verdict go_to_shape();
  vm::Verdict come_behind_shape();
  vm::Verdict rough_shape();
  vm::Verdict finish_shape_block();
  vm::Verdict finish_block();
  bool come_to_optional_stop();
  [[nodiscard]] Halt halt_of_block() const;
  bool stop_behind(Halt halt);
  vm::Verdict end_program();
  vm::Verdict end_block();
  bool finish_calls();
  vm::Verdict stopped(Halt halt);
  vm::Verdict end_of_entry();

  vm::Verdict raise_user_alarm(double number);
  vm::Verdict show_message(double number);
  std::string comment_of_block();
  bool take_interrupt();
  vm::Verdict answer_interrupt();

  Parameters parameters_;
  const motion::AxisSetup& axes_;
  gcode::CodeLibrary& library_;
  Surroundings& surroundings_;
  gcode::MathRules math_;
  BlockBuffer buffer_;
  State state_;
  vm::Interpreter interpreter_;
  ProgramCalls programs_;
  CallReader call_reader_;
  BlockActs acts_;
  BlockReader reader_;
  ShapeBlocks shapes_;
  BlockCalls calls_;
  SystemVariables variables_;
  Printer printer_;
  Interrupt interrupt_;
  BlockMemory block_memory_;

  ReadBlock block_;
  std::span<const gcode::Word> block_words_;  // it was read from these
  std::string call_name_;
  bool mid_block_ = false;         // a block waits for its cycle or for the axes to go on
  bool at_optional_stop_ = false;  // it waits for the axes to come to its M01
  bool in_block_ = false;          // an NC block has begun and is not over
  bool transferred_ = false;       // the block has called or returned
  Ends ends_ = Ends::by_code;
  bool optional_stop_ = false;
};

}  // namespace kerf::control
