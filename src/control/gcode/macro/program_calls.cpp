#include "control/gcode/macro/program_calls.hpp"

#include <algorithm>

#include "base/decimal.hpp"
#include "base/program_name.hpp"
#include "control/core/assumed.hpp"

namespace kerf::control {
namespace {

using base::Code;

constexpr std::int64_t kMostRepeats = 9999;
constexpr std::int64_t kMostProgram = 99999999;
constexpr std::int64_t kPackedFrom = 10000;  // CALL-1: P of five digits and more holds repeats

}  // namespace

void ProgramCalls::start(vm::CodeId main) {
  levels_.assign(1, Level{Kind::main, main, 0, 0, false, -1});
  modal_.clear();
}

std::string ProgramCalls::name_at(std::size_t level) const {
  const gcode::ProgramEntry& entry = library_.entry(levels_[level].code);
  if (!entry.name.empty()) return entry.name;
  return base::program_name(entry.number);
}

bool ProgramCalls::has_own_locals(Kind kind) {
  return kind == Kind::macro || kind == Kind::modal || kind == Kind::code_macro ||
         kind == Kind::interrupt;
}

bool ProgramCalls::find(const gcode::Word* p, const std::string& name, vm::CodeId& code) {
  if (!name.empty()) {
    const auto found = finder_.find_program(name);
    if (!found)
      return state_.alarms.raise(Code::file_not_found, "there is no program <" + name + ">");
    code = *found;
    return true;
  }
  if (p == nullptr) return state_.alarms.raise(Code::program_not_found, "P is missing");
  std::int64_t number = 0;
  if (!state_.values.integer(*p, 0, kMostProgram, number)) return false;
  const auto found = finder_.find_program(static_cast<std::uint32_t>(number));
  if (!found)
    return state_.alarms.raise(Code::program_not_found, p->text,
                               "there is no program O" + std::to_string(number));
  code = *found;
  return true;
}

bool ProgramCalls::repeats_of(const gcode::Word* l, std::int64_t& repeats) {
  repeats = 1;
  return l == nullptr || state_.values.integer(*l, 0, kMostRepeats, repeats);
}

// CALL-9, NEST-1
bool ProgramCalls::check_depth(Kind kind) {
  const auto macros = std::count_if(levels_.begin(), levels_.end(),
                                    [](const Level& l) { return has_own_locals(l.kind); });
  const auto total = static_cast<std::ptrdiff_t>(levels_.size()) - 1;
  const auto subs = total - macros;
  if (has_own_locals(kind) && macros >= state_.parameters.macro_levels) {
    return state_.alarms.raise(
        Code::macro_too_deep,
        std::to_string(state_.parameters.macro_levels) + " levels are allowed");
  }
  if (!has_own_locals(kind) && subs >= state_.parameters.sub_levels) {
    return state_.alarms.raise(
        Code::too_deep, std::to_string(state_.parameters.sub_levels) + " levels are allowed");
  }
  if (total >= state_.parameters.total_levels) {
    return state_.alarms.raise(Code::too_deep, std::to_string(state_.parameters.total_levels) +
                                                   " levels are allowed in all");
  }
  return true;
}

bool ProgramCalls::enter(const Level& level, const LocalVariables* locals) {
  if (!check_depth(level.kind)) return false;
  using Locals = vm::Interpreter::Locals;
  interpreter_.call(level.code, locals != nullptr ? Locals::fresh : Locals::shared);
  if (locals != nullptr) std::copy(locals->begin(), locals->end(), interpreter_.locals().begin());
  levels_.push_back(level);
  return true;
}

bool ProgramCalls::call_macro(const CallWords& call, const std::string& name, Kind kind,
                              std::optional<std::uint32_t> number) {
  Level level{.kind = kind,
              .modal_depth = levels_.back().modal_depth,
              .codes_ordinary = levels_.back().codes_ordinary};
  if (number) {
    const auto found = finder_.find_program(*number);
    if (!found)
      return state_.alarms.raise(Code::program_not_found,
                                 "there is no program O" + std::to_string(*number));
    level.code = *found;
    level.codes_ordinary = true;
  } else if (!find(call.program, name, level.code)) {
    return false;
  }
  std::int64_t repeats = 1;
  if (!repeats_of(call.repeats, repeats)) return false;
  if (repeats == 0) return true;
  level.repeats_left = repeats - 1;
  return enter(level, &call.locals);
}

// CALL-1: P of 5 to 8 digits is repeats and program, unless the control takes long program numbers.
bool ProgramCalls::split_subprogram(const Words& words, std::uint32_t& number,
                                    std::int64_t& repeats, Kind kind) {
  std::int64_t p = 0;
  if (!words.has('P')) return state_.alarms.raise(Code::program_not_found, "P is missing");
  if (!state_.values.integer(words['P'], 0, kMostProgram, p)) return false;
  if (!repeats_of(words.find('L'), repeats)) return false;
  number = static_cast<std::uint32_t>(p);
  if (p < kPackedFrom || state_.parameters.long_program_numbers || kind == Kind::external)
    return true;
  const auto packed = static_cast<std::uint32_t>(p % kPackedFrom);
  if (!finder_.find_program(packed) && finder_.find_program(number)) {
    state_.assume(Assumed::long_program_number,
                  "M98 P with more than four digits is read as a program number, because that "
                  "program exists and "
                  "the one of its last four digits does not");
    return true;
  }
  number = packed;
  if (!words.has('L')) repeats = p / kPackedFrom;
  return true;
}

bool ProgramCalls::call_subprogram(const Words& words, const std::string& name, Kind kind) {
  Level level{.kind = kind,
              .modal_depth = levels_.back().modal_depth,
              .codes_ordinary = levels_.back().codes_ordinary};
  std::int64_t repeats = 1;
  if (!name.empty()) {
    if (!find(nullptr, name, level.code) || !repeats_of(words.find('L'), repeats)) return false;
  } else if (!words.has('P') && words.has('Q')) {
    level.code = running();  // a part of the same program
    if (!repeats_of(words.find('L'), repeats)) return false;
  } else {
    std::uint32_t number = 0;
    if (!split_subprogram(words, number, repeats, kind)) return false;
    const bool external = kind == Kind::external;
    const bool nested = std::any_of(levels_.begin(), levels_.end(),
                                    [](const Level& l) { return l.kind == Kind::external; });
    if (external && nested) return state_.alarms.raise(Code::external_nested, words['P'].text);
    const auto found = external ? finder_.find_external(number) : finder_.find_program(number);
    if (!found) {
      return state_.alarms.raise(external ? Code::external_not_found : Code::program_not_found,
                                 words['P'].text, "there is no program O" + std::to_string(number));
    }
    level.code = *found;
  }
  if (repeats == 0) return true;
  level.repeats_left = repeats - 1;
  return enter(level, nullptr) && start_at(words);
}

// M98 Q: not from the head but from a sequence number.
bool ProgramCalls::start_at(const Words& words) {
  if (!words.has('Q')) return true;
  std::int64_t label = 0;
  if (!state_.values.integer(words['Q'], 1, kMostProgram, label)) return false;
  return interpreter_.jump_to_label(static_cast<std::uint32_t>(label)) ||
         state_.alarms.raise(Code::return_label_not_found, words['Q'].text,
                             "the program has no N" + std::to_string(label));
}

bool ProgramCalls::call_fixed(std::uint32_t number, std::int64_t repeats, Kind kind) {
  const auto found = finder_.find_program(number);
  if (!found)
    return state_.alarms.raise(Code::program_not_found,
                               "there is no program O" + std::to_string(number));
  if (repeats == 0) return true;
  Level level{kind, *found, repeats - 1, levels_.back().modal_depth, true, -1};
  if (kind != Kind::interrupt) return enter(level, nullptr);
  LocalVariables locals;
  locals.fill(vm::kNull);
  return enter(level, &locals);
}

bool ProgramCalls::push_modal(const CallWords& call, const std::string& name, bool every_block) {
  ModalCall modal;
  modal.every_block = every_block;
  modal.locals = call.locals;
  if (!find(call.program, name, modal.code) || !repeats_of(call.repeats, modal.repeats))
    return false;
  modal_.push_back(modal);
  return true;
}

bool ProgramCalls::pop_modal() {
  if (modal_.empty()) {
    return state_.parameters.ignore_lone_g67 || state_.alarms.raise(Code::cancel_without_call);
  }
  const int last = static_cast<int>(modal_.size()) - 1;
  for (Level& level : levels_) {
    if (level.modal == last) level.modal = -1;
  }
  modal_.pop_back();
  return true;
}

bool ProgramCalls::trigger() {
  const std::size_t depth = levels_.back().modal_depth;
  if (depth >= modal_.size()) return true;
  const std::size_t index = modal_.size() - 1 - depth;
  if (modal_[index].every_block) return true;
  return call_modal(index, modal_[index].locals);
}

bool ProgramCalls::every_block() const {
  const std::size_t depth = levels_.back().modal_depth;
  return depth < modal_.size() && modal_[modal_.size() - 1 - depth].every_block;
}

bool ProgramCalls::call_every_block(const CallWords& call) {
  return call_modal(modal_.size() - 1 - levels_.back().modal_depth, call.locals);
}

bool ProgramCalls::call_modal(std::size_t index, const LocalVariables& locals) {
  const ModalCall& modal = modal_[index];
  if (modal.repeats == 0) return true;
  const Level level{Kind::modal,
                    modal.code,
                    modal.repeats - 1,
                    levels_.back().modal_depth + 1,
                    levels_.back().codes_ordinary,
                    static_cast<int>(index)};
  return enter(level, &locals);
}

// CALL-15: the locals of a modal macro are kept between its calls.
void ProgramCalls::keep_modal_locals(const Level& level) {
  if (level.modal < 0 || static_cast<std::size_t>(level.modal) >= modal_.size()) return;
  const auto locals = interpreter_.locals();
  std::copy(locals.begin(), locals.end(),
            modal_[static_cast<std::size_t>(level.modal)].locals.begin());
}

// M99-1 to M99-3
bool ProgramCalls::return_from_program(std::optional<std::uint32_t> label) {
  Level& level = levels_.back();
  if (in_main()) {
    if (!label) {
      interpreter_.restart();
      return true;
    }
  } else if (!label && level.repeats_left > 0) {
    --level.repeats_left;
    interpreter_.restart();
    return true;
  } else {
    keep_modal_locals(level);
    interpreter_.return_to_caller();
    levels_.pop_back();
  }
  if (!label || interpreter_.jump_to_label(*label)) return true;
  return state_.alarms.raise(Code::return_label_not_found,
                             "the program has no N" + std::to_string(*label));
}

std::string ProgramCalls::callers() const {
  std::string text;
  for (std::size_t depth = interpreter_.depth(); depth-- > 1;) {
    text += (text.empty() ? "called from line " : ", line ") +
            std::to_string(interpreter_.place_of_call(depth).line) + " of " + name_at(depth - 1);
  }
  return text;
}

}  // namespace kerf::control
