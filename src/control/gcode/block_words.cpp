// The words of a block: their values, sorted by address, each with a meaning on this machine.
#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"
#include "control/gcode/controller.hpp"
#include "control/gcode/words/idle_words.hpp"
#include "lang/vm/value.hpp"

namespace kerf::control {
namespace {

using base::Code;
using gcode::Word;
using gcode::WordFlag;

constexpr std::uint32_t kAlwaysAllowed =
    Words::mask('D') | Words::mask('E') | Words::mask('F') | Words::mask('G') | Words::mask('H') |
    Words::mask('I') | Words::mask('J') | Words::mask('K') | Words::mask('L') | Words::mask('M') |
    Words::mask('N') | Words::mask('P') | Words::mask('Q') | Words::mask('R') | Words::mask('S') |
    Words::mask('T');

}  // namespace

// The block's words with their values; words whose value is null are dropped (VAR-7).
std::span<const Word> Controller::fetch(const gcode::GcodePage& page,
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

bool Controller::collect_g(const Word& word) {
  if (word.value < 0) return alarms_.raise(Code::illegal_minus, word.text);
  const double tenths = word.value * 10;
  const auto rounded = base::round_away(tenths);
  const bool exact = std::fabs(tenths - static_cast<double>(rounded)) < 1e-6;
  if (rounded > 65535 || (word.has(WordFlag::literal) && !exact)) {
    return alarms_.raise(Code::improper_g_code, word.text,
                         "G" + base::number_text(word.value) + " does not exist");
  }
  const auto code = static_cast<GCode>(rounded);
  return words_.put_g(code, state_.codes.find(code), word) ||
         alarms_.raise(Code::improper_g_code, word.text, "more than 16 G codes in one block");
}

// An M code that calls a subprogram has no other meaning and no strobe (CODE-2).
bool Controller::calls_subprogram(const Word& word) const {
  if (!codes_call_subprograms_ || calls_.codes_are_ordinary() || word.has(WordFlag::point))
    return false;
  const auto code = code_of(word);
  return code != 0 && std::find(parameters_.m_sub.begin(), parameters_.m_sub.end(), code) !=
                          parameters_.m_sub.end();
}

// The number of the external call is a parameter, and 0 there the dialect's own.
const FunctionRow* Controller::function_of(const Word& word) const {
  const std::int64_t code = code_of(word);
  const int external = parameters_.external_call_m;
  if (external != 0 && code == external) return state_.codes.external_call();
  const FunctionRow* const row = state_.codes.find_function(code);
  const bool is_free = external != 0 && row != nullptr && row->function == Function::external_call;
  return is_free ? nullptr : row;
}

// ",C" and ",R".
bool Controller::collect_corner(const Word& word) {
  if (word.letter != 'C' && word.letter != 'R') {
    return alarms_.raise(Code::improper_address, word.text, "a comma stands only before C and R");
  }
  if (corner_ != nullptr) return alarms_.raise(Code::corner_too_many, word.text);
  corner_ = &word;
  return true;
}

bool Controller::collect(std::span<const Word> block) {
  words_.clear();
  called_m_ = nullptr;
  corner_ = nullptr;
  for (const Word& word : block) {
    if (word.has(WordFlag::comma)) {
      if (!collect_corner(word)) return false;
      continue;
    }
    if (word.letter == 'G') {
      if (!collect_g(word)) return false;
    } else if (word.letter == 'M' && calls_subprogram(word)) {
      if (called_m_ != nullptr) return alarms_.raise(Code::two_sub_calls, word.text);
      called_m_ = &word;
    } else if (word.letter == 'M') {
      if (!words_.put_m(function_of(word), word))
        return alarms_.raise(Code::improper_address_word, word.text, "a block takes three M codes");
    } else {
      words_.put(word);
    }
  }
  return check_addresses(block);
}

// LEX-32: every letter must be an address of this machine.
bool Controller::check_addresses(std::span<const Word> block) {
  std::uint32_t allowed = kAlwaysAllowed | targets_.letters();
  if (parameters_.b_calls_program) allowed |= Words::mask('B');
  if ((words_.present() & ~allowed) == 0) return true;
  // G04 takes its time under X or U.
  if (words_.has_g(Meaning::dwell)) allowed |= Words::mask('X') | Words::mask('U');
  if ((words_.present() & ~allowed) == 0) return true;
  const auto bad = std::find_if(block.begin(), block.end(), [&](const Word& word) {
    return (Words::mask(word.letter) & ~allowed) != 0;
  });
  if (bad->letter == 'O') {
    return alarms_.raise(Code::expression_format, bad->text,
                         "a program number is written in digits");
  }
  return alarms_.raise(Code::improper_address, bad->text,
                       std::string("this machine has no axis ") + bad->letter);
}

// Accepted, but not acted upon. What its address never takes is an alarm all the same.
bool Controller::tell_idle_words() {
  const bool calls = codes_.call || codes_.external_call || codes_.return_ || codes_.interrupt_on ||
                     called_m_ != nullptr;
  const std::uint32_t idle = idle_words(words_, state_.modal, calls);
  if (idle == 0) return true;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if ((idle & Words::mask(letter)) == 0) continue;
    const Word& word = words_[letter];
    const bool whole = letter == 'L' || letter == 'P';
    if (whole && word.value < 0) return alarms_.raise(Code::illegal_minus, word.text);
    if (whole && word.has(WordFlag::point))
      return alarms_.raise(Code::illegal_decimal_point, word.text);
    if (!state_.assumptions.is_new(Assumed::idle_word + 1U + static_cast<unsigned>(letter - 'A')))
      continue;
    state_.assumptions.add(state_.line, std::string(1, letter) + base::number_text(word.value) +
                                            " is ignored: no code of its block takes " + letter);
  }
  return true;
}

}  // namespace kerf::control
