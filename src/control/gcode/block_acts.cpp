#include "control/gcode/block_acts.hpp"

#include <algorithm>
#include <utility>

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"
#include "control/gcode/words/idle_words.hpp"

namespace kerf::control {
namespace {

using base::Code;
using gcode::Word;
using gcode::WordFlag;

}  // namespace

BlockActs::BlockActs(State& state, ProgramCalls& calls, BlockBuffer& buffer,
                     std::function<void()> parameters_entered)
    : state_(state),
      calls_(calls),
      buffer_(buffer),
      parameters_entered_(std::move(parameters_entered)),
      targets_(state),
      moves_(state, targets_),
      drawing_(state, targets_, moves_),
      settings_(state, targets_, moves_),
      surfaces_(state),
      data_setting_(state, targets_),
      references_(state, targets_, moves_),
      measurement_(state, targets_, moves_),
      auxiliary_(state),
      cycle_(state, targets_, moves_),
      holes_(state, targets_, moves_),
      turning_(state, moves_),
      single_(state, targets_, moves_, turning_),
      multiple_(state, targets_, moves_, turning_),
      shapes_(state, moves_, turning_) {
  targets_.learn_letters();
}

bool BlockActs::execute(ReadBlock& block) {
  state_.one_shot = Meaning::none;
  if (!is_plain_move(block)) return execute_in_full(block);
  const Words& words = block.words;
  for (const Words::G* g = words.g_begin(); g != words.g_end(); ++g) state_.modal.set(*g->row);
  if (!auxiliary_.read_feed(words) || !tell_idle_words(block)) return false;
  state_.path.obey(move_rules(words, state_.modal, state_.feed_control));
  buffer_.pass_through(
      !state_.path.compensating());  // a move is checked whole before it is emitted
  const bool good = moves_.execute(words, moved_);
  buffer_.pass_through(false);
  return good;
}

// Most blocks of most programs command a motion and nothing else: group 01 codes, axes, F.
bool BlockActs::is_plain_move(const ReadBlock& block) const {
  constexpr std::uint32_t kPlain = Words::mask("GFNIJKR");
  const Words& words = block.words;
  if (block.dimensions.any() || (words.present() & ~(kPlain | targets_.letters())) != 0 ||
      state_.modal.in_cycle() || state_.parameter_entry || nose_may_have_changed() ||
      state_.path.surface() != nullptr || SingleCycles::is_one(state_.modal[Group::motion]))
    return false;
  return std::all_of(words.g_begin(), words.g_end(), [](const Words::G& g) {
    return g.group() == Group::motion && !SingleCycles::is_one(g.meaning());
  });
}

// Of a lathe the compensation follows the offset in force, whoever writes it.
bool BlockActs::nose_may_have_changed() const {
  return state_.codes.habits().tool_brings_offset && state_.modal.compensating();
}

bool BlockActs::execute_in_full(ReadBlock& block) {
  const Words& words = block.words;
  const Words::G* one_shot = nullptr;
  const bool was_in_cycle = state_.modal.in_cycle();
  const bool parameter_entry = state_.parameter_entry;
  if (!surfaces_.check(words) || !settings_.read_codes(words, one_shot)) return false;
  if (one_shot != nullptr) state_.one_shot = one_shot->meaning();
  if (one_shot != nullptr && one_shot->meaning() != Meaning::dwell) single_.forget();
  if (parameter_entry) return enter_parameter(block, one_shot);
  if (!check_block(words, one_shot) || !auxiliary_.read(words) ||
      !auxiliary_.read_codes(words, codes_) || !check_return(words))
    return false;
  if (!settings_.apply_codes(words) || !surfaces_.apply(words) || !end_modal_calls(words) ||
      !tell_idle_words(block))
    return false;
  auxiliary_.before_motion(words);
  if (was_in_cycle && !state_.modal.in_cycle()) cancel_holes();
  state_.path.obey(move_rules(words, state_.modal, state_.feed_control));
  if (!move(block, one_shot)) return false;
  auxiliary_.follow_work_zero();
  return true;
}

// Between G10 L50 and G11.
bool BlockActs::enter_parameter(const ReadBlock& block, const Words::G* one_shot) {
  if (one_shot != nullptr && one_shot->meaning() == Meaning::data_setting_end) {
    state_.parameter_entry = false;
    return true;
  }
  const bool good = data_setting_.enter_parameter(block.words, block.number);
  parameters_entered_();
  return good;
}

bool BlockActs::check_return(const Words& words) {
  if (!codes_.return_ || !calls_.modal_active()) return true;
  const bool alone =
      words.m_end() - words.m_begin() <= 1 && (words.present() & ~Words::mask("MPNL")) == 0;
  return alone || state_.alarms.raise(Code::words_with_return, "M99 must stand alone here");
}

// Words that may not stand beside a one-shot code.
bool BlockActs::check_block(const Words& words, const Words::G* one_shot) {
  for (const Words::M* m = words.m_begin(); m != words.m_end(); ++m) {
    if (m->function() == Function::rigid_tapping && state_.before.in_cycle()) {
      return state_.alarms.raise(Code::tap_order, m->word->text,
                                 "M29 stands before the tapping cycle, not in it");
    }
  }
  if (one_shot == nullptr || !words.has('T')) return true;
  const bool sets =
      one_shot->meaning() == Meaning::preset && state_.codes.habits().tool_brings_offset;
  if (sets || one_shot->meaning() == Meaning::dwell || one_shot->meaning() == Meaning::data_setting)
    return state_.alarms.raise(Code::tool_not_allowed, words['T'].text);
  return true;
}

bool BlockActs::end_modal_calls(const Words& words) {
  for (const Words::G* g = words.g_begin(); g != words.g_end(); ++g) {
    if (g->meaning() != Meaning::modal_call_off) continue;
    if (!calls_.pop_modal()) return false;
    state_.modal.set(calls_.modal_active() ? Meaning::modal_call : Meaning::modal_call_off);
  }
  return true;
}

// Accepted, but not acted upon. What its address never takes is an alarm all the same.
bool BlockActs::tell_idle_words(const ReadBlock& block) {
  const bool calls = codes_.call || codes_.external_call || codes_.return_ || codes_.interrupt_on ||
                     block.called_m != nullptr;
  std::uint32_t idle = idle_words(block.words, state_.modal, calls);
  if (auxiliary_.spindles().has_number(block.words)) idle &= ~Words::mask('P');
  if (idle == 0) return true;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if ((idle & Words::mask(letter)) == 0) continue;
    const Word& word = block.words[letter];
    const bool whole = letter == 'L' || letter == 'P';
    if (whole && word.value < 0) return state_.alarms.raise(Code::illegal_minus, word.text);
    if (whole && word.has(WordFlag::point))
      return state_.alarms.raise(Code::illegal_decimal_point, word.text);
    if (!state_.assumptions.is_new(Assumed::idle_word + 1U + static_cast<unsigned>(letter - 'A')))
      continue;
    state_.assumptions.add(state_.line, std::string(1, letter) + base::number_text(word.value) +
                                            " is ignored: no code of its block takes " + letter);
  }
  return true;
}

bool BlockActs::check_look_ahead(const Words& words) {
  std::int64_t p = 0;
  if (words.has('P') && !state_.values.integer(words['P'], 0, 99999999, p)) return false;
  return p <= 1 || state_.alarms.raise(Code::look_ahead_format, words['P'].text);
}

bool BlockActs::move(ReadBlock& block, const Words::G* one_shot_code) {
  if (block.dimensions.any() && !drawing_.admits(block.words, block.dimensions)) return false;
  if (one_shot_code != nullptr && one_shot_code->row->axis_words == AxisWords::own)
    return one_shot(block.words, *one_shot_code);
  if (state_.one_shot == Meaning::look_ahead && !check_look_ahead(block.words)) return false;
  if (settings_.takes_axis_words(block.words)) return true;
  bool plain = true;
  if (!select_cycle(block.words, plain)) return false;
  if (!plain) return true;
  if (block.dimensions.any()) return drawing_.move(block.words, block.dimensions, moved_);
  if (SingleCycles::is_one(state_.modal[Group::motion])) return single_.begin(block.words, moved_);
  return moves_.execute(block.words, moved_);
}

// CYC-15: of a cycle code and a group 01 code in one block the last one counts. `plain` is false
// when the block belongs to the cycle.
bool BlockActs::select_cycle(Words& words, bool& plain) {
  const Words::G* cycle = nullptr;
  const Words::G* motion = nullptr;
  for (const Words::G* g = words.g_begin(); g != words.g_end(); ++g) {
    if (g->group() == Group::cycle) cycle = g;
    if (g->group() == Group::motion) motion = g;
  }
  if (motion != nullptr && motion > cycle) {
    const bool both = cycle != nullptr && cycle->meaning() != Meaning::cycle_off;
    state_.modal.set(Meaning::cycle_off);
    cancel_holes();
    if (both) words.forget('Z');
    return true;
  }
  if (!state_.modal.in_cycle()) return true;
  plain = false;
  const bool starts = !state_.before.in_cycle();
  return TurningHoles::is_one(state_.modal[Group::cycle]) ? holes_.begin(words, starts, moved_)
                                                          : cycle_.begin(words, starts, moved_);
}

bool BlockActs::one_shot(const Words& words, const Words::G& g) {
  switch (g.meaning()) {
    case Meaning::dwell: return dwell(words);
    case Meaning::data_setting: return data_setting_.execute(words);
    case Meaning::data_setting_end: return true;
    case Meaning::local_system: return settings_.local_system(words);
    case Meaning::preset: return settings_.preset(words);
    case Meaning::diameter_switch: return settings_.switch_diameter(words);
    case Meaning::measure_x: return measurement_.execute('X', words, moved_);
    case Meaning::measure_z: return measurement_.execute('Z', words, moved_);
    case Meaning::clear_shifts: return settings_.clear_shifts(words);
    case Meaning::cylindrical_interpolation: return surfaces_.cylinder(words);
    case Meaning::face_pecks:
    case Meaning::groove_pecks:
    case Meaning::compound_thread: return multiple_.execute(g.meaning(), words, moved_);
    case Meaning::finishing:
    case Meaning::rough_turning:
    case Meaning::rough_facing:
    case Meaning::pattern_repeat: return shapes_.execute(g.meaning(), words, moved_);
    default: return references_.execute(g, words, moved_);
  }
}

// NUM-7, NUM-8: X and U count seconds, P milliseconds.
bool BlockActs::dwell(const Words& words) {
  double seconds = 0;
  const Word* const time = words.has('X') ? &words['X'] : words.find('U');
  if (time != nullptr) {
    if (time->value < 0) return state_.alarms.raise(Code::illegal_minus, time->text);
    if (!state_.values.angle(*time, seconds)) return false;
  } else if (words.has('P')) {
    std::int64_t milliseconds = 0;
    if (!state_.values.integer(words['P'], 0, 99999999, milliseconds)) return false;
    seconds = static_cast<double>(milliseconds) / 1000;
  }
  if (seconds > 0) state_.path.act(motion::Dwell{seconds});
  return true;
}

}  // namespace kerf::control
