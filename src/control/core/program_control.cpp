#include "control/core/program_control.hpp"

#include <utility>

#include "control/core/assumed.hpp"

namespace kerf::control {

std::size_t ProgramControl::levels() {
  const vm::Interpreter* const machine = interpreter();
  return machine == nullptr ? 0 : machine->depth();
}

std::span<double> ProgramControl::locals_of(std::size_t level) {
  return interpreter()->locals_of(level);
}

base::Place ProgramControl::place() {
  return levels() > 0 ? interpreter()->place() : base::Place{};
}

base::BlockId ProgramControl::block() {
  return levels() > 0 ? run_by(running(), interpreter()->block()) : base::BlockId{};
}

ProgramControl::Running ProgramControl::running() {
  const std::size_t level = levels() - 1;
  return {number_of_level(level), path_to(level)};
}

// Calls are open one in the other: those that are known and still open are the first ones.
base::CallPath ProgramControl::path_to(std::size_t level) {
  const auto is_open = [&](const CallUnderWay& call, std::size_t at) {
    return at <= level && call.number == interpreter()->call_number(at);
  };
  while (!under_way_.empty() && !is_open(under_way_.back(), under_way_.size()))
    under_way_.pop_back();
  while (under_way_.size() < level) {
    const std::size_t calling = under_way_.size();
    const base::CallPath path = paths_.behind(caller(calling));
    under_way_.push_back({interpreter()->call_number(calling + 1), path});
  }
  return level == 0 ? base::CallPath::main : under_way_.back().path;
}

// The block at a level that has called the next one. Precondition: the way to it is known.
base::BlockId ProgramControl::caller(std::size_t level) {
  base::BlockId by = interpreter()->block_of_call(level + 1);
  by.program = number_of_level(level);
  by.calls = level == 0 ? base::CallPath::main : under_way_[level - 1].path;
  return by;
}

std::vector<OpenCall> ProgramControl::open_calls() {
  std::vector<OpenCall> calls;
  const std::size_t depth = levels();
  const base::BlockId innermost = block();
  for (std::size_t level = 0; level < depth; ++level)
    calls.push_back({name_of_level(level), level + 1 == depth ? innermost : caller(level)});
  return calls;
}

std::uint64_t ProgramControl::slashes() {
  const vm::Interpreter* const machine = interpreter();
  return machine == nullptr ? 0 : machine->switches_read();
}

void ProgramControl::set_single_block(bool on) {
  if (on != single_block_) in_statement_ = false;
  single_block_ = on;
  learn_tracing();
}

void ProgramControl::observe_blocks(BlockObserver observer) {
  observer_ = std::move(observer);
  learn_tracing();
}

void ProgramControl::set_gate(BlockGate* gate) {
  gate_ = gate;
  learn_tracing();
}

// What a program raises itself is meant to end it.
bool ProgramControl::pass_alarm() {
  const auto& alarm = alarms_.alarm();
  if (!alarm || levels() == 0 || alarm->code == base::Code::user_alarm ||
      !interpreter()->leave_block())
    return false;
  alarms_.clear();
  halt_ = Halt::none;
  undo_block();
  return true;
}

void ProgramControl::miss_interrupt() {
  ++interrupts_missed_;
  assume(Assumed::interrupt_missed, place().line,
         "an interrupt signal came while no M96 was in force: it did nothing");
}

void ProgramControl::learn_tracing() {
  vm::Interpreter* const machine = interpreter();
  if (machine == nullptr) return;
  machine->set_tracing(observer_ || gate_ != nullptr || (single_block_ && single_block_traces()));
}

vm::Verdict ProgramControl::begin_block(const vm::CodePage& page, const vm::BlockMark& mark) {
  const bool first_of_line = mark.offset == mark.line_offset || &mark == page.marks.data() ||
                             (&mark)[-1].line != mark.line;
  if (observer_ && first_of_line) observer_(page.file, mark.line);
  if (gate_ == nullptr || gate_->passes({page.file, mark.line, first_of_line, levels()}))
    return vm::Verdict::go_on;
  return halt_with(Halt::gate, vm::Verdict::pause);
}

}  // namespace kerf::control
