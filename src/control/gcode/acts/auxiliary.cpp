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
constexpr std::int64_t kMostSpeed = 99999;
constexpr double kMostFeed = 240000;  // mm/min
constexpr int kMostMCodes = 3;        // M3B

}  // namespace

bool Auxiliary::read(const Words& words) {
  State& s = state_;
  std::int64_t value = 0;
  if (!read_feed(words)) return false;
  if (words.has('S') && words.has_g(Meaning::preset)) {  // G92 S: the highest speed of G96
    if (!s.values.integer(words['S'], 0, kMostSpeed, value)) return false;
    s.words.max_rpm = static_cast<double>(value);
  } else if (words.has('S')) {
    if (!s.values.integer(words['S'], 0, kMostSpeed, value)) return false;
    const int most = s.parameters.spindle_max_rpm;
    if (most > 0 && value > most && s.modal[Group::speed] == Meaning::constant_rpm) {
      return s.alarms.raise(Code::speed_over_max, words['S'].text,
                            "the spindle turns at most " + std::to_string(most) + " rpm");
    }
    s.words.speed = static_cast<double>(value);
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

void Auxiliary::turn(motion::Spindle::Turning turning) {
  state_.words.turning = turning;
  tell_spindle();
}

void Auxiliary::tell_spindle() {
  const motion::Spindle spindle = state_.spindle();
  told_centre_ = spindle.centre;
  state_.path.act(spindle);
}

void Auxiliary::follow_work_zero() {
  const bool turns = motion::Spindle::turns(state_.words.turning);
  if (!turns || state_.modal[Group::speed] != Meaning::surface_speed) return;
  if (state_.spindle().centre != told_centre_) tell_spindle();
}

void Auxiliary::before_motion(const Words& words) {
  bool told = false;
  for (const Words::M* m = words.m_begin(); m != words.m_end(); ++m) {
    const Function function = m->function();
    if (m->row != nullptr && m->row->moment == Moment::before_motion) act(*m->row);
    told |=
        function == Function::spindle_clockwise || function == Function::spindle_counterclockwise;
  }
  if (words.has('T') && state_.codes.habits().tool_brings_offset) turret_.turn();
  const bool turning = motion::Spindle::turns(state_.words.turning);
  const bool changes_speed =
      !words.has_g(Meaning::preset) || state_.modal[Group::speed] == Meaning::surface_speed;
  if (words.has('S') && turning && !told && changes_speed) tell_spindle();
}

void Auxiliary::after_motion(const Words& words, std::optional<std::uint32_t> used) {
  for (const Words::M* m = words.m_begin(); m != words.m_end(); ++m) {
    if (m->row == nullptr) {
      const auto number = static_cast<std::uint32_t>(code_of(*m->word));
      if (number != used) state_.path.act(motion::AuxiliaryCode{number});
    } else if (m->row->moment == Moment::behind_motion) {
      act(*m->row);
    }
  }
}

void Auxiliary::act(const FunctionRow& code) {
  using Turning = motion::Spindle::Turning;
  using Flow = motion::Coolant::State;
  switch (code.function) {
    case Function::spindle_clockwise: turn(Turning::clockwise); break;
    case Function::spindle_counterclockwise: turn(Turning::counterclockwise); break;
    case Function::spindle_stop: turn(Turning::stopped); break;
    case Function::spindle_orient: turn(Turning::oriented); break;
    case Function::tool_change:
      state_.path.act(motion::ToolChange{static_cast<std::uint32_t>(state_.words.tool)});
      break;
    case Function::mist: state_.path.act(motion::Coolant{Flow::mist}); break;
    case Function::flood: state_.path.act(motion::Coolant{Flow::flood}); break;
    case Function::coolant_off: state_.path.act(motion::Coolant{Flow::off}); break;
    case Function::rigid_tapping:
      state_.rigid_tapping = true;
      state_.moved_since_m29 = false;
      state_.path.act(motion::AuxiliaryCode{code.number});
      break;
    default: break;  // of the program's flow
  }
}

}  // namespace kerf::control
