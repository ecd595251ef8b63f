// How the control executes one NC block (docs/dialect.md §8, order in a block):
//   1. words are fetched and sorted (block_words.cpp)
//      program calls by G code are found (block_calls.cpp)
//   2. modal codes, F, S, T, D, H are taken over
//   3. S, T and the M codes that come before the motion act
//   4. the one-shot code or the motion of the block
//   5. the other M codes, stops, ends, calls and returns (block_calls.cpp)
#include <algorithm>
#include <utility>

#include "base/decimal.hpp"
#include "control/gcode/controller.hpp"
#include "control/gcode/words/idle_words.hpp"

namespace kerf::control {
namespace {

using base::Code;
using gcode::Word;
using vm::Verdict;

}  // namespace

void Controller::begin(const gcode::GcodePage& page, const gcode::Statement& statement) {
  state_.line = statement.line;
  state_.before = state_.modal;
  block_memory_.keep(state_);
  state_.path.begin_block(
      {motion::ProgramNumber{calls_.running_number()}, statement.line, page.file});
  in_block_ = true;
  block_number_ = statement.number;
  moved_ = false;
  transferred_ = false;
  codes_ = {};
}

Verdict Controller::execute_words(const gcode::GcodePage& page, const gcode::Statement& statement,
                                  const double* registers) {
  begin(page, statement);
  const std::span<const Word> block = fetch(page, statement, registers);
  call_name_.clear();
  if (statement.name >= 0) call_name_ = page.names[static_cast<std::size_t>(statement.name)];
  BlockCall call;
  if ((statement.may_call || codes_call_macros_ || calls_.modal_active()) &&
      !find_call(block, call))
    return Verdict::stop;
  if (call.kind != BlockCall::Kind::none) {
    if (!call_program(block, call, call_name_)) return Verdict::stop;
    buffer_.release();
    in_block_ = false;
    return transferred_ ? Verdict::transferred : Verdict::go_on;
  }
  if (!collect(block) || !(is_plain_move() ? plain_move() : execute_block(call_name_)))
    return Verdict::stop;
  return continue_block();
}

// Most blocks of most programs command a motion and nothing else: group 01 codes, axes, F.
bool Controller::is_plain_move() const {
  constexpr std::uint32_t kPlain = Words::mask('G') | Words::mask('F') | Words::mask('N') |
                                   Words::mask('I') | Words::mask('J') | Words::mask('K') |
                                   Words::mask('R');
  if (corner_ != nullptr || (words_.present() & ~(kPlain | targets_.letters())) != 0 ||
      state_.modal.in_cycle() || state_.parameter_entry)
    return false;
  return std::all_of(words_.g_begin(), words_.g_end(),
                     [](const Words::G& g) { return g.group() == Group::motion; });
}

bool Controller::plain_move() {
  for (const Words::G* g = words_.g_begin(); g != words_.g_end(); ++g) state_.modal.set(*g->row);
  if (!auxiliary_.read_feed(words_) || !tell_idle_words()) return false;
  state_.path.obey(move_rules(words_, state_.modal, state_.feed_control));
  buffer_.pass_through(
      !state_.path.compensating());  // a move is checked whole before it is emitted
  const bool good = moves_.execute(words_, moved_);
  buffer_.pass_through(false);
  return good;
}

// The block itself

bool Controller::execute_block(const std::string& name) {
  call_name_ = name;
  const Words::G* one_shot = nullptr;
  const bool was_in_cycle = state_.modal.in_cycle();
  const bool parameter_entry = state_.parameter_entry;
  if (!settings_.read_codes(words_, one_shot)) return false;
  if (parameter_entry) {
    if (one_shot != nullptr && one_shot->meaning() == Meaning::data_setting_end) {
      state_.parameter_entry = false;
      return true;
    }
    const bool entered = data_setting_.enter_parameter(words_, block_number_);
    learn_parameters();
    return entered;
  }
  if (!check_block(one_shot) || !auxiliary_.read(words_) || !auxiliary_.read_codes(words_, codes_))
    return false;
  if (codes_.return_ && calls_.modal_active() &&
      (words_.m_end() - words_.m_begin() > 1 ||
       (words_.present() &
        ~(Words::mask('M') | Words::mask('P') | Words::mask('N') | Words::mask('L'))) != 0)) {
    return alarms_.raise(Code::words_with_return, "M99 must stand alone here");
  }
  if (!settings_.apply_codes(words_)) return false;
  for (const Words::G* g = words_.g_begin(); g != words_.g_end(); ++g) {
    if (g->meaning() != Meaning::modal_call_off) continue;
    if (!calls_.pop_modal()) return false;
    state_.modal.set(calls_.modal_active() ? Meaning::modal_call : Meaning::modal_call_off);
  }
  if (!tell_idle_words()) return false;
  auxiliary_.before_motion(words_);
  if (was_in_cycle && !state_.modal.in_cycle()) cycle_.cancel();
  state_.path.obey(move_rules(words_, state_.modal, state_.feed_control));
  return move(one_shot, moved_);
}

// Words that may not stand beside a one-shot code.
bool Controller::check_block(const Words::G* one_shot) {
  for (const Words::M* m = words_.m_begin(); m != words_.m_end(); ++m) {
    if (m->function() == Function::rigid_tapping && state_.before.in_cycle()) {
      return alarms_.raise(Code::tap_order, m->word->text,
                           "M29 stands before the tapping cycle, not in it");
    }
  }
  if (one_shot == nullptr || !words_.has('T')) return true;
  if (one_shot->meaning() == Meaning::dwell || one_shot->meaning() == Meaning::data_setting)
    return alarms_.raise(Code::tool_not_allowed, words_['T'].text);
  return true;
}

bool Controller::move(const Words::G* one_shot_code, bool& moved) {
  if (one_shot_code != nullptr && one_shot_code->row->axis_words == AxisWords::own)
    return one_shot(*one_shot_code, moved);
  if (one_shot_code != nullptr && one_shot_code->meaning() == Meaning::look_ahead) {
    std::int64_t p = 0;
    if (words_.has('P') && !state_.values.integer(words_['P'], 0, 99999999, p)) return false;
    if (p > 1) return alarms_.raise(Code::look_ahead_format, words_['P'].text);
  }
  if (settings_.takes_axis_words(words_)) return true;
  bool plain = true;
  if (!select_cycle(plain)) return false;
  if (!plain) return true;
  if (corner_ != nullptr && !request_corner()) return false;
  const bool single_direction =
      one_shot_code != nullptr && one_shot_code->meaning() == Meaning::single_direction;
  const CodeRow& mode = *state_.modal.row(Group::motion);
  if (single_direction) state_.modal.set(Meaning::rapid);
  const bool good = moves_.execute(words_, moved);
  state_.modal.set(mode);
  return good;
}

// A chamfer or corner radius at the end of a G01, G02 or G03 move.
bool Controller::request_corner() {
  if (state_.modal[Group::motion] != Meaning::line && !state_.modal.circular()) {
    return alarms_.raise(Code::corner_second, corner_->text, "it needs a G01, G02 or G03 move");
  }
  const auto plane = motion::plane_axes(state_.modal.plane(), axes_);
  if (!plane) return alarms_.raise(Code::illegal_plane_axis);
  if (!words_.has_any(targets_.letters()))
    return alarms_.raise(Code::corner_missing_move, corner_->text, "this block does not move");
  double size = 0;
  if (!state_.values.length(*corner_, size)) return false;
  if (size < 0) return alarms_.raise(Code::illegal_minus, corner_->text);
  const auto kind =
      corner_->letter == 'C' ? CornerRounding::Kind::chamfer : CornerRounding::Kind::radius;
  state_.path.round_corner({{kind, size}, state_.modal.plane(), *plane});
  return true;
}

// CYC-15: of a cycle code and a group 01 code in one block the last one counts. `plain` is false
// when the block belongs to the cycle.
bool Controller::select_cycle(bool& plain) {
  const Words::G* cycle = nullptr;
  const Words::G* motion = nullptr;
  for (const Words::G* g = words_.g_begin(); g != words_.g_end(); ++g) {
    if (g->group() == Group::cycle) cycle = g;
    if (g->group() == Group::motion) motion = g;
  }
  if (motion != nullptr && motion > cycle) {
    const bool both = cycle != nullptr && cycle->meaning() != Meaning::cycle_off;
    state_.modal.set(Meaning::cycle_off);
    cycle_.cancel();
    if (both) words_.forget('Z');
    return true;
  }
  if (!state_.modal.in_cycle()) return true;
  plain = false;
  const bool starts = !state_.before.in_cycle();
  return cycle_.begin(words_, starts, moved_);
}

bool Controller::one_shot(const Words::G& g, bool& moved) {
  switch (g.meaning()) {
    case Meaning::dwell: return dwell();
    case Meaning::data_setting: return data_setting_.execute(words_);
    case Meaning::data_setting_end: return true;
    case Meaning::local_system: return settings_.local_system(words_);
    case Meaning::preset: return settings_.preset(words_);
    case Meaning::clear_shifts: return settings_.clear_shifts(words_);
    default: return references_.execute(g, words_, moved);
  }
}

// NUM-7, NUM-8: X and U count seconds, P milliseconds.
bool Controller::dwell() {
  double seconds = 0;
  const Word* const time = words_.has('X') ? &words_['X'] : words_.find('U');
  if (time != nullptr) {
    if (time->value < 0) return alarms_.raise(Code::illegal_minus, time->text);
    if (!state_.values.angle(*time, seconds)) return false;
  } else if (words_.has('P')) {
    std::int64_t milliseconds = 0;
    if (!state_.values.integer(words_['P'], 0, 99999999, milliseconds)) return false;
    seconds = static_cast<double>(milliseconds) / 1000;
  }
  if (seconds > 0) state_.path.act(motion::Dwell{seconds});
  return true;
}

// The holes of a cycle are made one after the other, as long as the receiver takes them.
Verdict Controller::continue_block() {
  mid_block_ = false;
  buffer_.release();
  while (cycle_.running()) {
    if (!buffer_.ready()) {
      mid_block_ = true;
      return Verdict::pause;
    }
    if (!cycle_.step()) return Verdict::stop;
    buffer_.release();
  }
  return finish_block();
}

Verdict Controller::stopped(Halt halt) {
  halt_ = halt;
  return halt == Halt::end || halt == Halt::alarm ? Verdict::stop : Verdict::pause;
}

Verdict Controller::finish_block() {
  if (!at_optional_stop_) {
    auxiliary_.after_motion(words_);
    if (!state_.path.end_block()) return Verdict::stop;
  }
  at_optional_stop_ = codes_.optional_stop;
  if (!at_optional_stop_ || come_to_optional_stop()) return end_block();
  if (alarms_.alarm()) return Verdict::stop;
  mid_block_ = true;
  return Verdict::pause;
}

// M01 suppresses buffering, whether its switch is on or off: the switch counts that stands when the
// axes have come here. False: they have not, or there is an alarm.
bool Controller::come_to_optional_stop() {
  if (!state_.path.holds_corner() && !state_.path.release()) return false;
  buffer_.release();
  return surroundings_.axes_have_arrived();
}

Verdict Controller::end_block() {
  const bool passed = std::exchange(at_optional_stop_, false) && !optional_stop_;
  Halt halt = Halt::none;
  if (codes_.stop) halt = Halt::program_stop;
  if (codes_.optional_stop && optional_stop_) halt = Halt::optional_stop;
  if (codes_.end) halt = Halt::end;
  if (halt == Halt::end || halt == Halt::program_stop || halt == Halt::optional_stop) {
    if (!state_.path.release()) return Verdict::stop;
  }
  if (halt == Halt::program_stop || halt == Halt::optional_stop)
    state_.path.act(motion::Stop{halt == Halt::optional_stop});
  if (halt == Halt::none && passed) state_.path.act(motion::Stop{true, true});
  if (halt == Halt::end) state_.path.act(motion::End{});
  buffer_.release();
  in_block_ = false;
  if (halt == Halt::end) {
    if (codes_.rewind) {
      state_.memory.parts += 1;
      ++state_.memory.revision;
    }
    return stopped(halt);
  }
  if (!set_interrupt() || !finish_calls()) return Verdict::stop;
  if (halt != Halt::none) return stopped(halt);
  if (single_block_) return stopped(Halt::single_block);
  if (!buffer_.ready()) return Verdict::pause;
  return transferred_ ? Verdict::transferred : Verdict::go_on;
}

}  // namespace kerf::control
