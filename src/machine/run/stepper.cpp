#include "machine/run/stepper.hpp"

#include <algorithm>
#include <bit>

#include "base/refusal.hpp"
#include "lang/vm/value.hpp"
#include "machine/dialect/dialect.hpp"

namespace kerf::machine {
namespace {

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || a == b;
}

std::string words_of(const Breakpoint& breakpoint) {
  if (!breakpoint.variable.empty()) return "breakpoint on " + breakpoint.variable;
  return "breakpoint in line " + std::to_string(breakpoint.line);
}

tl::unexpected<base::Failure> refused(const Breakpoint& breakpoint, const std::string& why) {
  return tl::unexpected(
      base::Failure{base::Failure::Kind::usage, words_of(breakpoint) + ": " + why});
}

// The sentence of the condition's own mistake, behind where it stands.
base::Failure with_place(const Breakpoint& breakpoint, const base::Failure& mistake) {
  if (!breakpoint.variable.empty())
    return {base::Failure::Kind::usage, words_of(breakpoint) + ": " + mistake.message};
  const auto number = std::find_if(mistake.values.begin(), mistake.values.end(),
                                   [](const auto& value) { return value.name == "alarm"; });
  return base::refuse_for(number == mistake.values.end() ? "" : number->text,
                          base::Refusal::breakpoint_condition,
                          {std::to_string(breakpoint.line), mistake.message});
}

}  // namespace

base::Outcome<std::vector<Condition>> Stepper::compile(const std::vector<Breakpoint>& breakpoints) {
  std::vector<Condition> conditions;
  for (const Breakpoint& breakpoint : breakpoints) {
    const bool of_variable = !breakpoint.variable.empty();
    if (of_variable == (breakpoint.line != 0))
      return refused(breakpoint, "it has either a line or a variable");
    if (of_variable && !dialect_->variables().value(breakpoint.variable, 0))
      return tl::unexpected(
          base::refuse(base::Refusal::breakpoint_variable, {breakpoint.variable}));
    conditions.emplace_back();
    if (breakpoint.condition.empty()) continue;
    auto condition = dialect_->variables().compile_condition(breakpoint.condition);
    if (!condition) return tl::unexpected(with_place(breakpoint, condition.error()));
    conditions.back() = std::move(*condition);
  }
  return conditions;
}

base::Outcome<void> Stepper::set_breakpoints(std::vector<Breakpoint> breakpoints) {
  auto conditions = compile(breakpoints);
  if (!conditions) return tl::unexpected(conditions.error());
  breakpoints_ = std::move(breakpoints);
  conditions_ = std::move(*conditions);
  known_.clear();
  depth_ = std::max<std::size_t>(dialect_->control().open_calls().size(), 1);
  remember(depth_);
  learn_gate();
  return {};
}

// Where the other machine has no such variable, its breakpoint waits for a program that has it.
void Stepper::watch(Dialect& dialect) {
  dialect_->control().set_gate(nullptr);
  attach(dialect);
}

void Stepper::attach(Dialect& dialect) {
  dialect_ = &dialect;
  conditions_.clear();
  for (const Breakpoint& breakpoint : breakpoints_) {
    conditions_.emplace_back();
    if (breakpoint.condition.empty()) continue;
    if (auto condition = dialect_->variables().compile_condition(breakpoint.condition))
      conditions_.back() = std::move(*condition);
  }
  blocks_ = 0;
  start();
}

void Stepper::learn_gate() {
  const bool asks = counts_ || !acts_.empty() || searched_line_ != 0 || searched_block_ != 0 ||
                    target_ != Target::none || !breakpoints_.empty();
  dialect_->control().set_gate(asks ? this : nullptr);
}

void Stepper::step(Step how) {
  const std::size_t depth = dialect_->control().open_calls().size();
  target_ = Target::depth;
  most_depth_ = how == Step::into  ? ~std::size_t{0}
                : how == Step::out ? std::max<std::size_t>(depth, 1) - 1
                                   : depth;
  learn_gate();
}

void Stepper::run_to(std::string file, std::uint32_t line) {
  target_ = Target::line;
  file_ = std::move(file);
  line_ = line;
  learn_gate();
}

void Stepper::search_line(std::uint32_t line) {
  searched_line_ = line;
  learn_gate();
}

void Stepper::search_block(std::uint64_t number) {
  searched_block_ = number;
  learn_gate();
}

void Stepper::forget_target() {
  target_ = Target::none;
  learn_gate();
}

void Stepper::count_blocks(bool on) {
  counts_ = on;
  learn_gate();
}

void Stepper::before_block(std::uint64_t number, std::function<void()> act) {
  acts_.emplace(number, std::move(act));
  learn_gate();
}

void Stepper::forget_acts() {
  acts_.clear();
  learn_gate();
}

void Stepper::act_before(std::uint64_t number) {
  while (!acts_.empty() && acts_.begin()->first <= number) {
    const std::function<void()> act = std::move(acts_.begin()->second);
    acts_.erase(acts_.begin());
    act();
  }
}

void Stepper::start() {
  target_ = Target::none;
  last_line_ = 0;
  hit_.reset();
  depth_ = 1;
  known_.clear();
  remember(depth_);
  learn_gate();
}

void Stepper::go_on() { hit_.reset(); }

// A variable that all levels share is known once.
std::size_t Stepper::depth_of(std::size_t number, std::size_t depth) const {
  return dialect_->variables().is_local(breakpoints_[number].variable) ? depth : 1;
}

// Values of the watched variables in the innermost of `depth` calls; those of the callers stay.
void Stepper::remember(std::size_t depth) {
  known_.resize(breakpoints_.size());
  for (std::size_t i = 0; i < breakpoints_.size(); ++i) {
    if (breakpoints_[i].variable.empty() || depth == 0) continue;
    known_[i].resize(depth_of(i, depth), vm::kNull);
    known_[i].back() =
        dialect_->variables().value(breakpoints_[i].variable, depth - 1).value_or(vm::kNull);
  }
}

bool Stepper::is_file(const std::string& wanted, base::FileId file) const {
  return wanted.empty() ? file == dialect_->main_file() : dialect_->is_file(wanted, file);
}

bool Stepper::reached(const control::BlockStart& block) const {
  switch (target_) {
    case Target::none: return false;
    case Target::depth: return block.depth <= most_depth_;
    case Target::line:
      return block.line == line_ && block.first_of_line && is_file(file_, block.file);
  }
  return false;
}

bool Stepper::is_met(std::size_t number, BreakpointHit hit) {
  if (conditions_[number].code) {
    const std::optional<bool> holds = dialect_->variables().holds(conditions_[number]);
    if (!holds) hit.trouble = "the condition has no value here";
    if (holds && !*holds) return false;
  } else if (!breakpoints_[number].condition.empty()) {
    hit.trouble = "the condition does not fit this program";
  }
  hit_ = std::move(hit);
  return true;
}

bool Stepper::at_line_breakpoint(const control::BlockStart& block) {
  for (std::size_t i = 0; i < breakpoints_.size(); ++i) {
    const Breakpoint& breakpoint = breakpoints_[i];
    if (breakpoint.line != block.line || !block.first_of_line) continue;
    if (is_file(breakpoint.file, block.file) && is_met(i, {breakpoint, 0, 0, 0, {}})) return true;
  }
  return false;
}

// A call begins with the values that its arguments have given; a return finds those of before.
bool Stepper::has_changed(const control::BlockStart& block) {
  bool changed = false;
  known_.resize(breakpoints_.size());
  for (std::size_t i = 0; i < breakpoints_.size(); ++i) {
    if (breakpoints_[i].variable.empty()) continue;
    const auto now = dialect_->variables().value(breakpoints_[i].variable, block.depth - 1);
    const std::size_t depth = depth_of(i, block.depth);
    const bool entered = known_[i].size() < depth;
    known_[i].resize(depth, now.value_or(vm::kNull));
    const double before = std::exchange(known_[i].back(), now.value_or(vm::kNull));
    if (changed || !now || entered || same(before, *now)) continue;
    changed = is_met(i, {breakpoints_[i], last_line_, before, *now, {}});
  }
  return changed;
}

bool Stepper::passes(const control::BlockStart& block) {
  hit_.reset();
  depth_ = block.depth;
  if (searched_line_ != 0) {
    const bool found =
        block.line == searched_line_ && block.first_of_line && is_file("", block.file);
    blocks_ += found ? 1 : 0;
    return !found;
  }
  act_before(blocks_ + 1);
  if (searched_block_ != 0 && blocks_ + 1 == searched_block_) {
    ++blocks_;
    last_line_ = block.line;
    target_ = Target::none;
    return false;
  }
  const bool target = reached(block);
  const bool stops = has_changed(block) || at_line_breakpoint(block) || target;
  ++blocks_;
  last_line_ = block.line;
  if (stops) target_ = Target::none;
  return !stops;
}

}  // namespace kerf::machine
