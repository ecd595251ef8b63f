// Program calls that stand among the words of a block: macro calls, subprograms, calls by code.
#include <algorithm>
#include <limits>

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"
#include "control/gcode/controller.hpp"

namespace kerf::control {
namespace {

using base::Code;
using gcode::Word;

constexpr std::uint32_t kFirstGMacro = 9010;
constexpr std::uint32_t kFirstMMacro = 9020;
constexpr std::uint32_t kFirstMSub = 9001;
constexpr std::uint32_t kToolProgram = 9000;
constexpr std::uint32_t kSpeedProgram = 9029;
constexpr std::uint32_t kSecondAuxiliaryProgram = 9028;

// The common variables in which code calls pass their value: #149 T, #147 S, #146 B.
constexpr std::size_t kToolCommon = 149 - 100;
constexpr std::size_t kSpeedCommon = 147 - 100;
constexpr std::size_t kSecondAuxiliaryCommon = 146 - 100;

}  // namespace

Controller::BlockCall::Kind Controller::call_of(int code) const {
  using Kind = BlockCall::Kind;
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

bool Controller::find_call(std::span<const Word> block, BlockCall& call) {
  using Kind = BlockCall::Kind;
  const bool every_block = calls_.every_block();
  const bool ordinary = calls_.codes_are_ordinary();
  for (std::size_t i = 0; i < block.size(); ++i) {
    const Word& word = block[i];
    if (codes_call_macros_ && word.letter == 'M' && i == 0 && !ordinary) {
      const auto m =
          std::find(parameters_.m_macro.begin(), parameters_.m_macro.end(), code_of(word));
      if (m != parameters_.m_macro.end() && *m != 0) {
        call = {Kind::code_macro, 1,
                kFirstMMacro + static_cast<std::uint32_t>(m - parameters_.m_macro.begin()), &word};
        return true;
      }
    }
    if (word.letter != 'G') continue;
    const auto code = static_cast<int>(base::round_away(word.value * 10));
    const Kind kind = call_of(code);
    if (kind == Kind::ends) return true;
    if (kind != Kind::none) {
      if (call.kind != Kind::none) {
        const bool macro_word = call.kind != Kind::code_macro;
        return alarms_.raise(macro_word ? Code::two_macro_calls : Code::argument_g, word.text);
      }
      call = {kind, i + 1, 0, &word};
    } else if (codes_call_macros_ && call.kind == Kind::none && !ordinary && code != 0) {
      const auto g = std::find(parameters_.g_macro.begin(), parameters_.g_macro.end(), code);
      if (g == parameters_.g_macro.end()) continue;
      call = {Kind::code_macro, i + 1,
              kFirstGMacro + static_cast<std::uint32_t>(g - parameters_.g_macro.begin()), &word};
    }
  }
  if (call.kind == Kind::none && every_block && !block.empty())
    call = {Kind::every_block, 0, 0, nullptr};
  return true;
}

// CALL-4: what stands before the call must be G codes, which act as usual; what stands behind it
// are arguments.
bool Controller::call_program(std::span<const Word> block, const BlockCall& call,
                              const std::string& name) {
  using Kind = BlockCall::Kind;
  const std::size_t before = call.first_argument == 0 ? 0 : call.first_argument - 1;
  for (const Word& word : block.subspan(0, before)) {
    if (word.letter == 'G' || word.letter == 'N') continue;
    return alarms_.raise(Code::argument_g, call.word->text,
                         "arguments stand behind the macro call");
  }
  if (before > 0) {
    if (std::any_of(block.begin(), block.begin() + static_cast<std::ptrdiff_t>(before),
                    [](const Word& w) { return w.letter == 'G'; })) {
      state_.assume(Assumed::words_before_call,
                    "G codes before a macro call in its block act as usual");
    }
    if (!collect(block.subspan(0, before)) || !execute_block({}) || !state_.path.end_block())
      return false;
  }
  const ArgumentRules rules{state_.modal.inch(), parameters_.calculator_point,
                            parameters_.single_ijk,
                            call.kind == Kind::every_block && call.word == nullptr};
  CallWords arguments;
  if (!read_arguments(block.subspan(call.first_argument), rules, alarms_, arguments)) return false;
  const std::size_t depth = interpreter_.depth();
  bool good = true;
  switch (call.kind) {
    case Kind::macro:
      good = calls_.call_macro(arguments, name, ProgramCalls::Kind::macro, std::nullopt);
      break;
    case Kind::code_macro:
      good = calls_.call_macro(arguments, {}, ProgramCalls::Kind::code_macro, call.program);
      break;
    case Kind::modal:
      good = calls_.push_modal(arguments, name, false);
      state_.modal.set(Meaning::modal_call);
      break;
    case Kind::every_block:
      if (call.word != nullptr) {
        good = calls_.push_modal(arguments, name, true);
        state_.modal.set(Meaning::modal_call_every_block);
      }
      good = good && calls_.call_every_block(arguments);
      break;
    case Kind::none:
    case Kind::ends: break;
  }
  transferred_ = interpreter_.depth() != depth;
  return good;
}

bool Controller::set_interrupt() {
  if (codes_.interrupt_off) interrupt_program_ = 0;
  if (!codes_.interrupt_on) return true;
  std::int64_t p = 0;
  if (!words_.has('P')) return alarms_.raise(Code::interrupt_statement, "M96 needs P");
  if (!state_.values.integer(words_['P'], 0, 99999999, p)) return false;
  interrupt_program_ = static_cast<std::uint32_t>(p);
  state_.assume(Assumed::interrupt,
                "M96: the interrupt program runs when the interrupt signal comes");
  return true;
}

// Calls and returns behind the block's own actions. Frames are stacked, so what must run first is
// entered last: the modal macro of the motion before the subprogram of the block.
bool Controller::finish_calls() {
  const std::size_t depth = interpreter_.depth();
  if (codes_.return_) {
    std::optional<std::uint32_t> label;
    std::int64_t p = 0;
    if (words_.has('P')) {
      if (!state_.values.integer(words_['P'], 0, 99999999, p)) return false;
      label = static_cast<std::uint32_t>(p);
    }
    transferred_ = true;
    return calls_.return_from_program(label);
  }
  if (codes_.call && !calls_.call_subprogram(words_, call_name_, ProgramCalls::Kind::subprogram))
    return false;
  if (codes_.external_call &&
      !calls_.call_subprogram(words_, call_name_, ProgramCalls::Kind::external))
    return false;
  if (!call_by_code(words_)) return false;
  if (moved_ && !calls_.trigger()) return false;
  transferred_ = interpreter_.depth() != depth;
  return true;
}

// M codes of 6071 to 6079, and T, S, B where they call programs (docs/dialect.md §6.4).
bool Controller::call_by_code(const Words& words) {
  if (!codes_call_subprograms_ || calls_.codes_are_ordinary()) return true;
  using Kind = ProgramCalls::Kind;
  std::int64_t repeats = 1;
  if (called_m_ != nullptr) {
    const auto sub =
        std::find(parameters_.m_sub.begin(), parameters_.m_sub.end(), code_of(*called_m_));
    if (words.has('L') && !state_.values.integer(words['L'], 0, 9999, repeats)) return false;
    const auto number = kFirstMSub + static_cast<std::uint32_t>(sub - parameters_.m_sub.begin());
    if (!calls_.call_fixed(number, repeats, Kind::code_sub)) return false;
  }
  auto& commons = state_.memory.commons;
  if (parameters_.t_calls_program && words.has('T')) {
    commons[kToolCommon] = static_cast<double>(state_.words.tool);
    if (!calls_.call_fixed(kToolProgram, 1, Kind::code_sub)) return false;
  }
  if (parameters_.s_calls_program && words.has('S')) {
    commons[kSpeedCommon] = state_.words.speed;
    if (!calls_.call_fixed(kSpeedProgram, 1, Kind::code_sub)) return false;
  }
  if (parameters_.b_calls_program && words.has('B') && !axes_.find('B')) {
    commons[kSecondAuxiliaryCommon] = words['B'].value;
    if (!calls_.call_fixed(kSecondAuxiliaryProgram, 1, Kind::code_sub)) return false;
  }
  return true;
}

}  // namespace kerf::control
