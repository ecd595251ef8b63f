#include "control/gcode/macro/arguments.hpp"

#include "lang/vm/value.hpp"

namespace kerf::control {
namespace {

using base::Code;
using gcode::Word;
using gcode::WordFlag;

constexpr int kMostSets = 10;

// Variable of each letter, A to Z; 0: no argument (G, L, N, O, P) or counted by sets (I, J, K).
constexpr std::uint8_t kVariable[26] = {1, 2, 3, 7,  8,  9,  0,  11, 4,  5,  6,  0,  13,
                                        0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};

// G66.1 only.
std::uint8_t every_block_variable(char letter) {
  switch (letter) {
    case 'G': return 10;
    case 'L': return 12;
    case 'N': return 14;
    case 'P': return 16;
    default: return 0;
  }
}

// Addresses whose numbers without a point count as they are (CALL-7).
bool counts_whole(char letter) {
  constexpr std::string_view kWhole = "DEFHMSTGLNP";
  return kWhole.find(letter) != std::string_view::npos;
}

double value_of(const Word& word, const ArgumentRules& rules) {
  const bool bare = word.has(WordFlag::literal) && !word.has(WordFlag::point);
  if (!bare || rules.calculator_point || counts_whole(word.letter)) return word.value;
  return word.value / (rules.inch ? 10000 : 1000);
}

}  // namespace

bool read_arguments(std::span<const Word> words, const ArgumentRules& rules, Alarms& alarms,
                    CallWords& call) {
  call.locals.fill(vm::kNull);
  int set = 1;
  int last = -1;
  for (const Word& word : words) {
    const char letter = word.letter;
    if (word.has(WordFlag::comma))
      return alarms.raise(Code::improper_address, word.text, "a comma word is no argument");
    std::uint8_t variable = kVariable[letter - 'A'];
    if (letter == 'P') call.program = &word;
    if (letter == 'L') call.repeats = &word;
    if (rules.every_block && variable == 0) variable = every_block_variable(letter);
    if (letter == 'G' && !rules.every_block) {
      return alarms.raise(Code::argument_g, word.text, "a G code cannot be an argument");
    }
    if (letter == 'O')
      return alarms.raise(Code::improper_address, word.text, "O cannot be an argument");
    if (letter >= 'I' && letter <= 'K' && !rules.single_ijk) {
      const int index = letter - 'I';
      if (index <= last) ++set;
      last = index;
      if (set > kMostSets) return alarms.raise(Code::too_many_ijk, word.text);
      variable = static_cast<std::uint8_t>(4 + 3 * (set - 1) + index);
    }
    if (variable != 0) call.locals[variable] = value_of(word, rules);
  }
  return true;
}

}  // namespace kerf::control
