#include "control/gcode/acts/auxiliary.hpp"

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"

namespace kerf::control {
namespace {

using base::Code;
using gcode::Word;
using gcode::WordFlag;

constexpr GCode kPreset = 920;
constexpr std::int64_t kMostCode = 99999999;
constexpr std::int64_t kMostSpeed = 99999;
constexpr double kMostFeed = 240000;  // mm/min
constexpr int kMostMCodes = 3;        // M3B

bool before_the_move(std::int64_t code) {
  return code == 3 || code == 4 || code == 6 || code == 7 || code == 8 || code == 19 || code == 29;
}

bool flow_code(std::int64_t code) {
  return code <= 2 || code == 30 || (code >= 96 && code <= 99) || code == 198;
}

}  // namespace

bool Auxiliary::read(const Words& words) {
  State& s = state_;
  std::int64_t value = 0;
  if (!read_feed(words)) return false;
  if (words.has('S') && words.has_g(kPreset)) {  // G92 S: the highest speed of G96
    if (!s.values.integer(words['S'], 0, kMostSpeed, value)) return false;
    s.words.max_rpm = static_cast<double>(value);
  } else if (words.has('S')) {
    if (!s.values.integer(words['S'], 0, kMostSpeed, value)) return false;
    const int most = s.parameters.spindle_max_rpm;
    if (most > 0 && value > most && s.modal[Group::speed] == 970) {
      return s.alarms.raise(Code::speed_over_max, words['S'].text,
                            "the spindle turns at most " + std::to_string(most) + " rpm");
    }
    s.words.speed = static_cast<double>(value);
  }
  if (words.has('T')) {
    if (!s.values.integer(words['T'], 0, kMostCode, value)) return false;
    s.words.tool = value;
  }
  if (words.has('E') && !s.values.plain(words['E'], s.words.e)) return false;
  return read_offset(words, 'H', s.words.length_offset) &&
         read_offset(words, 'D', s.words.radius_offset);
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
  if (mode != motion::FeedMode::inverse_time && inch) value = base::tidy(value * 25.4);
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
  for (const Word* const* m = words.m_begin(); m != words.m_end(); ++m) {
    std::int64_t code = 0;
    if (!state_.values.integer(**m, 0, kMostCode, code)) return false;
    if (++count > kMostMCodes) {
      return state_.alarms.raise(Code::improper_address_word, (*m)->text,
                                 "a block takes three M codes");
    }
    state_.words.last_m = code;
    codes.stop |= code == 0;
    codes.optional_stop |= code == 1;
    codes.end |= code == 2 || code == 30;
    codes.rewind |= code == 30;
    codes.interrupt_on |= code == 96;
    codes.interrupt_off |= code == 97;
    if ((code == 98 && codes.call) ||
        (code == state_.parameters.external_call_m && codes.external_call)) {
      return state_.alarms.raise(Code::two_sub_calls, (*m)->text);
    }
    codes.call |= code == 98;
    codes.external_call |= code == state_.parameters.external_call_m;
    codes.return_ |= code == 99;
  }
  return true;
}

void Auxiliary::turn(motion::Spindle::Turning turning) {
  state_.words.turning = turning;
  state_.path.act(state_.spindle());
}

void Auxiliary::before_motion(const Words& words) {
  bool told = false;
  for (const Word* const* m = words.m_begin(); m != words.m_end(); ++m) {
    const std::int64_t code = code_of(**m);
    if (code == 3 || code == 4) {
      turn(code == 3 ? motion::Spindle::Turning::clockwise
                     : motion::Spindle::Turning::counterclockwise);
      told = true;
    } else if (code == 6) {
      state_.path.act(motion::ToolChange{static_cast<std::uint32_t>(state_.words.tool)});
    } else if (code == 7 || code == 8) {
      state_.path.act(motion::Coolant{code == 7 ? motion::Coolant::State::mist
                                                : motion::Coolant::State::flood});
    } else if (code == 19) {
      turn(motion::Spindle::Turning::oriented);
    } else if (code == 29) {
      state_.rigid_tapping = true;
      state_.moved_since_m29 = false;
      state_.path.act(motion::AuxiliaryCode{29});
    }
  }
  const bool turning = state_.words.turning == motion::Spindle::Turning::clockwise ||
                       state_.words.turning == motion::Spindle::Turning::counterclockwise;
  const bool changes_speed = !words.has_g(kPreset) || state_.modal[Group::speed] == 960;
  if (words.has('S') && turning && !told && changes_speed) state_.path.act(state_.spindle());
}

void Auxiliary::after_motion(const Words& words) {
  for (const Word* const* m = words.m_begin(); m != words.m_end(); ++m) {
    const std::int64_t code = code_of(**m);
    if (code == 5) {
      turn(motion::Spindle::Turning::stopped);
    } else if (code == 9) {
      state_.path.act(motion::Coolant{motion::Coolant::State::off});
    } else if (!before_the_move(code) && !flow_code(code) &&
               code != state_.parameters.external_call_m) {
      state_.path.act(motion::AuxiliaryCode{static_cast<std::uint32_t>(code)});
    }
  }
}

}  // namespace kerf::control
