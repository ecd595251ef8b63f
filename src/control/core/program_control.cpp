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

std::vector<OpenCall> ProgramControl::open_calls() {
  std::vector<OpenCall> calls;
  const std::size_t depth = levels();
  for (std::size_t level = 0; level < depth; ++level) {
    const bool innermost = level + 1 == depth;
    calls.push_back(
        {name_of_level(level), innermost ? place() : interpreter()->place_of_call(level + 1)});
  }
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

vm::Verdict ProgramControl::announce(const vm::CodePage& page, const vm::BlockMark& mark) {
  const bool first_of_line = mark.offset == mark.line_offset || &mark == page.marks.data() ||
                             (&mark)[-1].line != mark.line;
  if (observer_ && first_of_line) observer_(page.file, mark.line);
  if (gate_ == nullptr || gate_->passes({page.file, mark.line, first_of_line, levels()}))
    return vm::Verdict::go_on;
  return halt_with(Halt::gate, vm::Verdict::pause);
}

}  // namespace kerf::control
