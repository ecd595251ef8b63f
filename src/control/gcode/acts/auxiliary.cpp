#include "control/gcode/acts/auxiliary.hpp"

#include <utility>

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"
#include "motion/feed.hpp"

namespace kerf::control {
namespace {

using base::Code;
using gcode::Word;
using gcode::WordFlag;

constexpr std::int64_t kMostCode = 99999999;
constexpr std::int64_t kMostLimit_rpm = 99999;
constexpr double kMostFeed = 240000;  // mm/min
constexpr int kMostMCodes = 3;        // M3B

// Where the machine file does not say what a code is for, most builders' habits do.
std::optional<BuilderFunction> likely_function(std::uint32_t number) {
  if (number >= 100 && number <= 199) return BuilderFunction::wait;
  if (number >= 200 && number <= 299) return BuilderFunction::sub_spindle;
  return std::nullopt;
}

void tell_of_builder(State& state, std::uint32_t number, std::optional<BuilderFunction> function) {
  const bool known = function.has_value();
  if (!known) function = likely_function(number);
  std::uint32_t kind = Assumed::builder_m;
  std::string what = "is the builder's: it is passed on, what it does is not known";
  if (function) {
    const std::string is = known ? "is" : "may be";
    kind = Assumed::builder_function + static_cast<std::uint32_t>(*function);
    switch (*function) {
      case BuilderFunction::wait:
        what = is + " a wait code of two turrets: it is passed on, nothing waits";
        break;
      case BuilderFunction::bar_feeder:
        what = is + " a code of the bar feeder: it is passed on, no bar moves";
        break;
      case BuilderFunction::catcher:
        what = is + " a code of the parts catcher: it is passed on, no part is caught";
        break;
      case BuilderFunction::sub_spindle:
        what = is + " a code of the sub-spindle: it is passed on, no part changes hands";
        break;
      default: return;
    }
  }
  if (state.assumptions.is_new(kind))
    state.assumptions.add(state.line, "M" + std::to_string(number) + " " + what);
}

}  // namespace

bool Auxiliary::read(const Words& words) {
  State& s = state_;
  std::int64_t value = 0;
  if (!read_feed(words)) return false;
  spindles_.choose(words);
  if (words.has('S') && words.has_g(Meaning::preset)) {  // G92 S: the highest speed of G96
    if (!s.values.integer(words['S'], 0, kMostLimit_rpm, value)) return false;
    s.words.max_rpm = static_cast<double>(value);
  } else if (words.has('S') && !spindles_.read_speed(words['S'])) {
    return false;
  }
  if (words.has('T') && !read_tool(words['T'])) return false;
  if (words.has('E') && !s.values.plain(words['E'], s.words.e)) return false;
  if (s.codes.habits().tool_brings_offset) return true;  // H and D belong to axes and cycles
  return read_offset(words, 'H', s.words.length_offset) &&
         read_offset(words, 'D', s.words.radius_offset);
}

bool Auxiliary::read_tool(const Word& word) {
  if (state_.codes.habits().tool_brings_offset) return turret_.read(word);
  return state_.values.integer(word, 0, kMostCode, state_.words.tool);
}

// NUM-4, NUM-5. F is kept in mm; what it counts depends on the feed mode.
bool Auxiliary::read_feed(const Words& words) {
  if (!words.has('F')) return true;
  State& s = state_;
  const Word& word = words['F'];
  double value = 0;
  if (word.value < 0) return s.alarms.raise(Code::illegal_minus, word.text);
  if (!s.values.plain(word, value)) return false;
  const motion::FeedMode mode = s.modal.feed_mode();
  const bool inch = s.modal.inch();
  const bool bare =
      word.has(WordFlag::literal) && !word.has(WordFlag::point) && !s.parameters.calculator_point;
  if (bare && (mode == motion::FeedMode::per_revolution ||
               (mode == motion::FeedMode::per_minute && inch))) {
    value *= 0.01;
    s.assume(Assumed::feed_hundredths,
             "F without a decimal point counts 0.01 (per revolution, or inch per minute)");
  }
  s.words.feed_programmed = value;
  if (mode != motion::FeedMode::inverse_time && inch)
    value = base::tidy(value * motion::kMillimetresPerInch);
  if (value > kMostFeed) {
    return s.alarms.raise(Code::improper_address_word, word.text,
                          "the largest feed is 240000 mm/min");
  }
  s.words.feed = value;
  return true;
}

bool Auxiliary::read_offset(const Words& words, char letter, std::int64_t& number) {
  if (!words.has(letter)) return true;
  std::int64_t value = 0;
  if (!state_.values.integer(words[letter], 0, kMostCode, value)) return false;
  if (value > state_.parameters.n_offsets) {
    return state_.alarms.raise(
        Code::illegal_offset_number, words[letter].text,
        "the control has " + std::to_string(state_.parameters.n_offsets) + " offsets");
  }
  number = value;
  return true;
}

bool Auxiliary::read_codes(const Words& words, Codes& codes) {
  int count = 0;
  for (const Words::M* m = words.m_begin(); m != words.m_end(); ++m) {
    std::int64_t code = 0;
    if (!state_.values.integer(*m->word, 0, kMostCode, code)) return false;
    if (++count > kMostMCodes) {
      return state_.alarms.raise(Code::improper_address_word, m->word->text,
                                 "a block takes three M codes");
    }
    state_.words.last_m = code;
    if (!codes.add(m->function())) return state_.alarms.raise(Code::two_sub_calls, m->word->text);
  }
  return true;
}

bool Auxiliary::Codes::add(Function function) {
  switch (function) {
    case Function::stop: stop = true; return true;
    case Function::optional_stop: optional_stop = true; return true;
    case Function::end_and_rewind: rewind = end = true; return true;
    case Function::end: end = true; return true;
    case Function::interrupt_on: interrupt_on = true; return true;
    case Function::interrupt_off: interrupt_off = true; return true;
    case Function::call: return !std::exchange(call, true);
    case Function::external_call: return !std::exchange(external_call, true);
    case Function::return_: return_ = true; return true;
    default: return true;
  }
}

void Auxiliary::before_motion(const Words& words) {
  bool told = false;
  for (const Words::M* m = words.m_begin(); m != words.m_end(); ++m) {
    const Function function = m->function();
    if (m->row == nullptr) switch_c_axis_on(*m->word);
    if (m->row != nullptr && m->row->moment == Moment::before_motion) act(*m, words);
    told |=
        function == Function::spindle_clockwise || function == Function::spindle_counterclockwise;
  }
  if (words.has('T') && state_.codes.habits().tool_brings_offset) turret_.turn();
  const bool turning = motion::Spindle::turns(state_.words.turning);
  const bool changes_speed = !words.has_g(Meaning::preset) || state_.has_surface_speed();
  if (words.has('S') && turning && !told && changes_speed) spindles_.tell();
}

void Auxiliary::after_motion(const Words& words, std::optional<std::uint32_t> used) {
  for (const Words::M* m = words.m_begin(); m != words.m_end(); ++m) {
    if (m->row == nullptr) {
      const auto number = static_cast<std::uint32_t>(code_of(*m->word));
      if (number != used) pass_on(number);
    } else if (m->row->moment == Moment::behind_motion) {
      act(*m, words);
    }
  }
}

// The block's own motion may be of the axis.
void Auxiliary::switch_c_axis_on(const Word& word) {
  const std::int64_t number = code_of(word);
  if (state_.parameters.machine_codes.function_of(number) != BuilderFunction::c_axis_on) return;
  state_.c_axis_is_on = true;
  state_.path.act(motion::AuxiliaryCode{static_cast<std::uint32_t>(number)});
}

void Auxiliary::pass_on(std::uint32_t number) {
  const auto function = state_.parameters.machine_codes.function_of(number);
  if (function == BuilderFunction::c_axis_on) return;  // passed on before the motion
  if (function == BuilderFunction::c_axis_off) state_.c_axis_is_on = false;
  if (state_.codes.habits().tool_brings_offset) tell_of_builder(state_, number, function);
  state_.path.act(motion::AuxiliaryCode{number});
}

void Auxiliary::act(const Words::M& code, const Words& words) {
  using Flow = motion::Coolant::State;
  switch (code.function()) {
    case Function::spindle_clockwise:
    case Function::spindle_counterclockwise:
    case Function::spindle_stop:
    case Function::spindle_orient: spindles_.act(code, words); break;
    case Function::tool_change:
      state_.path.act(motion::ToolChange{static_cast<std::uint32_t>(state_.words.tool)});
      break;
    case Function::mist: state_.path.act(motion::Coolant{Flow::mist}); break;
    case Function::flood: state_.path.act(motion::Coolant{Flow::flood}); break;
    case Function::coolant_off: state_.path.act(motion::Coolant{Flow::off}); break;
    case Function::rigid_tapping:
      state_.rigid_tapping = true;
      state_.moved_since_m29 = false;
      state_.path.act(motion::AuxiliaryCode{code.row->number});
      break;
    default: break;  // of the program's flow
  }
}

}  // namespace kerf::control
