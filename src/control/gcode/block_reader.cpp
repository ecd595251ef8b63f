#include "control/gcode/block_reader.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"
#include "lang/vm/value.hpp"

namespace kerf::control {
namespace {

using base::Code;
using gcode::Word;
using gcode::WordFlag;

constexpr std::uint32_t kAlwaysAllowed = Words::mask("DEFGHIJKLMNPQRST");
constexpr std::uint32_t kBareDimensions = Words::mask("ACRIK");

// What a code of the machine's spindle does to it.
Function function_of_spindle(const SpindleSettings& spindle, std::int64_t code) {
  if (code == spindle.clockwise) return Function::spindle_clockwise;
  if (code == spindle.counterclockwise) return Function::spindle_counterclockwise;
  return code == spindle.stop ? Function::spindle_stop : Function::spindle_orient;
}

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
  block.dimensions = {};
  for (const Word& word : words) {
    if (!collect_word(word, block)) return false;
  }
  return collect_bare(block) && check_addresses(words, block);
}

bool BlockReader::collect_word(const Word& word, ReadBlock& block) {
  if (word.has(WordFlag::comma)) return collect_dimension(word, block);
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
  const GCode code = state_.parameters.machine_codes.meant_by(static_cast<GCode>(rounded));
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
  const MachineCodes& machine = state_.parameters.machine_codes;
  if (machine.function_of(code)) return nullptr;
  if (const SpindleSettings* const spindle = machine.spindle_with(code))
    return state_.codes.with(function_of_spindle(*spindle, code));
  const int external = state_.parameters.external_call_m;
  if (external != 0 && code == external) return state_.codes.external_call();
  const FunctionRow* const row = state_.codes.find_function(code);
  const bool is_free = external != 0 && row != nullptr && row->function == Function::external_call;
  return is_free ? nullptr : row;
}

// ",C" and ",R", of a lathe also ",A".
bool BlockReader::collect_dimension(const Word& word, ReadBlock& block) {
  const bool drawing = state_.codes.habits().drawing_dimensions;
  if (word.letter == 'C' || word.letter == 'R') return put_corner(word, block);
  if (word.letter != 'A' || !drawing) {
    return state_.alarms.raise(
        Code::improper_address, word.text,
        drawing ? "a comma stands only before A, C and R" : "a comma stands only before C and R");
  }
  if (block.dimensions.angle != nullptr)
    return state_.alarms.raise(Code::corner_too_many, word.text);
  block.dimensions.angle = &word;
  return true;
}

bool BlockReader::put_corner(const Word& word, ReadBlock& block) {
  if (block.dimensions.corner != nullptr)
    return state_.alarms.raise(Code::corner_too_many, word.text);
  block.dimensions.corner = &word;
  return true;
}

// Of a lathe: words of a line that are its dimensions without a comma. Where nothing moves they
// are words as any other.
bool BlockReader::collect_bare(ReadBlock& block) {
  if (!state_.codes.habits().drawing_dimensions || !block.words.has_any(kBareDimensions) ||
      state_.parameter_entry || !cuts_line(block.words, state_.modal))
    return true;
  if (!take_bare('A', block)) return false;
  if (block.dimensions.angle == nullptr && !block.words.has_any(targets_.letters())) return true;
  return take_bare('C', block) && take_bare('R', block) && take_bare('I', block) &&
         take_bare('K', block);
}

bool BlockReader::take_bare(char letter, ReadBlock& block) {
  if (!block.words.has(letter) || !is_bare_dimension(letter)) return true;
  for (const Words::G* g = block.words.g_begin(); g != block.words.g_end(); ++g) {
    if (g->row != nullptr &&
        std::string_view(g->row->letters).find(letter) != std::string_view::npos)
      return true;  // another code's
  }
  const Word& word = block.words[letter];
  block.words.forget(letter);
  if (letter == 'I' || letter == 'K') return put_corner(word, block);
  state_.assume(Assumed::bare_corner,
                "A, C and R of a line without a comma are its angle, its chamfer and its corner");
  if (letter != 'A') return put_corner(word, block);
  if (block.dimensions.angle != nullptr)
    return state_.alarms.raise(Code::corner_too_many, word.text);
  block.dimensions.angle = &word;
  return true;
}

// I and K are the legs of a chamfer.
bool BlockReader::is_bare_dimension(char letter) const {
  return letter == 'I' || letter == 'K' || state_.parameters.bare_corners ||
         (targets_.letters() & Words::mask(letter)) == 0;
}

// LEX-32: every letter must be an address of this machine.
bool BlockReader::check_addresses(std::span<const Word> words, const ReadBlock& block) {
  std::uint32_t allowed = kAlwaysAllowed | targets_.letters();
  if (state_.parameters.b_calls_program) allowed |= Words::mask('B');
  if ((block.words.present() & ~allowed) == 0) return true;
  // G04 takes its time under X or U, G10 of a lathe changes of the nose under C, G76 the angle of
  // the tip under A.
  if (block.words.has_g(Meaning::dwell)) allowed |= Words::mask("XU");
  if (block.words.has_g(Meaning::compound_thread)) allowed |= Words::mask('A');
  if (block.words.has_g(Meaning::data_setting) && state_.codes.habits().tool_brings_offset)
    allowed |= Words::mask("CYV");
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
