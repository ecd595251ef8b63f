#include "control/gcode/controller.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/decimal.hpp"
#include "base/refusal.hpp"
#include "control/core/assumed.hpp"
#include "control/gcode/macro/print_format.hpp"
#include "lang/vm/value.hpp"

namespace kerf::control {
namespace {

using base::Code;
using gcode::Word;
using gcode::WordFlag;
using vm::Verdict;

constexpr int kMostAlarm = 200;      // #3000 with MCA = 0
constexpr int kMostOwnAlarm = 4095;  // with MCA = 1

Code code_of(vm::Fault fault) {
  switch (fault) {
    case vm::Fault::zero_divide: return Code::zero_divide;
    case vm::Fault::overflow: return Code::floating_overflow;
    case vm::Fault::integer_overflow: return Code::integer_overflow;
    case vm::Fault::domain: return Code::argument_range;
    case vm::Fault::label_range: return Code::label_range;
    case vm::Fault::label_missing: return Code::label_not_found;
    case vm::Fault::region_open:
    case vm::Fault::region_crossing: return Code::missing_end;
    case vm::Fault::region_not_entered: return Code::end_without_do;
    case vm::Fault::none:
    case vm::Fault::zero_step:
    case vm::Fault::loop_depth:
    case vm::Fault::loop_not_open:
    case vm::Fault::call_depth:
    case vm::Fault::return_without_call:
    case vm::Fault::steps_spent: break;  // of no instruction of macros
  }
  return Code::macro_format;
}

const char* detail_of(vm::Fault fault) {
  switch (fault) {
    case vm::Fault::label_missing: return "the program has no such sequence number";
    case vm::Fault::region_open: return "no END of this number follows";
    case vm::Fault::region_crossing: return "a loop inside of it ends behind it";
    case vm::Fault::region_not_entered: return "the DO of this END is not active";
    default: return "";
  }
}

}  // namespace

Controller::Controller(const Parameters& parameters, const motion::AxisSetup& axes, Memory& memory,
                       gcode::CodeLibrary& library, ProgramFinder& finder,
                       Surroundings& surroundings, motion::MotionSink& sink)
    : parameters_(parameters),
      axes_(axes),
      library_(library),
      surroundings_(surroundings),
      math_{parameters.signed_angles, parameters.small_is_zero, 1000},
      buffer_(sink),
      state_(mill_codes(), parameters_, axes_, memory, alarms_, assumptions_, surroundings,
             buffer_),
      interpreter_(library, *this, {gcode::kLocals, memory.commons, &math_}),
      targets_(state_),
      moves_(state_, targets_),
      settings_(state_, targets_, moves_),
      data_setting_(state_, targets_),
      references_(state_, targets_, moves_),
      auxiliary_(state_),
      cycle_(state_, targets_, moves_),
      calls_(state_, interpreter_, library, finder),
      variables_(state_, library.names()) {
  targets_.learn_letters();
  variables_.attach(&interpreter_, [this] { return started() ? calls_.running_number() : 0; });
  if (const auto z = axes.find('Z')) state_.length_axis = *z;
  learn_parameters();
}

// What is kept ready of the parameters, at power-on and after their entry by G10 L50.
void Controller::learn_parameters() {
  state_.refresh_format();
  state_.path.configure({parameters_.start_up, parameters_.corner_arc});
  math_.signed_angles = parameters_.signed_angles;
  math_.small_is_zero = parameters_.small_is_zero;
  learn_calling_codes();
}

void Controller::learn_calling_codes() {
  const auto any = [](const auto& codes) {
    return std::any_of(codes.begin(), codes.end(), [](int code) { return code != 0; });
  };
  codes_call_macros_ = any(parameters_.g_macro) || any(parameters_.m_macro);
  codes_call_subprograms_ = any(parameters_.m_sub) || parameters_.t_calls_program ||
                            parameters_.s_calls_program || parameters_.b_calls_program;
}

void Controller::start(vm::CodeId main, Ends ends) {
  ends_ = ends;
  LocalVariables kept;
  if (parameters_.keep_locals && interpreter_.depth() > 0) {
    std::copy_n(first_level_locals().begin(), kept.size(), kept.begin());
  } else {
    kept.fill(vm::kNull);
  }
  interpreter_.start(main);
  std::copy(kept.begin(), kept.end(), first_level_locals().begin());
  calls_.start(main);
  halt_ = Halt::none;
  mid_block_ = at_optional_stop_ = false;
  in_block_ = false;
}

void Controller::reset() {
  alarms_.clear();
  halt_ = Halt::none;
  mid_block_ = at_optional_stop_ = false;
  interrupt_pending_ = false;
  interrupt_program_ = 0;
  cycle_.stop();
  cycle_.cancel();
  state_.path.reset();
  state_.coordinates.set_transform({});
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    state_.coordinates.set_local(base::Axis{static_cast<std::uint8_t>(i)}, 0);
  }
  state_.set_length(state_.length_axis, 0);
  state_.coordinates.select({});
  state_.wanted_length = 0;
  state_.modal = ModalState(state_.codes, parameters_);
  state_.before = state_.modal;
  state_.refresh_format();
  state_.words = {};
  state_.rigid_tapping = false;
  state_.parameter_entry = false;
  state_.block_control = state_.feed_control = 0;
  if (!parameters_.keep_commons) state_.memory.clear_volatile();
}

base::AxisVector Controller::machine_position() const {
  return state_.path.tip() + state_.coordinates.length();
}

void Controller::stand_at(const base::AxisVector& tip) {
  state_.path.stand_at(tip);
  state_.coordinates.arrive_at(tip);
}

Halt Controller::run(std::uint64_t instructions) {
  halt_ = Halt::none;
  if (resume()) interpreter_.run(instructions);
  if (alarms_.alarm()) settle_alarm();
  return halt_;
}

// What a run begins with: the rest of a block that was left, then an interrupt. False: the run ends
// here.
bool Controller::resume() {
  if (mid_block_) {
    const Verdict verdict = continue_block();
    if (verdict == Verdict::stop || verdict == Verdict::pause) return false;
  }
  return !interrupt_pending_ || take_interrupt();
}

// Moves that were commanded before the alarm are made, also those that waited for the next one. The
// block that is wrong switches nothing.
void Controller::settle_alarm() {
  halt_ = Halt::alarm;
  cycle_.stop();
  static_cast<void>(state_.path.release());  // a second alarm changes nothing
  if (in_block_) buffer_.drop_functions_of(state_.path.source().program, state_.line);
  buffer_.release();
}

// A macro statement changes nothing before its alarm: what was kept is of a block before it.
void Controller::undo_block() {
  mid_block_ = false;
  if (in_block_) block_memory_.restore(state_);
  in_block_ = false;
  BlockMemory::settle(state_);
  if (!state_.modal.in_cycle()) cycle_.cancel();
}

std::optional<double> Controller::peek(double number) {
  if (alarms_.alarm()) return std::nullopt;
  double value = vm::kNull;
  if (variables_.read(number, value)) return value;
  alarms_.clear();
  return std::nullopt;
}

vm::Interpreter::Settings Controller::evaluation_settings() {
  return {gcode::kLocals, state_.memory.commons, &math_};
}

base::Outcome<void> Controller::set_variable(std::uint32_t number, double value) {
  SystemVariables::Event event;
  const bool good =
      variables_.write(number, value, event) && event.kind == SystemVariables::Event::Kind::none;
  if (good) return {};
  const auto alarm = alarms_.alarm();
  alarms_.clear();
  return tl::unexpected(
      base::refuse_for(alarm ? alarm->number : "", base::Refusal::variable_not_set,
                       {std::to_string(number), alarm ? alarm->message : "it cannot be set"}));
}

// vm::Host

// Clocks and inputs are read when the axes have come to the block.
Verdict Controller::read(double number, double& value) {
  const bool waits = SystemVariables::is_clock(number) || SystemVariables::is_input(number);
  if (waits && !surroundings_.axes_have_arrived()) return Verdict::again;
  return variables_.read(number, value) ? Verdict::go_on : Verdict::stop;
}

Verdict Controller::write(double number, double value) {
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

void Controller::fault(vm::Fault fault) { alarms_.raise(code_of(fault), detail_of(fault)); }

void Controller::failure(const base::Diagnostic& diagnostic) { alarms_.report(diagnostic); }

Verdict Controller::end_of_code() {
  if (ends_ == Ends::with_text && calls_.in_main()) return end_of_entry();
  alarms_.raise(Code::end_of_record, "the program runs out without M02, M30 or M99");
  return Verdict::stop;
}

// A held corner or compensation has nothing more to wait for.
Verdict Controller::end_of_entry() {
  if (!state_.path.release()) return Verdict::stop;
  state_.path.act(motion::End{});
  buffer_.release();
  return stopped(Halt::end);
}

Verdict Controller::begin_block(const vm::CodePage& page, const vm::BlockMark& mark) {
  const bool behind_statement = std::exchange(in_statement_, true);
  Verdict verdict = announce(page, mark);
  if (verdict == Verdict::go_on && interrupt_pending_) verdict = answer_interrupt();
  if (verdict != Verdict::go_on || !behind_statement) return verdict;
  if (!single_block_ || !parameters_.stop_at_macro) return Verdict::go_on;
  return stopped(Halt::single_block);
}

Verdict Controller::execute(const vm::CodePage& code_page, std::uint32_t block,
                            const double* registers) {
  const auto& page = static_cast<const gcode::GcodePage&>(code_page);
  const gcode::Statement& statement = page.statements[block];
  ++blocks_;
  in_statement_ = statement.kind != gcode::StatementKind::words;
  switch (statement.kind) {
    case gcode::StatementKind::words: return execute_words(page, statement, registers);
    case gcode::StatementKind::dprnt:
    case gcode::StatementKind::bprnt: return print(page, statement, registers);
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

// Macro statements

Verdict Controller::print(const gcode::GcodePage& page, const gcode::Statement& statement,
                          const double* registers) {
  printed_.clear();
  for (std::uint32_t i = 0; i < statement.count; ++i) {
    const gcode::PrintItem& item = page.print_items[statement.first + i];
    if (item.character != 0) {
      printed_ += item.character;
      continue;
    }
    const double value = vm::zero_if_null(registers[item.register_]);
    if (statement.kind == gcode::StatementKind::bprnt) {
      append_binary(printed_, value, item.decimals);
    } else {
      append_printed(printed_, value, item.integers, item.decimals,
                     !parameters_.print_without_blanks);
    }
  }
  printed_ += parameters_.print_cr ? "\r\n" : "\n";
  surroundings_.print(printed_);
  return Verdict::go_on;
}

std::string Controller::callers() {
  std::string text;
  for (std::size_t depth = interpreter_.depth(); depth-- > 1;) {
    text += (text.empty() ? "called from line " : ", line ") +
            std::to_string(interpreter_.place_of_call(depth).line) + " of " +
            calls_.name_at(depth - 1);
  }
  return text;
}

std::string Controller::comment_of_block() {
  const auto& page = static_cast<const gcode::GcodePage&>(
      library_.page(interpreter_.running_code(), interpreter_.running().page));
  return std::string(page.comment_of(interpreter_.running().instruction));
}

// #3000 = n (text): MC 3000 + n, or n itself (MCA).
Verdict Controller::raise_user_alarm(double number) {
  const double rounded = std::round(vm::zero_if_null(number));
  const int most = parameters_.alarm_number_itself ? kMostOwnAlarm : kMostAlarm;
  if (vm::is_null(number) || rounded < 0 || rounded > most) {
    alarms_.raise(Code::argument_range, "#3000 takes 0 to " + std::to_string(most));
    return Verdict::stop;
  }
  std::string digits =
      std::to_string(static_cast<int>(rounded) + (parameters_.alarm_number_itself ? 0 : 3000));
  digits.insert(0, digits.size() < 4 ? 4 - digits.size() : 0, '0');
  base::Diagnostic alarm = base::make_error(Code::user_alarm, interpreter_.place());
  alarm.number = "MC" + digits;
  alarm.message = comment_of_block();
  if (alarm.message.empty()) alarm.message = "macro alarm without a text";
  alarms_.report(alarm);
  return Verdict::stop;
}

Verdict Controller::show_message(double number) {
  if (vm::is_null(number)) {
    alarms_.raise(Code::argument_range, "#3006 takes a number, not a vacant value");
    return Verdict::stop;
  }
  const base::Place place = interpreter_.place();
  state_.path.begin_block({motion::ProgramNumber{calls_.running_number()}, place.line, place.file});
  if (!state_.path.release()) return Verdict::stop;
  state_.path.act(motion::Message{motion::ShortText(comment_of_block())});
  state_.path.act(motion::Stop{false});
  buffer_.release();
  halt_ = Halt::message;
  return Verdict::pause;
}

// M96: the interrupt program runs on local variables of its own, between two blocks.
bool Controller::take_interrupt() {
  interrupt_pending_ = false;
  if (interrupt_program_ == 0) {
    miss_interrupt();
    return true;
  }
  return calls_.call_fixed(interrupt_program_, 1, ProgramCalls::Kind::interrupt);
}

// Where a block begins; the interrupt program comes back to it.
Verdict Controller::answer_interrupt() {
  const std::size_t depth = interpreter_.depth();
  if (!take_interrupt()) return Verdict::stop;
  return interpreter_.depth() == depth ? Verdict::go_on : Verdict::transferred;
}

}  // namespace kerf::control
