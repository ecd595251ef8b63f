#include "control/gcode/call_reader.hpp"

#include <algorithm>
#include <limits>

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"

namespace kerf::control {
namespace {

using base::Code;
using gcode::Word;
using Kind = BlockCall::Kind;

constexpr std::uint32_t kFirstGMacro = 9010;
constexpr std::uint32_t kFirstMMacro = 9020;

// Where `code` stands in a parameter's list of calling codes; 0 in it is none.
template <typename Codes>
std::optional<std::uint32_t> place_of(const Codes& codes, std::int64_t code) {
  const auto found = std::find(codes.begin(), codes.end(), code);
  if (code == 0 || found == codes.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - codes.begin());
}

}  // namespace

void CallReader::learn_parameters() {
  const auto any = [](const auto& codes) {
    return std::any_of(codes.begin(), codes.end(), [](int code) { return code != 0; });
  };
  const Parameters& parameters = state_.parameters;
  codes_call_macros_ = any(parameters.g_macro) || any(parameters.m_macro);
  codes_call_subprograms_ = any(parameters.m_sub) || parameters.t_calls_program ||
                            parameters.s_calls_program || parameters.b_calls_program;
}

bool CallReader::calls_subprogram(const Word& word) const {
  if (!codes_call_subprograms() || word.has(gcode::WordFlag::point)) return false;
  return place_of(state_.parameters.m_sub, code_of(word)).has_value();
}

BlockCall::Kind CallReader::kind_of(std::int64_t code) const {
  if (code < 0 || code > std::numeric_limits<GCode>::max()) return Kind::none;
  const CodeRow* const row = state_.codes.find(static_cast<GCode>(code));
  switch (row == nullptr ? Meaning::none : row->meaning) {
    case Meaning::macro_call: return Kind::macro;
    case Meaning::modal_call: return Kind::modal;
    case Meaning::modal_call_every_block: return Kind::every_block;
    case Meaning::modal_call_off: return Kind::ends;
    default: return Kind::none;
  }
}

// G codes anywhere, M codes at the head of the block.
bool CallReader::find_code_macro(const Word& word, std::size_t index, BlockCall& call) const {
  if (!codes_call_macros_ || calls_.codes_are_ordinary()) return false;
  const Parameters& parameters = state_.parameters;
  if (word.letter == 'M' && index == 0) {
    const auto m = place_of(parameters.m_macro, code_of(word));
    if (m) call = {Kind::code_macro, index + 1, kFirstMMacro + *m, &word};
    return m.has_value();
  }
  if (word.letter != 'G') return false;
  const auto g = place_of(parameters.g_macro, base::round_away(word.value * 10));
  if (g) call = {Kind::code_macro, index + 1, kFirstGMacro + *g, &word};
  return g.has_value();
}

bool CallReader::admits_before(std::span<const Word> words, const BlockCall& call) const {
  const auto is_g = [](const Word& word) { return word.letter == 'G'; };
  const bool all = std::all_of(words.begin(), words.end(),
                               [&](const Word& word) { return is_g(word) || word.letter == 'N'; });
  if (!all)
    return state_.alarms.raise(Code::argument_g, call.word->text,
                               "arguments stand behind the macro call");
  if (std::any_of(words.begin(), words.end(), is_g))
    state_.assume(Assumed::words_before_call,
                  "G codes before a macro call in its block act as usual");
  return true;
}

bool CallReader::find(std::span<const Word> block, BlockCall& call) const {
  for (std::size_t i = 0; i < block.size(); ++i) {
    const Word& word = block[i];
    if (word.letter == 'M' && find_code_macro(word, i, call)) return true;
    if (word.letter != 'G') continue;
    const Kind kind = kind_of(base::round_away(word.value * 10));
    if (kind == Kind::ends) return true;
    if (kind == Kind::none) {
      if (call.kind == Kind::none) static_cast<void>(find_code_macro(word, i, call));
      continue;
    }
    if (call.kind != Kind::none) {
      const bool is_macro_word = call.kind != Kind::code_macro;
      return state_.alarms.raise(is_macro_word ? Code::two_macro_calls : Code::argument_g,
                                 word.text);
    }
    call = {kind, i + 1, 0, &word};
  }
  if (call.kind == Kind::none && calls_.every_block() && !block.empty())
    call = {Kind::every_block, 0, 0, nullptr};
  return true;
}

}  // namespace kerf::control
