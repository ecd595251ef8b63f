#include "control/gcode/block_calls.hpp"

#include <algorithm>

#include "control/core/assumed.hpp"

namespace kerf::control {
namespace {

using base::Code;
using gcode::Word;
using Kind = BlockCall::Kind;

constexpr std::uint32_t kFirstMSub = 9001;
constexpr std::uint32_t kToolProgram = 9000;
constexpr std::uint32_t kSpeedProgram = 9029;
constexpr std::uint32_t kSecondAuxiliaryProgram = 9028;

// The common variables in which code calls pass their value: #149 T, #147 S, #146 B.
constexpr std::size_t kToolCommon = 149 - 100;
constexpr std::size_t kSpeedCommon = 147 - 100;
constexpr std::size_t kSecondAuxiliaryCommon = 146 - 100;

}  // namespace

bool BlockCalls::call(std::span<const Word> arguments, const BlockCall& call,
                      const std::string& name) {
  const ArgumentRules rules{state_.modal.inch(), state_.parameters.calculator_point,
                            state_.parameters.single_ijk,
                            call.kind == Kind::every_block && call.word == nullptr};
  CallWords read;
  return read_arguments(arguments, rules, state_.alarms, read) && call_with(read, call, name);
}

bool BlockCalls::call_with(const CallWords& arguments, const BlockCall& call,
                           const std::string& name) {
  switch (call.kind) {
    case Kind::macro:
      return programs_.call_macro(arguments, name, ProgramCalls::Kind::macro, std::nullopt);
    case Kind::code_macro:
      return programs_.call_macro(arguments, {}, ProgramCalls::Kind::code_macro, call.program);
    case Kind::modal:
      state_.modal.set(Meaning::modal_call);
      return programs_.push_modal(arguments, name, false);
    case Kind::every_block:
      if (call.word != nullptr) {
        state_.modal.set(Meaning::modal_call_every_block);
        if (!programs_.push_modal(arguments, name, true)) return false;
      }
      return programs_.call_every_block(arguments);
    case Kind::none:
    case Kind::ends: break;
  }
  return true;
}

bool BlockCalls::return_from_program(const Words& words) {
  std::optional<std::uint32_t> label;
  std::int64_t p = 0;
  if (words.has('P')) {
    if (!state_.values.integer(words['P'], 0, 99999999, p)) return false;
    label = static_cast<std::uint32_t>(p);
  }
  if (!label && programs_.in_main()) tell_endless();
  return programs_.return_from_program(label);
}

// Of a lathe: a bar job. Only a budget ends it.
void BlockCalls::tell_endless() {
  if (state_.codes.habits().tool_brings_offset && state_.assumptions.is_new(Assumed::endless))
    state_.path.act(motion::Message{motion::ShortText(
        "M99 begins the program again, as a bar job wants: nothing else ends it")});
}

// Frames are stacked, so what must run first is entered last: the modal macro of the motion before
// the subprogram of the block.
bool BlockCalls::finish(const ReadBlock& block, const Auxiliary::Codes& codes, bool moved,
                        const std::string& name) {
  if (codes.call && !programs_.call_subprogram(block.words, name, ProgramCalls::Kind::subprogram))
    return false;
  if (codes.external_call &&
      !programs_.call_subprogram(block.words, name, ProgramCalls::Kind::external))
    return false;
  return call_by_code(block) && (!moved || programs_.trigger());
}

bool BlockCalls::call_by_m(const ReadBlock& block) {
  if (block.called_m == nullptr) return true;
  const auto& codes = state_.parameters.m_sub;
  const auto sub = std::find(codes.begin(), codes.end(), code_of(*block.called_m));
  std::int64_t repeats = 1;
  if (block.words.has('L') && !state_.values.integer(block.words['L'], 0, 9999, repeats))
    return false;
  const auto number = kFirstMSub + static_cast<std::uint32_t>(sub - codes.begin());
  return programs_.call_fixed(number, repeats, ProgramCalls::Kind::code_sub);
}

// M codes of 6071 to 6079, and T, S, B where they call programs (docs/dialect.md §6.4).
bool BlockCalls::call_by_code(const ReadBlock& block) {
  if (!reader_.codes_call_subprograms()) return true;
  if (!call_by_m(block)) return false;
  const auto pass = [&](std::size_t common, double value, std::uint32_t program) {
    state_.memory.commons[common] = value;
    return programs_.call_fixed(program, 1, ProgramCalls::Kind::code_sub);
  };
  const Words& words = block.words;
  const Parameters& parameters = state_.parameters;
  if (parameters.t_calls_program && words.has('T') &&
      !pass(kToolCommon, static_cast<double>(state_.words.tool), kToolProgram))
    return false;
  if (parameters.s_calls_program && words.has('S') &&
      !pass(kSpeedCommon, state_.words.speed, kSpeedProgram))
    return false;
  if (parameters.b_calls_program && words.has('B') && !state_.axes.find('B'))
    return pass(kSecondAuxiliaryCommon, words['B'].value, kSecondAuxiliaryProgram);
  return true;
}

}  // namespace kerf::control
