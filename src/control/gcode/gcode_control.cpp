#include "control/gcode/gcode_control.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/decimal.hpp"
#include "control/gcode/acts/compensation.hpp"
#include "control/gcode/macro/fault_alarm.hpp"
#include "control/gcode/macro/user_alarm.hpp"
#include "lang/vm/value.hpp"

namespace kerf::control {
namespace {

using base::Code;
using gcode::Word;
using vm::Verdict;

}  // namespace

GcodeControl::GcodeControl(const CodeTable& codes, const Parameters& parameters,
                           const motion::AxisSetup& axes, Memory& memory,
                           gcode::CodeLibrary& library, ProgramFinder& finder,
                           Surroundings& surroundings, motion::MotionSink& sink)
    : parameters_(parameters),
      axes_(axes),
      library_(library),
      surroundings_(surroundings),
      math_{parameters.signed_angles, parameters.small_is_zero, 1000},
      buffer_(sink),
      state_(codes, parameters_, axes_, memory, alarms_, assumptions_, surroundings, buffer_),
      interpreter_(library, *this, {gcode::kLocals, memory.commons, &math_}),
      programs_(state_, interpreter_, library, finder),
      call_reader_(state_, programs_),
      acts_(state_, programs_, buffer_, [this] { learn_parameters(); }),
      reader_(state_, acts_.targets(), call_reader_),
      shapes_(state_, acts_, reader_, buffer_, interpreter_, library),
      calls_(state_, programs_, call_reader_),
      variables_(state_, library.names()),
      printer_(parameters_, surroundings) {
  variables_.attach(&interpreter_,
                    [this] { return started() ? programs_.number_at(levels() - 1) : 0; });
  if (const auto z = axes.find('Z')) state_.length_axis = *z;
  learn_parameters();
}

// What is kept ready of the parameters, at power-on and after their entry by G10 L50.
void GcodeControl::learn_parameters() {
  state_.refresh_format();
  state_.path.configure({parameters_.start_up, parameters_.corner_arc});
  math_.signed_angles = parameters_.signed_angles;
  math_.small_is_zero = parameters_.small_is_zero;
  call_reader_.learn_parameters();
}

void GcodeControl::start(vm::CodeId main, Ends ends) {
  ends_ = ends;
  LocalVariables kept;
  if (parameters_.keep_locals && interpreter_.depth() > 0) {
    std::copy_n(first_level_locals().begin(), kept.size(), kept.begin());
  } else {
    kept.fill(vm::kNull);
  }
  interpreter_.start(main);
  std::copy(kept.begin(), kept.end(), first_level_locals().begin());
  programs_.start(main);
  halt_ = Halt::none;
  mid_block_ = at_optional_stop_ = false;
  in_block_ = false;
  shapes_.drop();
}

void GcodeControl::reset() {
  alarms_.clear();
  halt_ = Halt::none;
  mid_block_ = at_optional_stop_ = false;
  interrupt_ = {};
  shapes_.drop();
  acts_.stop();
  acts_.cancel_cycle();
  state_.reset();
  if (!parameters_.keep_commons) state_.memory.clear_volatile();
}

base::MachinePoint GcodeControl::machine_position() const {
  return state_.coordinates.machine_of(state_.path.tip_on_machine());
}

void GcodeControl::stand_at(const base::TipPoint& tip) {
  state_.path.stand_at(tip);
  state_.coordinates.arrive_at(base::PathPoint(state_.path.tip().numbers()));
}

Halt GcodeControl::run(std::uint64_t instructions) {
  halt_ = Halt::none;
  if (resume()) interpreter_.run(instructions);
  if (alarms_.alarm()) settle_alarm();
  return halt_;
}

// What a run begins with: the rest of a block that was left, then an interrupt. False: the run ends
// here.
bool GcodeControl::resume() {
  if (mid_block_) {
    const Verdict verdict = continue_block();
    if (verdict == Verdict::stop || verdict == Verdict::pause) return false;
  }
  return !interrupt_.is_pending() || take_interrupt();
}

// Moves that were commanded before the alarm are made, also those that waited for the next one. The
// block that is wrong switches nothing.
void GcodeControl::settle_alarm() {
  halt_ = Halt::alarm;
  acts_.stop();
  static_cast<void>(state_.path.release());  // a second alarm changes nothing
  if (in_block_) buffer_.drop_functions_of(state_.path.block());
  buffer_.release();
}

// A macro statement changes nothing before its alarm: what was kept is of a block before it.
void GcodeControl::undo_block() {
  mid_block_ = false;
  shapes_.drop();
  if (in_block_) block_memory_.restore(state_);
  in_block_ = false;
  BlockMemory::settle(state_);
  if (!state_.modal.in_cycle()) acts_.cancel_cycle();
}

std::optional<double> GcodeControl::peek(double number) {
  if (alarms_.alarm()) return std::nullopt;
  double value = vm::kNull;
  if (variables_.read(number, value)) return value;
  alarms_.clear();
  return std::nullopt;
}

vm::Interpreter::Settings GcodeControl::evaluation_settings() {
  return {gcode::kLocals, state_.memory.commons, &math_};
}

// vm::Host

// Clocks and inputs are read when the axes have come to the block.
Verdict GcodeControl::read(double number, double& value) {
  const bool waits = SystemVariables::is_clock(number) || SystemVariables::is_input(number);
  if (waits && !surroundings_.axes_have_arrived()) return Verdict::again;
  return variables_.read(number, value) ? Verdict::go_on : Verdict::stop;
}

Verdict GcodeControl::write(double number, double value) {
  if (SystemVariables::is_clock(number) && !surroundings_.axes_have_arrived())
    return Verdict::again;
  SystemVariables::Event event;
  if (!variables_.write(number, value, event)) return Verdict::stop;
  switch (event.kind) {
    case SystemVariables::Event::Kind::alarm: return raise_user_alarm(event.number);
    case SystemVariables::Event::Kind::message: return show_message(event.number);
    case SystemVariables::Event::Kind::none: break;
  }
  return Verdict::go_on;
}

void GcodeControl::fault(vm::Fault fault) { alarms_.raise(code_of(fault), detail_of(fault)); }

Verdict GcodeControl::end_of_code() {
  if (shapes_.active()) {
    shapes_.miss_last();
    return Verdict::stop;
  }
  if (ends_ == Ends::with_text && programs_.in_main()) return end_of_entry();
  alarms_.raise(Code::end_of_record, "the program runs out without M02, M30 or M99");
  return Verdict::stop;
}

// A held corner or compensation has nothing more to wait for.
Verdict GcodeControl::end_of_entry() {
  if (!state_.path.release()) return Verdict::stop;
  state_.path.act(motion::End{});
  buffer_.release();
  return stopped(Halt::end);
}

Verdict GcodeControl::begin_block(const vm::CodePage& page, const vm::BlockMark& mark) {
  if (shapes_.reading()) return Verdict::go_on;
  const bool behind_statement = std::exchange(in_statement_, true);
  Verdict verdict = ProgramControl::begin_block(page, mark);
  if (verdict == Verdict::go_on && interrupt_.is_pending()) verdict = answer_interrupt();
  if (verdict != Verdict::go_on || !behind_statement) return verdict;
  if (!single_block_ || !parameters_.stop_at_macro) return Verdict::go_on;
  return stopped(Halt::single_block);
}

Verdict GcodeControl::execute(const vm::CodePage& code_page, std::uint32_t block,
                              const double* registers) {
  const auto& page = static_cast<const gcode::GcodePage&>(code_page);
  const gcode::Statement& statement = page.statements[block];
  ++blocks_;
  in_statement_ = statement.kind != gcode::StatementKind::words;
  switch (statement.kind) {
    case gcode::StatementKind::words: return execute_words(page, statement, registers);
    case gcode::StatementKind::dprnt:
    case gcode::StatementKind::bprnt: printer_.print(page, statement, registers); break;
    case gcode::StatementKind::setvn:
      for (std::uint32_t i = 0; i < statement.count; ++i) {
        const gcode::VariableName& name = page.variable_names[statement.first + i];
        variables_.name(name.name, name.number);
      }
      return Verdict::go_on;
    case gcode::StatementKind::popen:
    case gcode::StatementKind::pclos: break;
  }
  return Verdict::go_on;
}

// A block of words (docs/dialect/motion.md §8): it is read, its program call is made or its acts
// are done, hole after hole of a cycle as long as the receiver takes them; then stops, ends, calls.

void GcodeControl::begin(const gcode::GcodePage& page, const gcode::Statement& statement) {
  const vm::BlockMark& mark = page.marks[statement.mark];
  state_.line = mark.line;
  state_.before = state_.modal;
  block_memory_.keep(state_);
  state_.path.begin_block(run_by(running(), page.id_of(mark)));
  in_block_ = true;
  block_.number = mark.sequence;
  transferred_ = false;
  acts_.begin();
}

Verdict GcodeControl::execute_words(const gcode::GcodePage& page, const gcode::Statement& statement,
                                    const double* registers) {
  if (shapes_.active() && shapes_.is_behind(page.marks[statement.mark].sequence))
    return come_behind_shape();
  begin(page, statement);
  const std::span<const Word> words = block_words_ = reader_.fetch(page, statement, registers);
  call_name_.clear();
  if (statement.name >= 0) call_name_ = page.names[static_cast<std::size_t>(statement.name)];
  if (statement.may_call || call_reader_.codes_call_macros() || programs_.modal_active()) {
    BlockCall call;
    if (!call_reader_.find(words, call)) return Verdict::stop;
    if (call.kind != BlockCall::Kind::none) return execute_call(words, call);
  }
  if (!reader_.collect(words, block_)) return Verdict::stop;
  if (!shapes_.admits(block_.words)) return Verdict::stop;
  if (!acts_.execute(block_)) return Verdict::stop;
  return continue_block();
}

Verdict GcodeControl::execute_call(std::span<const Word> words, const BlockCall& call) {
  if (shapes_.active()) {
    alarms_.raise(Code::shape_command, "a macro call");
    return Verdict::stop;
  }
  if (!call_program(words, call)) return Verdict::stop;
  buffer_.release();
  in_block_ = false;
  return transferred_ ? Verdict::transferred : Verdict::go_on;
}

// CALL-4: what stands before the call must be G codes, which act as usual; what stands behind it
// are arguments.
bool GcodeControl::call_program(std::span<const Word> words, const BlockCall& call) {
  const auto before = words.first(call.first_argument == 0 ? 0 : call.first_argument - 1);
  if (!call_reader_.admits_before(before, call)) return false;
  if (!before.empty()) {
    if (!reader_.collect(before, block_) || !acts_.execute(block_) || !state_.path.end_block())
      return false;
  }
  const std::size_t depth = interpreter_.depth();
  const bool good = calls_.call(words.subspan(call.first_argument), call, call_name_);
  transferred_ = interpreter_.depth() != depth;
  return good;
}

Verdict GcodeControl::continue_block() {
  mid_block_ = false;
  buffer_.release();
  if (acts_.shapes().request() && !shapes_.active()) return go_to_shape();
  while (acts_.has_steps()) {
    if (!buffer_.ready()) {
      mid_block_ = true;
      return Verdict::pause;
    }
    if (!acts_.step()) return Verdict::stop;
    buffer_.release();
  }
  return finish_block();
}

Verdict GcodeControl::go_to_shape() {
  if (ends_ == Ends::with_text && programs_.in_main()) {
    alarms_.raise(Code::cycle_in_mdi);
    return Verdict::stop;
  }
  if (!shapes_.go(block_, block_words_)) return Verdict::stop;
  in_block_ = false;
  return Verdict::transferred;
}

// The last block of the shape has no words: this one is executed again behind the cycle.
Verdict GcodeControl::come_behind_shape() {
  if (shapes_.reading()) return rough_shape();
  return shapes_.finish_making() ? Verdict::transferred : Verdict::stop;
}

Verdict GcodeControl::rough_shape() {
  in_block_ = true;
  if (!shapes_.finish_reading(block_)) return Verdict::stop;
  const Verdict verdict = continue_block();
  return verdict == Verdict::go_on ? Verdict::transferred : verdict;
}

// A block that is read commands nothing; behind the last one the cycle goes on.
Verdict GcodeControl::finish_shape_block() {
  if (!shapes_.end_block(block_) || !state_.path.end_block()) return Verdict::stop;
  if (shapes_.is_last(block_)) return rough_shape();
  in_block_ = false;
  return Verdict::go_on;
}

Verdict GcodeControl::stopped(Halt halt) {
  halt_ = halt;
  return halt == Halt::end || halt == Halt::alarm ? Verdict::stop : Verdict::pause;
}

Verdict GcodeControl::finish_block() {
  if (shapes_.reading()) return finish_shape_block();
  if (!at_optional_stop_) {
    acts_.finish(block_.words);
    if (!state_.path.end_block()) return Verdict::stop;
    tell_lost_corner(state_);
  }
  at_optional_stop_ = acts_.codes().optional_stop;
  if (!at_optional_stop_ || come_to_optional_stop()) return end_block();
  if (alarms_.alarm()) return Verdict::stop;
  mid_block_ = true;
  return Verdict::pause;
}

// M01 suppresses buffering, whether its switch is on or off: the switch counts that stands when the
// axes have come here. False: they have not, or there is an alarm.
bool GcodeControl::come_to_optional_stop() {
  if (!state_.path.holds_corner() && !state_.path.release()) return false;
  buffer_.release();
  return surroundings_.axes_have_arrived();
}

Halt GcodeControl::halt_of_block() const {
  const Auxiliary::Codes& codes = acts_.codes();
  if (codes.end) return Halt::end;
  if (codes.optional_stop && optional_stop_) return Halt::optional_stop;
  return codes.stop ? Halt::program_stop : Halt::none;
}

// False: an alarm was raised.
bool GcodeControl::stop_behind(Halt halt) {
  const bool passed = std::exchange(at_optional_stop_, false) && !optional_stop_;
  if (halt != Halt::none && !state_.path.release()) return false;
  if (halt == Halt::program_stop || halt == Halt::optional_stop)
    state_.path.act(motion::Stop{halt == Halt::optional_stop});
  if (halt == Halt::none && passed) state_.path.act(motion::Stop{true, true});
  if (halt == Halt::end) state_.path.act(motion::End{});
  buffer_.release();
  return true;
}

Verdict GcodeControl::end_program() {
  if (acts_.codes().rewind) {
    state_.memory.parts += 1;
    ++state_.memory.revision;
  }
  return stopped(Halt::end);
}

Verdict GcodeControl::end_block() {
  const Halt halt = halt_of_block();
  if (!stop_behind(halt)) return Verdict::stop;
  in_block_ = false;
  if (halt == Halt::end) return end_program();
  if (!interrupt_.obey(acts_.codes(), block_.words, state_) || !finish_calls())
    return Verdict::stop;
  if (halt != Halt::none) return stopped(halt);
  if (single_block_) return stopped(Halt::single_block);
  if (!buffer_.ready()) return Verdict::pause;
  return transferred_ ? Verdict::transferred : Verdict::go_on;
}

bool GcodeControl::finish_calls() {
  const Auxiliary::Codes& codes = acts_.codes();
  const std::size_t depth = interpreter_.depth();
  const bool good = codes.return_ ? calls_.return_from_program(block_.words)
                                  : calls_.finish(block_, codes, acts_.moved(), call_name_);
  transferred_ = codes.return_ || interpreter_.depth() != depth;
  if (!good || !shapes_.is_last(block_)) return good;
  transferred_ = true;
  return shapes_.finish_making();
}

// Macro statements

std::string GcodeControl::comment_of_block() {
  const auto& page = static_cast<const gcode::GcodePage&>(
      library_.page(interpreter_.running_code(), interpreter_.running().page));
  return std::string(page.comment_of(interpreter_.running().instruction));
}

Verdict GcodeControl::raise_user_alarm(double number) {
  const bool itself = parameters_.alarm_number_itself;
  if (const auto alarm = user_alarm(number, itself, interpreter_.place(), comment_of_block())) {
    alarms_.report(*alarm);
  } else {
    alarms_.raise(Code::argument_range,
                  "#3000 takes 0 to " + std::to_string(most_user_alarm(itself)));
  }
  return Verdict::stop;
}

Verdict GcodeControl::show_message(double number) {
  if (vm::is_null(number)) {
    alarms_.raise(Code::argument_range, "#3006 takes a number, not a vacant value");
    return Verdict::stop;
  }
  state_.path.begin_block(block());
  if (!state_.path.release()) return Verdict::stop;
  state_.path.act(motion::Message{motion::ShortText(comment_of_block())});
  state_.path.act(motion::Stop{false});
  buffer_.release();
  halt_ = Halt::message;
  return Verdict::pause;
}

// M96: the interrupt program runs on local variables of its own, between two blocks.
bool GcodeControl::take_interrupt() {
  const std::uint32_t program = interrupt_.take();
  if (program != 0) return programs_.call_fixed(program, 1, ProgramCalls::Kind::interrupt);
  miss_interrupt();
  return true;
}

// Where a block begins; the interrupt program comes back to it.
Verdict GcodeControl::answer_interrupt() {
  const std::size_t depth = interpreter_.depth();
  if (!take_interrupt()) return Verdict::stop;
  return interpreter_.depth() == depth ? Verdict::go_on : Verdict::transferred;
}

}  // namespace kerf::control
