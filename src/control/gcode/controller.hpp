#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "control/core/program_control.hpp"
#include "control/gcode/acts/auxiliary.hpp"
#include "control/gcode/acts/data_setting.hpp"
#include "control/gcode/acts/references.hpp"
#include "control/gcode/acts/settings.hpp"
#include "control/gcode/acts/state.hpp"
#include "control/gcode/block_memory.hpp"
#include "control/gcode/cycles/canned_cycle.hpp"
#include "control/gcode/macro/program_calls.hpp"
#include "control/gcode/macro/system_variables.hpp"
#include "control/gcode/path/block_buffer.hpp"
#include "lang/gcode/code_library.hpp"
#include "lang/gcode/math_rules.hpp"
#include "lang/vm/interpreter.hpp"

namespace kerf::control {

/// The control of a machining centre: executes the blocks that the interpreter hands it and emits
/// what the machine must do. Reads all its settings from the machine; knows neither time nor files.
class Controller : public ProgramControl, public vm::Host {
 public:
  Controller(const Parameters& parameters, const motion::AxisSetup& axes, Memory& memory,
             gcode::CodeLibrary& library, ProgramFinder& finder, Surroundings& surroundings,
             motion::MotionSink& sink);

  /// Where a program ends: by M02, M30 or M99, or else it is an alarm; of an entry in MDI also
  /// where its text does.
  enum class Ends : std::uint8_t { by_code, with_text };
  /// Power-on state of everything but memory and position, standing at the head of `main`.
  void start(vm::CodeId main, Ends ends = Ends::by_code);

  [[nodiscard]] const Coordinates& coordinates() const { return state_.coordinates; }
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
  [[nodiscard]] base::AxisVector machine_position() const override;
  [[nodiscard]] base::AxisVector tool_length() const override {
    return state_.coordinates.length();
  }
  [[nodiscard]] base::AxisVector work_origin() const override {
    return state_.coordinates.origin();
  }
  void stand_at(const base::AxisVector& tip) override;
  [[nodiscard]] bool can_be_moved() const override { return !state_.path.holds_moves(); }
  [[nodiscard]] std::string running_program() const override { return calls_.running_name(); }
  [[nodiscard]] ModalView modal() const override;
  [[nodiscard]] std::vector<std::string> modal_text(const ModalView& modal) const override;
  void set_optional_stop(bool on) override { optional_stop_ = on; }
  void set_block_skip(std::uint32_t levels) override { interpreter_.set_switches(levels); }
  void interrupt() override { interrupt_pending_ = true; }
  void allow_passing() override {
    ProgramControl::allow_passing();
    block_memory_.switch_on();
  }

  /// Writes a variable from outside, before the start: `#number`. Failure: why not.
  [[nodiscard]] base::Outcome<void> set_variable(std::uint32_t number, double value);

  // vm::Host
  vm::Verdict execute(const vm::CodePage& page, std::uint32_t block,
                      const double* registers) override;
  vm::Verdict read(double number, double& value) override;
  vm::Verdict write(double number, double value) override;
  void fault(vm::Fault fault) override;
  void failure(const base::Diagnostic& diagnostic) override;
  vm::Verdict end_of_code() override;
  vm::Verdict begin_block(const vm::CodePage& page, const vm::BlockMark& mark) override;

 private:
  // ProgramControl
  vm::Interpreter* interpreter() override { return &interpreter_; }
  std::string name_of_level(std::size_t level) const override { return calls_.name_at(level); }
  // Behind every NC block; behind macro statements only with parameter SBM.
  bool single_block_traces() const override { return parameters_.stop_at_macro; }
  void undo_block() override;

  // Whereabouts
  // Before the start no program runs that a wrong variable could be told of.
  [[nodiscard]] bool started() const { return interpreter_.depth() > 0; }
  std::string program_name() const override { return started() ? calls_.running_name() : ""; }
  std::string callers() override;

  struct BlockCall {
    enum class Kind : std::uint8_t {
      none,
      macro,
      modal,
      every_block,
      code_macro,
      ends  ///< G67: what stands in the block is no call
    } kind = Kind::none;
    std::size_t first_argument = 0;  ///< index behind the call's own word
    std::uint32_t program = 0;       ///< of a call by code
    const gcode::Word* word = nullptr;
  };

  bool resume();
  void settle_alarm();
  void begin(const gcode::GcodePage& page, const gcode::Statement& statement);
  vm::Verdict execute_words(const gcode::GcodePage& page, const gcode::Statement& statement,
                            const double* registers);
  std::span<const gcode::Word> fetch(const gcode::GcodePage& page,
                                     const gcode::Statement& statement, const double* registers);
  bool collect(std::span<const gcode::Word> block);
  bool collect_g(const gcode::Word& word);
  bool collect_corner(const gcode::Word& word);
  bool request_corner();
  [[nodiscard]] const FunctionRow* function_of(const gcode::Word& word) const;
  [[nodiscard]] bool calls_subprogram(const gcode::Word& word) const;
  bool check_addresses(std::span<const gcode::Word> block);
  [[nodiscard]] BlockCall::Kind call_of(int code) const;
  bool find_call(std::span<const gcode::Word> block, BlockCall& call);
  bool call_program(std::span<const gcode::Word> block, const BlockCall& call,
                    const std::string& name);
  bool call_by_code(const Words& words);

  [[nodiscard]] bool is_plain_move() const;
  bool plain_move();
  bool execute_block(const std::string& name);
  bool tell_idle_words();
  bool check_block(const Words::G* one_shot);
  bool move(const Words::G* one_shot, bool& moved);
  bool one_shot(const Words::G& g, bool& moved);
  bool dwell();
  bool select_cycle(bool& plain);
  vm::Verdict continue_block();
  vm::Verdict finish_block();
  bool come_to_optional_stop();
  vm::Verdict end_block();
  bool finish_calls();
  bool set_interrupt();
  vm::Verdict stopped(Halt halt);
  vm::Verdict end_of_entry();

  vm::Verdict print(const gcode::GcodePage& page, const gcode::Statement& statement,
                    const double* registers);
  vm::Verdict raise_user_alarm(double number);
  vm::Verdict show_message(double number);
  std::string comment_of_block();
  bool take_interrupt();
  vm::Verdict answer_interrupt();
  void learn_parameters();
  void learn_calling_codes();

  Parameters parameters_;
  const motion::AxisSetup& axes_;
  gcode::CodeLibrary& library_;
  Surroundings& surroundings_;
  gcode::MathRules math_;
  BlockBuffer buffer_;
  State state_;
  vm::Interpreter interpreter_;
  Targets targets_;
  Moves moves_;
  Settings settings_;
  DataSetting data_setting_;
  References references_;
  Auxiliary auxiliary_;
  CannedCycle cycle_;
  ProgramCalls calls_;
  SystemVariables variables_;

  BlockMemory block_memory_;
  Words words_;
  const gcode::Word* corner_ = nullptr;    // the block's ",C" or ",R"
  const gcode::Word* called_m_ = nullptr;  // the block's M code that calls a subprogram
  std::vector<gcode::Word> fetched_;
  Auxiliary::Codes codes_;
  std::string call_name_;
  std::string printed_;
  bool codes_call_macros_ = false;       // some G or M code does (6050, 6080)
  bool codes_call_subprograms_ = false;  // some M code, T, S or B does (6071, TCS, SCS, BCS)
  bool mid_block_ = false;               // a block waits for its cycle or for the axes to go on
  bool at_optional_stop_ = false;        // it waits for the axes to come to its M01
  std::uint32_t block_number_ = 0;       // the block's N; 0: none
  bool in_block_ = false;                // an NC block has begun and is not over
  bool moved_ = false;                   // the block has commanded axis movement
  bool transferred_ = false;             // the block has called or returned
  Ends ends_ = Ends::by_code;
  bool optional_stop_ = false;
  bool interrupt_pending_ = false;
  std::uint32_t interrupt_program_ = 0;  // of M96; 0: not allowed
};

}  // namespace kerf::control
