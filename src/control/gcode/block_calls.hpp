#pragma once

#include <span>
#include <string>

#include "control/gcode/acts/auxiliary.hpp"
#include "control/gcode/block_reader.hpp"

namespace kerf::control {

/// The program calls of a block, made: macros that it calls, and what it calls behind its own
/// actions (docs/dialect/macros.md §6).
class BlockCalls {
 public:
  /// All must outlive this.
  BlockCalls(State& state, ProgramCalls& programs, const CallReader& reader)
      : state_(state), programs_(programs), reader_(reader) {}

  /// Macro call, modal call or call by code, with its arguments: the words behind the call's own.
  /// False: an alarm was raised.
  [[nodiscard]] bool call(std::span<const gcode::Word> arguments, const BlockCall& call,
                          const std::string& name);
  /// Subprograms, calls by M, T, S and B, and the modal macro of a motion, behind the block's own
  /// actions. False: an alarm was raised.
  [[nodiscard]] bool finish(const ReadBlock& block, const Auxiliary::Codes& codes, bool moved,
                            const std::string& name);
  /// M99, to the label of P if it has one. False: an alarm was raised.
  [[nodiscard]] bool return_from_program(const Words& words);

 private:
  void tell_endless();
  bool call_with(const CallWords& arguments, const BlockCall& call, const std::string& name);
  bool call_by_code(const ReadBlock& block);
  bool call_by_m(const ReadBlock& block);

  State& state_;
  ProgramCalls& programs_;
  const CallReader& reader_;
};

}  // namespace kerf::control
