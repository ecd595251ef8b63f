#include "control/gcode/acts/spindles.hpp"

#include <algorithm>
#include <string_view>

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"

namespace kerf::control {
namespace {

using base::Code;
using motion::SpindleName;
using Turning = motion::Spindle::Turning;

constexpr std::int64_t kMostSpeed = 99999;

bool is_of_spindle(Function function) {
  return function == Function::spindle_clockwise ||
         function == Function::spindle_counterclockwise || function == Function::spindle_stop ||
         function == Function::spindle_orient;
}

bool starts(Function function) {
  return function == Function::spindle_clockwise || function == Function::spindle_counterclockwise;
}

bool is_called(Function function) {
  return function == Function::call || function == Function::external_call ||
         function == Function::return_ || function == Function::interrupt_on;
}

Turning turning_of(Function function) {
  switch (function) {
    case Function::spindle_clockwise: return Turning::clockwise;
    case Function::spindle_counterclockwise: return Turning::counterclockwise;
    case Function::spindle_orient: return Turning::oriented;
    default: return Turning::stopped;
  }
}

}  // namespace

// P of another code of the block is that code's.
bool Spindles::has_number(const Words& words) const {
  if (!state_.codes.habits().tool_brings_offset || !words.has('P')) return false;
  bool speaks = words.has('S');
  for (const Words::M* m = words.m_begin(); m != words.m_end(); ++m) {
    if (is_called(m->function())) return false;
    speaks |= is_of_spindle(m->function());
  }
  return speaks && std::none_of(words.g_begin(), words.g_end(), [](const Words::G& g) {
           return g.row != nullptr &&
                  std::string_view(g.row->letters).find('P') != std::string_view::npos;
         });
}

const SpindleSettings* Spindles::numbered(const Words& words) const {
  if (!has_number(words)) return nullptr;
  const std::int64_t number = code_of(words['P']);
  const auto& all = state_.parameters.machine_codes.spindles;
  const auto found = std::find_if(all.begin(), all.end(), [=](const SpindleSettings& spindle) {
    return std::find(spindle.numbers.begin(), spindle.numbers.end(), number) !=
           spindle.numbers.end();
  });
  return found == all.end() ? nullptr : &*found;
}

// The machine file's codes first; the dialect's own are the main spindle's, or that of P.
SpindleName Spindles::named_by(const Words::M& code, const Words& words) const {
  if (const auto* const own = state_.parameters.machine_codes.spindle_with(code_of(*code.word));
      own != nullptr && own->name != SpindleName::main)
    return own->name;
  const SpindleSettings* const by_number = numbered(words);
  return by_number != nullptr ? by_number->name : SpindleName::main;
}

void Spindles::tell_number(const Words& words) {
  const SpindleSettings* const spindle = numbered(words);
  const std::string number = "P" + base::number_text(words['P'].value);
  if (!state_.assumptions.is_new(Assumed::spindle_number)) return;
  state_.assumptions.add(
      state_.line, spindle != nullptr
                       ? number + " is the " + std::string(name_of(spindle->name)) +
                             " spindle, as the machine file says"
                       : number + " names a spindle that the machine file does not: the main one");
}

// A code that starts one counts more than one that stops another; G96 and G50 are of the work.
void Spindles::choose(const Words& words) {
  if (has_number(words)) tell_number(words);
  if (!words.has('S') || words.has_g(Meaning::preset)) return;
  const Words::M* named = nullptr;
  for (const Words::M* m = words.m_begin(); m != words.m_end(); ++m) {
    if (is_of_spindle(m->function()) && (named == nullptr || starts(m->function()))) named = m;
  }
  if (named != nullptr) {
    state_.words.choose(named_by(*named, words));
  } else if (has_number(words)) {
    const SpindleSettings* const spindle = numbered(words);
    state_.words.choose(spindle != nullptr ? spindle->name : SpindleName::main);
  } else if (state_.words.spindle == SpindleName::live && words.has_g(Meaning::surface_speed)) {
    state_.words.choose(SpindleName::main);
  }
}

bool Spindles::read_speed(const gcode::Word& word) {
  std::int64_t value = 0;
  if (!state_.values.integer(word, 0, kMostSpeed, value)) return false;
  const double most = state_.most_rpm();
  const bool over = most > 0 && static_cast<double>(value) > most && !state_.has_surface_speed();
  if (over && !state_.codes.habits().tool_brings_offset)
    return state_.alarms.raise(Code::speed_over_max, word.text,
                               "the spindle turns at most " + base::number_text(most) + " rpm");
  if (over && state_.assumptions.is_new(Assumed::speed_clamped))
    state_.assumptions.add(state_.line, "S" + std::to_string(value) + " is more than the " +
                                            std::string(name_of(state_.words.spindle)) +
                                            " spindle can: it turns with " +
                                            base::number_text(most) + " rpm");
  state_.words.speed = static_cast<double>(value);
  state_.words.last_speed = state_.words.speed;
  return true;
}

// One that has had no S of its own yet takes the last one.
void Spindles::act(const Words::M& code, const Words& words) {
  const Function function = code.function();
  state_.words.choose(named_by(code, words));
  if (starts(function) && state_.words.speed == 0) state_.words.speed = state_.words.last_speed;
  state_.words.turning = turning_of(function);
  tell();
  if (!starts(function)) rest();
}

// What stands is chosen no longer where another one turns; a driven tool's never while it stands.
void Spindles::rest() {
  for (const SpindleName name : {SpindleName::live, SpindleName::main, SpindleName::sub}) {
    if (motion::Spindle::turns(state_.words.turning_of(name))) return state_.words.choose(name);
  }
  if (state_.words.spindle == SpindleName::live) state_.words.choose(SpindleName::main);
}

void Spindles::tell() {
  const motion::Spindle spindle = state_.spindle();
  told_centre_ = spindle.centre;
  state_.path.act(spindle);
  if (spindle.turns() && spindle.follows_radius() && spindle.centre != 0 &&
      state_.assumptions.is_new(Assumed::work_zero_off_axis))
    state_.assumptions.add(
        state_.line,
        "G96 takes the zero of the work system for the axis of the spindle: it lies at X" +
            base::number_text(base::tidy(2 * spindle.centre)) + " of the machine");
}

void Spindles::follow_work_zero() {
  if (!motion::Spindle::turns(state_.words.turning) || !state_.has_surface_speed()) return;
  if (state_.spindle().centre != told_centre_) tell();
}

}  // namespace kerf::control
