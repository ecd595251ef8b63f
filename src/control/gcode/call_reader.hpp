#pragma once

#include <cstdint>
#include <span>

#include "control/gcode/macro/program_calls.hpp"

namespace kerf::control {

/// A program call that stands among the words of a block.
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

/// Which words of a block call programs (docs/dialect/macros.md §6).
class CallReader {
 public:
  /// Both must outlive the reader.
  CallReader(State& state, const ProgramCalls& calls) : state_(state), calls_(calls) {
    learn_parameters();
  }

  /// After a change of the parameters that say which codes call programs.
  void learn_parameters();
  /// Some G or M code calls a macro (6050, 6080).
  [[nodiscard]] bool codes_call_macros() const { return codes_call_macros_; }
  /// Some M code, T, S or B calls a subprogram here (6071, TCS, SCS, BCS).
  [[nodiscard]] bool codes_call_subprograms() const {
    return codes_call_subprograms_ && !calls_.codes_are_ordinary();
  }
  /// An M code that calls a subprogram, which has no other meaning and no strobe (CODE-2).
  [[nodiscard]] bool calls_subprogram(const gcode::Word& word) const;
  /// Whether the words before a call may stand there: codes that act as usual. False: an alarm was
  /// raised.
  [[nodiscard]] bool admits_before(std::span<const gcode::Word> words, const BlockCall& call) const;
  /// The call of a block, if it has one. False: an alarm was raised.
  [[nodiscard]] bool find(std::span<const gcode::Word> block, BlockCall& call) const;

 private:
  [[nodiscard]] BlockCall::Kind kind_of(std::int64_t code) const;
  [[nodiscard]] bool find_code_macro(const gcode::Word& word, std::size_t index,
                                     BlockCall& call) const;

  State& state_;
  const ProgramCalls& calls_;
  bool codes_call_macros_ = false;
  bool codes_call_subprograms_ = false;
};

}  // namespace kerf::control
