#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "control/gcode/acts/state.hpp"
#include "control/gcode/macro/arguments.hpp"
#include "lang/gcode/code_library.hpp"
#include "lang/vm/interpreter.hpp"
#include "lang/vm/value.hpp"

namespace kerf::control {

/// Finds programs by number or name; may load files to do so.
class ProgramFinder {
 public:
  virtual ~ProgramFinder() = default;
  [[nodiscard]] virtual std::optional<vm::CodeId> find_program(std::uint32_t number) = 0;
  [[nodiscard]] virtual std::optional<vm::CodeId> find_program(const std::string& name) = 0;
  /// For M198: in the external folders only.
  [[nodiscard]] virtual std::optional<vm::CodeId> find_external(std::uint32_t number) = 0;
};

/// Calls, returns and modal calls: who runs, how deep, and what comes back (docs/dialect.md §6).
///
/// A motion in a program of modal depth d triggers the modal macro M(k-d) of the k that are
/// stacked, and that macro runs at depth d + 1; programs called otherwise inherit the depth of
/// their caller (CALL-17).
class ProgramCalls {
 public:
  /// How a program came to run.
  enum class Kind : std::uint8_t {
    main,
    subprogram,  ///< M98
    external,    ///< M198
    macro,       ///< G65
    modal,       ///< after a motion under G66, or per block under G66.1
    code_macro,  ///< a G or M code that calls a macro
    code_sub,    ///< an M, T, S or B code that calls a subprogram
    interrupt    ///< M96
  };

  ProgramCalls(State& state, vm::Interpreter& interpreter, gcode::CodeLibrary& library,
               ProgramFinder& finder)
      : state_(state), interpreter_(interpreter), library_(library), finder_(finder) {}

  void start(vm::CodeId main);

  // Each raises an alarm and returns false when the program is missing or nests too deeply.

  /// G65, or the call by a G or M code when `number` is given.
  [[nodiscard]] bool call_macro(const CallWords& call, const std::string& name, Kind kind,
                                std::optional<std::uint32_t> number);
  /// M98 or M198 with its P and L.
  [[nodiscard]] bool call_subprogram(const Words& words, const std::string& name, Kind kind);
  /// A subprogram of fixed number, without arguments.
  [[nodiscard]] bool call_fixed(std::uint32_t number, std::int64_t repeats, Kind kind);

  /// G66, G66.1.
  [[nodiscard]] bool push_modal(const CallWords& call, const std::string& name, bool every_block);
  /// G67. False: PS1100.
  [[nodiscard]] bool pop_modal();
  /// The block has commanded axis movement: calls the modal macro that it triggers, if any.
  [[nodiscard]] bool trigger();
  /// G66.1 is on where the program stands: every block is a call.
  [[nodiscard]] bool every_block() const;
  [[nodiscard]] bool call_every_block(const CallWords& call);
  [[nodiscard]] bool modal_active() const { return !modal_.empty(); }

  /// M99, with the label of P if it has one. False: PS0078.
  [[nodiscard]] bool return_from_program(std::optional<std::uint32_t> label);

  /// Codes that call programs are ordinary here (CODE-1).
  [[nodiscard]] bool codes_are_ordinary() const { return levels_.back().codes_ordinary; }
  [[nodiscard]] bool in_main() const { return levels_.size() == 1; }
  [[nodiscard]] vm::CodeId running() const { return levels_.back().code; }
  /// The O number of the program at a level, 0: main.
  [[nodiscard]] std::uint32_t number_at(std::size_t level) const {
    return library_.entry(levels_[level].code).number;
  }
  /// "O0001", or the program's name; empty before one has begun.
  [[nodiscard]] std::string running_name() const {
    return levels_.empty() ? std::string() : name_at(levels_.size() - 1);
  }
  /// The name of the program at a level, 0: main.
  [[nodiscard]] std::string name_at(std::size_t level) const;
  /// "called from line 5 of O0001", from the nearest caller to the main program; empty there.
  [[nodiscard]] std::string callers() const;

 private:
  struct Level {
    Kind kind = Kind::main;
    vm::CodeId code{};
    std::int64_t repeats_left = 0;
    std::size_t modal_depth = 0;
    bool codes_ordinary = false;
    int modal = -1;  ///< index of the modal call whose locals these are
  };
  struct ModalCall {
    vm::CodeId code{};
    std::int64_t repeats = 1;
    LocalVariables locals{};
    bool every_block = false;
  };

  bool find(const gcode::Word* p, const std::string& name, vm::CodeId& code);
  bool repeats_of(const gcode::Word* l, std::int64_t& repeats);
  bool split_subprogram(const Words& words, std::uint32_t& number, std::int64_t& repeats,
                        Kind kind);
  bool start_at(const Words& words);
  bool enter(const Level& level, const LocalVariables* locals);
  bool check_depth(Kind kind);
  bool call_modal(std::size_t index, const LocalVariables& locals);
  void keep_modal_locals(const Level& level);
  [[nodiscard]] static bool has_own_locals(Kind kind);

  State& state_;
  vm::Interpreter& interpreter_;
  gcode::CodeLibrary& library_;
  ProgramFinder& finder_;
  std::vector<Level> levels_;
  std::vector<ModalCall> modal_;
};

}  // namespace kerf::control
