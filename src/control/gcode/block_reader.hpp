#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "control/gcode/acts/state.hpp"
#include "control/gcode/acts/targets.hpp"
#include "control/gcode/call_reader.hpp"
#include "control/gcode/words/dimensions.hpp"
#include "lang/gcode/page.hpp"

namespace kerf::control {

/// A block with its words read. Points into what it was read from.
struct ReadBlock {
  Words words;
  Dimensions dimensions;                  ///< of its line
  const gcode::Word* called_m = nullptr;  ///< its M code that calls a subprogram
  std::uint32_t number = 0;               ///< its N; 0: none
};

/// The words of a block: their values, sorted by address, each with a meaning on this machine.
class BlockReader {
 public:
  /// All must outlive the reader.
  BlockReader(State& state, const Targets& targets, const CallReader& calls)
      : state_(state), targets_(targets), calls_(calls) {}

  /// The block's words with their values; words whose value is null are dropped (VAR-7). Good until
  /// the next block.
  [[nodiscard]] std::span<const gcode::Word> fetch(const gcode::GcodePage& page,
                                                   const gcode::Statement& statement,
                                                   const double* registers);
  /// Sorts them; the block's number stays. False: an alarm was raised.
  [[nodiscard]] bool collect(std::span<const gcode::Word> words, ReadBlock& block);

 private:
  bool collect_word(const gcode::Word& word, ReadBlock& block);
  bool collect_g(const gcode::Word& word, ReadBlock& block);
  bool collect_m(const gcode::Word& word, ReadBlock& block);
  bool collect_dimension(const gcode::Word& word, ReadBlock& block);
  bool put_corner(const gcode::Word& word, ReadBlock& block);
  bool collect_bare(ReadBlock& block);
  bool take_bare(char letter, ReadBlock& block);
  [[nodiscard]] bool is_bare_dimension(char letter) const;
  bool check_addresses(std::span<const gcode::Word> words, const ReadBlock& block);
  [[nodiscard]] const FunctionRow* function_of(const gcode::Word& word) const;

  State& state_;
  const Targets& targets_;
  const CallReader& calls_;
  std::vector<gcode::Word> fetched_;
};

}  // namespace kerf::control
