#include "control/gcode/block_reader.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "lang/vm/value.hpp"

namespace kerf::control {
namespace {

using base::Code;
using gcode::Word;
using gcode::WordFlag;

constexpr std::uint32_t kAlwaysAllowed = Words::mask("DEFGHIJKLMNPQRST");

}  // namespace

std::span<const Word> BlockReader::fetch(const gcode::GcodePage& page,
                                         const gcode::Statement& statement,
                                         const double* registers) {
  const std::span<const Word> compiled =
      std::span(page.words).subspan(statement.first, statement.count);
  if (!statement.from_registers) return compiled;
  fetched_.clear();
  for (Word word : compiled) {
    if (word.has(WordFlag::from_register)) {
      const double value = registers[static_cast<std::size_t>(word.value)];
      if (vm::is_null(value)) continue;
      word.value = word.has(WordFlag::minus) ? -value : value;
    }
    fetched_.push_back(word);
  }
  return fetched_;
}

bool BlockReader::collect(std::span<const Word> words, ReadBlock& block) {
  block.words.clear();
  block.called_m = nullptr;
  block.corner = nullptr;
  for (const Word& word : words) {
    if (!collect_word(word, block)) return false;
  }
  return check_addresses(words, block);
}

bool BlockReader::collect_word(const Word& word, ReadBlock& block) {
  if (word.has(WordFlag::comma)) return collect_corner(word, block);
  if (word.letter == 'G') return collect_g(word, block);
  if (word.letter == 'M') return collect_m(word, block);
  block.words.put(word);
  return true;
}

bool BlockReader::collect_g(const Word& word, ReadBlock& block) {
  if (word.value < 0) return state_.alarms.raise(Code::illegal_minus, word.text);
  const double tenths = word.value * 10;
  const auto rounded = base::round_away(tenths);
  const bool exact = std::fabs(tenths - static_cast<double>(rounded)) < 1e-6;
  if (rounded > 65535 || (word.has(WordFlag::literal) && !exact)) {
    return state_.alarms.raise(Code::improper_g_code, word.text,
                               "G" + base::number_text(word.value) + " does not exist");
  }
  const auto code = static_cast<GCode>(rounded);
  return block.words.put_g(code, state_.codes.find(code), word) ||
         state_.alarms.raise(Code::improper_g_code, word.text, "more than 16 G codes in one block");
}

// A code that calls a subprogram has no other meaning.
bool BlockReader::collect_m(const Word& word, ReadBlock& block) {
  if (calls_.calls_subprogram(word)) {
    if (block.called_m != nullptr) return state_.alarms.raise(Code::two_sub_calls, word.text);
    block.called_m = &word;
    return true;
  }
  return block.words.put_m(function_of(word), word) ||
         state_.alarms.raise(Code::improper_address_word, word.text, "a block takes three M codes");
}

// The number of the external call is a parameter, and 0 there the dialect's own.
const FunctionRow* BlockReader::function_of(const Word& word) const {
  const std::int64_t code = code_of(word);
  const int external = state_.parameters.external_call_m;
  if (external != 0 && code == external) return state_.codes.external_call();
  const FunctionRow* const row = state_.codes.find_function(code);
  const bool is_free = external != 0 && row != nullptr && row->function == Function::external_call;
  return is_free ? nullptr : row;
}

// ",C" and ",R".
bool BlockReader::collect_corner(const Word& word, ReadBlock& block) {
  if (word.letter != 'C' && word.letter != 'R') {
    return state_.alarms.raise(Code::improper_address, word.text,
                               "a comma stands only before C and R");
  }
  if (block.corner != nullptr) return state_.alarms.raise(Code::corner_too_many, word.text);
  block.corner = &word;
  return true;
}

// LEX-32: every letter must be an address of this machine.
bool BlockReader::check_addresses(std::span<const Word> words, const ReadBlock& block) {
  std::uint32_t allowed = kAlwaysAllowed | targets_.letters();
  if (state_.parameters.b_calls_program) allowed |= Words::mask('B');
  if ((block.words.present() & ~allowed) == 0) return true;
  // G04 takes its time under X or U.
  if (block.words.has_g(Meaning::dwell)) allowed |= Words::mask("XU");
  if ((block.words.present() & ~allowed) == 0) return true;
  const auto bad = std::find_if(words.begin(), words.end(), [&](const Word& word) {
    return (Words::mask(word.letter) & ~allowed) != 0;
  });
  if (bad->letter == 'O') {
    return state_.alarms.raise(Code::expression_format, bad->text,
                               "a program number is written in digits");
  }
  return state_.alarms.raise(Code::improper_address, bad->text,
                             std::string("this machine has no axis ") + bad->letter);
}

}  // namespace kerf::control
