#include "control/laser/laser_control.hpp"

#include <numbers>
#include <utility>

#include "base/decimal.hpp"
#include "lang/vm/value.hpp"

namespace kerf::control {
namespace {

using base::Code;
using basic::Inquiry;
using basic::StatementKind;
using vm::Fault;
using vm::Verdict;

Code code_of(Fault fault) {
  switch (fault) {
    case Fault::zero_divide: return Code::basic_zero_divide;
    case Fault::overflow:
    case Fault::domain: return Code::basic_domain;
    case Fault::zero_step: return Code::basic_zero_step;
    case Fault::loop_depth: return Code::basic_loop_depth;
    case Fault::loop_not_open: return Code::basic_next_without_for;
    case Fault::call_depth: return Code::basic_call_depth;
    case Fault::return_without_call: return Code::basic_return;
    case Fault::steps_spent: return Code::basic_steps;
    case Fault::label_missing: return Code::basic_undefined_label;
    case Fault::none:
    case Fault::integer_overflow:
    case Fault::label_range:
    case Fault::region_open:
    case Fault::region_crossing:
    case Fault::region_not_entered: break;  // of no instruction of this language
  }
  return Code::basic_syntax;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

}  // namespace

LaserControl::LaserControl(const Parameters& parameters, const motion::AxisSetup& axes,
                           const Memory& memory, basic::BasicProgram& program,
                           Surroundings& surroundings, motion::MotionSink& sink)
    : parameters_(parameters),
      memory_(memory),
      program_(program),
      surroundings_(surroundings),
      sink_(sink),
      outlet_(alarms_, surroundings,
              axes.linked ? Outlet::Machine::is_asked : Outlet::Machine::makes_all, nullptr, sink),
      moves_(axes, alarms_, assumptions_, outlet_,
             [this](Code code, const std::string& detail) { warn(code, place(), detail, kName); }) {
}

void LaserControl::start() {
  const std::size_t variables = program_.variables().size();
  globals_.assign(variables > basic::kNear ? variables - basic::kNear : 0, vm::kNull);
  vm::Interpreter::Settings settings;
  settings.locals = basic::kNear;
  settings.globals = globals_;
  if (parameters_.statement_limit > 0)
    settings.steps = static_cast<std::uint64_t>(parameters_.statement_limit);
  vm::Host& host = *this;
  interpreter_ = std::make_unique<vm::Interpreter>(program_, host, settings);
  interpreter_->start(basic::BasicProgram::kCode);
  learn_tracing();
  if (const auto pi = program_.find_variable("PI")) set_variable(*pi, std::numbers::pi);
  moves_.start({memory_.external + memory_.work[0], parameters_.invert_y});
  print_.reset();
  halt_ = Halt::none;
}

double LaserControl::variable(std::uint32_t number) {
  if (!interpreter_) return vm::kNull;
  return number < basic::kNear ? interpreter_->locals_of_first_level()[number]
                               : globals_[number - basic::kNear];
}

void LaserControl::set_variable(std::uint32_t number, double value) {
  if (!interpreter_) return;
  (number < basic::kNear ? interpreter_->locals_of_first_level()[number]
                         : globals_[number - basic::kNear]) = value;
}

void LaserControl::reset() {
  alarms_.clear();
  forget_warnings();
  outlet_.reset();
  moves_.beam_off();
  interpreter_.reset();
  halt_ = Halt::none;
}

// What went wrong, the beam goes off: that is the last thing handed out.
Halt LaserControl::run(std::uint64_t instructions) {
  halt_ = Halt::none;
  interpreter_->run(instructions);
  if (alarms_.alarm()) {
    halt_ = Halt::alarm;
    if (!may_pass_) moves_.beam_off();
  }
  return halt_;
}

ModalView LaserControl::modal() const {
  ModalView view;
  view.feed = moves_.programmed_speed();
  view.speed = moves_.programmed_power();
  return view;
}

std::vector<std::string> LaserControl::modal_text(const ModalView& modal) const {
  return {"SPEED " + base::number_text(base::tidy(modal.feed)),
          "POWER " + base::number_text(base::tidy(modal.speed))};
}

// A recursion is as deep as it likes: only the nearest calls are told.
std::string LaserControl::callers() {
  constexpr std::size_t kMostTold = 3;
  std::string text;
  const std::size_t depth = interpreter_ ? interpreter_->depth() : 1;
  for (std::size_t call = depth; call-- > 1 && depth - call <= kMostTold;) {
    text += (text.empty() ? "called from line " : ", line ") +
            std::to_string(interpreter_->place_of_call(call).line);
  }
  return text;
}

// vm::Host

Verdict LaserControl::begin_block(const vm::CodePage& page, const vm::BlockMark& mark) {
  const bool behind_statement = std::exchange(in_statement_, true);
  const Verdict verdict = ProgramControl::begin_block(page, mark);
  if (verdict != Verdict::go_on || !behind_statement || !single_block_) return verdict;
  return halt_with(Halt::single_block, Verdict::pause);
}

Verdict LaserControl::execute(const vm::CodePage& code_page, std::uint32_t block,
                              const double* registers) {
  const auto& page = static_cast<const basic::BasicPage&>(code_page);
  const basic::Statement& statement = page.statements[block];
  if (!statement.goes_on) ++blocks_;
  if (statement.kind == StatementKind::print || statement.kind == StatementKind::prompt) {
    print(page, statement, registers);
    return Verdict::go_on;
  }
  if (statement.kind == StatementKind::end) return end_of_program();
  moves_.stand_at(this->block());
  std::array<double, 6> arguments{};
  for (std::uint32_t i = 0; i < statement.count; ++i)
    arguments[i] = vm::zero_if_null(registers[statement.first + i]);
  if (!move(statement, std::span(arguments).first(statement.count))) return Verdict::stop;
  return sink_.ready() ? Verdict::go_on : Verdict::pause;
}

bool LaserControl::move(const basic::Statement& statement, std::span<const double> arguments) {
  switch (statement.kind) {
    case StatementKind::home: return moves_.home();
    case StatementKind::speed: return moves_.speed(arguments[0]);
    case StatementKind::power: return moves_.power(arguments[0]);
    case StatementKind::move: return moves_.move(arguments);
    case StatementKind::line: return moves_.line(arguments);
    case StatementKind::arc: return moves_.arc(arguments);
    case StatementKind::circle: return moves_.circle(arguments);
    case StatementKind::wait: return moves_.wait(arguments[0]);
    case StatementKind::burn: return moves_.burn(arguments[0]);
    case StatementKind::pulse: return moves_.pulse(arguments[0], arguments[1]);
    case StatementKind::air: return moves_.air(arguments[0]);
    case StatementKind::print:
    case StatementKind::prompt:
    case StatementKind::end: break;
  }
  return true;
}

void LaserControl::print(const basic::BasicPage& page, const basic::Statement& statement,
                         const double* registers) {
  const auto items = std::span(page.items).subspan(statement.first, statement.count);
  surroundings_.print(print_.text_of(page, items, registers));
}

std::optional<double> LaserControl::peek(double number) const {
  switch (Inquiry{static_cast<std::uint32_t>(number)}) {
    case Inquiry::x: return moves_.position().x;
    case Inquiry::y: return moves_.position().y;
    case Inquiry::z: return moves_.position().z;
    case Inquiry::moved: return moves_.moved();
    case Inquiry::input: return std::nullopt;
    default: return 0;  // a variable that was never written
  }
}

vm::Interpreter::Settings LaserControl::evaluation_settings() {
  vm::Interpreter::Settings settings;
  settings.locals = basic::kNear;
  settings.globals = globals_;
  return settings;
}

// A variable that was never written, the recorded position, or a number that the operator enters.
Verdict LaserControl::read(double number, double& value) {
  const auto inquiry = static_cast<std::uint32_t>(number);
  value = 0;
  switch (Inquiry{inquiry}) {
    case Inquiry::x: value = moves_.position().x; break;
    case Inquiry::y: value = moves_.position().y; break;
    case Inquiry::z: value = moves_.position().z; break;
    case Inquiry::moved: value = moves_.moved(); break;
    case Inquiry::input: return read_input(value);
    default:
      warn(Code::basic_unset, place(), program_.variables()[inquiry], kName);
      set_variable(inquiry, 0);
  }
  return Verdict::go_on;
}

Verdict LaserControl::read_input(double& value) {
  if (!surroundings_.input_can_be_read()) return Verdict::again;
  const std::optional<std::string> line = surroundings_.input();
  if (!line) {
    alarms_.raise(Code::basic_input, "nothing is left to read");
    return Verdict::stop;
  }
  const auto number = base::read_number(trimmed(*line));
  if (!number) {
    alarms_.raise(Code::basic_input, "this is no number: " + line->substr(0, 40));
    return Verdict::stop;
  }
  value = *number;
  return Verdict::go_on;
}

// No statement writes to the host.
Verdict LaserControl::write(double /*number*/, double /*value*/) { return Verdict::stop; }

void LaserControl::fault(Fault fault) {
  alarms_.raise(code_of(fault),
                fault == Fault::overflow ? "the result is too large for a number" : "");
}

Verdict LaserControl::end_of_program() {
  moves_.stand_at(block());
  if (moves_.end()) halt_ = Halt::end;
  return Verdict::stop;
}

// The end of the text is an END.
Verdict LaserControl::end_of_code() { return end_of_program(); }

}  // namespace kerf::control
