// How the control executes one NC block (fanuc-dialect.md §8, order in a block):
//   1. words are fetched and sorted, program calls by G code found
//   2. modal codes, F, S, T, D, H are taken over
//   3. S, T and the M codes that come before the motion act
//   4. the one-shot code or the motion of the block
//   5. the other M codes, stops, ends, calls and returns
#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "control/assumed.hpp"
#include "control/controller.hpp"
#include "control/idle_words.hpp"
#include "lang/vm/value.hpp"

namespace kerf::control {
namespace {

using base::Code;
using gcode::Word;
using gcode::WordFlag;
using vm::Verdict;

constexpr std::uint32_t kAlwaysAllowed =
    Words::mask('D') | Words::mask('E') | Words::mask('F') | Words::mask('G') | Words::mask('H') |
    Words::mask('I') | Words::mask('J') | Words::mask('K') | Words::mask('L') | Words::mask('M') |
    Words::mask('N') | Words::mask('P') | Words::mask('Q') | Words::mask('R') | Words::mask('S') |
    Words::mask('T');

constexpr std::uint32_t kFirstGMacro = 9010;
constexpr std::uint32_t kFirstMMacro = 9020;
constexpr std::uint32_t kFirstMSub = 9001;
constexpr std::uint32_t kToolProgram = 9000;
constexpr std::uint32_t kSpeedProgram = 9029;
constexpr std::uint32_t kSecondAuxiliaryProgram = 9028;

// The common variables in which code calls pass their value: #149 T, #147 S, #146 B.
constexpr std::size_t kToolCommon = 149 - 100;
constexpr std::size_t kSpeedCommon = 147 - 100;
constexpr std::size_t kSecondAuxiliaryCommon = 146 - 100;

// The block's axis words belong to this one-shot code, not to a motion.
bool takes_over(GCode code) {
  switch (code) {
    case 40:
    case 100:
    case 110:
    case 520:
    case 920:
    case 921:
    case 270:
    case 280:
    case 290:
    case 300:
    case 310:
    case 450:
    case 460:
    case 470:
    case 480:
    case 530: return true;
    default: return false;
  }
}

std::int64_t code_number(const Word& word) { return base::round_away(word.value); }

}  // namespace

Verdict Controller::verdict_of(bool good) { return good ? Verdict::go_on : Verdict::stop; }

void Controller::begin(const gcode::GcodePage& page, const gcode::Statement& statement) {
  state_.line = statement.line;
  state_.before = state_.modal;
  state_.path.begin_block({ProgramNumber{calls_.running_number()}, statement.line, page.file});
  in_block_ = true;
  block_number_ = statement.number;
  moved_ = false;
  transferred_ = false;
  codes_ = {};
}

// The block's words with their values; words whose value is null are dropped (VAR-7).
std::span<const Word> Controller::fetch(const gcode::GcodePage& page,
                                        const gcode::Statement& statement,
                                        const double* registers) {
  const std::span<const Word> compiled =
      std::span(page.words).subspan(statement.first, statement.count);
  if (!statement.from_registers) return compiled;
  fetched_.clear();
  for (Word word : compiled) {
    if (word.has(WordFlag::from_register)) {
      const double value = registers[static_cast<std::size_t>(word.value)];
      if (vm::is_null(value)) continue;
      word.value = word.has(WordFlag::minus) ? -value : value;
    }
    fetched_.push_back(word);
  }
  return fetched_;
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

// Sorting words

bool Controller::collect_g(const Word& word) {
  if (word.value < 0) return alarms_.raise(Code::illegal_minus, word);
  const double tenths = word.value * 10;
  const auto rounded = base::round_away(tenths);
  const bool exact = std::fabs(tenths - static_cast<double>(rounded)) < 1e-6;
  if (rounded > 65535 || (word.has(WordFlag::literal) && !exact)) {
    return alarms_.raise(Code::improper_g_code, word,
                         "G" + base::number_text(word.value) + " does not exist");
  }
  return words_.put_g(static_cast<GCode>(rounded), word) ||
         alarms_.raise(Code::improper_g_code, word, "more than 16 G codes in one block");
}

// An M code that calls a subprogram has no other meaning and no strobe (CODE-2).
bool Controller::calls_subprogram(const Word& word) const {
  if (!codes_call_subprograms_ || calls_.codes_are_ordinary() || word.has(WordFlag::point))
    return false;
  const auto code = code_number(word);
  return code != 0 && std::find(parameters_.m_sub.begin(), parameters_.m_sub.end(), code) !=
                          parameters_.m_sub.end();
}

// ",C" and ",R".
bool Controller::collect_corner(const Word& word) {
  if (word.letter != 'C' && word.letter != 'R') {
    return alarms_.raise(Code::improper_address, word, "a comma stands only before C and R");
  }
  if (corner_ != nullptr) return alarms_.raise(Code::corner_too_many, word);
  corner_ = &word;
  return true;
}

bool Controller::collect(std::span<const Word> block) {
  words_.clear();
  called_m_ = nullptr;
  corner_ = nullptr;
  for (const Word& word : block) {
    if (word.has(WordFlag::comma)) {
      if (!collect_corner(word)) return false;
      continue;
    }
    if (word.letter == 'G') {
      if (!collect_g(word)) return false;
    } else if (word.letter == 'M' && calls_subprogram(word)) {
      if (called_m_ != nullptr) return alarms_.raise(Code::two_sub_calls, word);
      called_m_ = &word;
    } else if (word.letter == 'M') {
      if (!words_.put_m(word))
        return alarms_.raise(Code::improper_address_word, word, "a block takes three M codes");
    } else {
      words_.put(word);
    }
  }
  return check_addresses(block);
}

// LEX-32: every letter must be an address of this machine.
bool Controller::check_addresses(std::span<const Word> block) {
  std::uint32_t allowed = kAlwaysAllowed | targets_.letters();
  if (parameters_.b_calls_program) allowed |= Words::mask('B');
  if ((words_.present() & ~allowed) == 0) return true;
  // G04 takes its time under X or U.
  const bool is_dwell =
      std::any_of(words_.g_begin(), words_.g_end(), [](const Words::G& g) { return g.code == 40; });
  if (is_dwell) allowed |= Words::mask('X') | Words::mask('U');
  if ((words_.present() & ~allowed) == 0) return true;
  const auto bad = std::find_if(block.begin(), block.end(), [&](const Word& word) {
    return (Words::mask(word.letter) & ~allowed) != 0;
  });
  if (bad->letter == 'O') {
    return alarms_.raise(Code::expression_format, *bad, "a program number is written in digits");
  }
  return alarms_.raise(Code::improper_address, *bad,
                       std::string("this machine has no axis ") + bad->letter);
}

// Program calls by code: G65, G66, the G and M codes of parameters 6050 and 6080.

bool Controller::find_call(std::span<const Word> block, BlockCall& call) {
  using Kind = BlockCall::Kind;
  const bool every_block = calls_.every_block();
  const bool ordinary = calls_.codes_are_ordinary();
  for (std::size_t i = 0; i < block.size(); ++i) {
    const Word& word = block[i];
    if (codes_call_macros_ && word.letter == 'M' && i == 0 && !ordinary) {
      const auto m =
          std::find(parameters_.m_macro.begin(), parameters_.m_macro.end(), code_number(word));
      if (m != parameters_.m_macro.end() && *m != 0) {
        call = {Kind::code_macro, 1,
                kFirstMMacro + static_cast<std::uint32_t>(m - parameters_.m_macro.begin()), &word};
        return true;
      }
    }
    if (word.letter != 'G') continue;
    const auto code = static_cast<int>(base::round_away(word.value * 10));
    if (code == 670) return true;
    if (code == 650 || code == 660 || code == 661) {
      if (call.kind != Kind::none) {
        const bool macro_word = call.kind != Kind::code_macro;
        return alarms_.raise(macro_word ? Code::two_macro_calls : Code::argument_g, word);
      }
      call = {code == 650   ? Kind::macro
              : code == 660 ? Kind::modal
                            : Kind::every_block,
              i + 1, 0, &word};
    } else if (codes_call_macros_ && call.kind == Kind::none && !ordinary && code != 0) {
      const auto g = std::find(parameters_.g_macro.begin(), parameters_.g_macro.end(), code);
      if (g == parameters_.g_macro.end()) continue;
      call = {Kind::code_macro, i + 1,
              kFirstGMacro + static_cast<std::uint32_t>(g - parameters_.g_macro.begin()), &word};
    }
  }
  if (call.kind == Kind::none && every_block && !block.empty())
    call = {Kind::every_block, 0, 0, nullptr};
  return true;
}

// CALL-4: what stands before the call must be G codes, which act as usual; what stands behind it
// are arguments.
bool Controller::call_program(std::span<const Word> block, const BlockCall& call,
                              const std::string& name) {
  using Kind = BlockCall::Kind;
  const std::size_t before = call.first_argument == 0 ? 0 : call.first_argument - 1;
  for (const Word& word : block.subspan(0, before)) {
    if (word.letter == 'G' || word.letter == 'N') continue;
    return alarms_.raise(Code::argument_g, *call.word, "arguments stand behind the macro call");
  }
  if (before > 0) {
    if (std::any_of(block.begin(), block.begin() + static_cast<std::ptrdiff_t>(before),
                    [](const Word& w) { return w.letter == 'G'; })) {
      state_.assume(Assumed::words_before_call,
                    "G codes before a macro call in its block act as usual");
    }
    if (!collect(block.subspan(0, before)) || !execute_block({}) || !state_.path.end_block())
      return false;
  }
  const ArgumentRules rules{state_.modal.inch(), parameters_.calculator_point,
                            parameters_.single_ijk,
                            call.kind == Kind::every_block && call.word == nullptr};
  CallWords arguments;
  if (!read_arguments(block.subspan(call.first_argument), rules, alarms_, arguments)) return false;
  const std::size_t depth = interpreter_.depth();
  bool good = true;
  switch (call.kind) {
    case Kind::macro:
      good = calls_.call_macro(arguments, name, ProgramCalls::Kind::macro, std::nullopt);
      break;
    case Kind::code_macro:
      good = calls_.call_macro(arguments, {}, ProgramCalls::Kind::code_macro, call.program);
      break;
    case Kind::modal:
      good = calls_.push_modal(arguments, name, false);
      state_.modal.set(Group::modal_call, 660);
      break;
    case Kind::every_block:
      if (call.word != nullptr) {
        good = calls_.push_modal(arguments, name, true);
        state_.modal.set(Group::modal_call, 661);
      }
      good = good && calls_.call_every_block(arguments);
      break;
    case Kind::none: break;
  }
  transferred_ = interpreter_.depth() != depth;
  return good;
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
                     [](const Words::G& g) { return group_of(g.code) == Group::motion; });
}

bool Controller::plain_move() {
  for (const Words::G* g = words_.g_begin(); g != words_.g_end(); ++g)
    state_.modal.set(Group::motion, g->code);
  if (!auxiliary_.read_feed(words_)) return false;
  tell_idle_words();
  buffer_.pass_through(
      !state_.path.compensating());  // a move is checked whole before it is emitted
  const bool good = moves_.execute(words_, moved_);
  buffer_.pass_through(false);
  return good;
}

// Accepted, but not acted upon.
void Controller::tell_idle_words() {
  const bool calls = codes_.call || codes_.external_call || codes_.return_ || codes_.interrupt_on ||
                     called_m_ != nullptr;
  std::uint32_t idle = idle_words(words_, state_.modal, calls);
  for (char letter = 'A'; idle != 0; ++letter) {
    if ((idle & Words::mask(letter)) == 0) continue;
    idle &= ~Words::mask(letter);
    if (!state_.assumptions.is_new(Assumed::idle_word + 1U + static_cast<unsigned>(letter - 'A')))
      continue;
    state_.assumptions.add(state_.line, std::string(1, letter) +
                                            base::number_text(words_[letter].value) +
                                            " is ignored: no code of its block takes " + letter);
  }
}

// The block itself

bool Controller::execute_block(const std::string& name) {
  call_name_ = name;
  const Words::G* one_shot = nullptr;
  const GCode cycle_before = state_.modal[Group::cycle];
  const bool parameter_entry = state_.parameter_entry;
  if (!settings_.read_codes(words_, one_shot)) return false;
  if (parameter_entry) {
    if (one_shot != nullptr && one_shot->code == 110) {
      state_.parameter_entry = false;
      return true;
    }
    const bool entered = settings_.enter_parameter(words_, block_number_);
    learn_calling_codes();
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
    if (g->code != 670) continue;
    if (!calls_.pop_modal()) return false;
    state_.modal.set(Group::modal_call, calls_.modal_active() ? 660 : 670);
  }
  tell_idle_words();
  auxiliary_.before_motion(words_);
  if (cycle_before != 800 && state_.modal[Group::cycle] == 800) cycle_.cancel();
  return move(one_shot, moved_);
}

// Words that may not stand beside a one-shot code.
bool Controller::check_block(const Words::G* one_shot) {
  for (const Word* const* m = words_.m_begin(); m != words_.m_end(); ++m) {
    if (code_number(**m) == 29 && state_.before.in_cycle()) {
      return alarms_.raise(Code::tap_order, **m, "M29 stands before the tapping cycle, not in it");
    }
  }
  if (one_shot == nullptr || !words_.has('T')) return true;
  if (one_shot->code == 40 || one_shot->code == 100)
    return alarms_.raise(Code::tool_not_allowed, words_['T']);
  return true;
}

bool Controller::move(const Words::G* one_shot_code, bool& moved) {
  if (one_shot_code != nullptr && takes_over(one_shot_code->code))
    return one_shot(*one_shot_code, moved);
  if (one_shot_code != nullptr && one_shot_code->code == 80) {
    std::int64_t p = 0;
    if (words_.has('P') && !state_.values.integer(words_['P'], 0, 99999999, p)) return false;
    if (p > 1) return alarms_.raise(Code::look_ahead_format, words_['P']);
  }
  if (settings_.takes_axis_words(words_)) return true;
  bool plain = true;
  if (!select_cycle(plain)) return false;
  if (!plain) return true;
  if (corner_ != nullptr && !request_corner()) return false;
  const bool single_direction = one_shot_code != nullptr && one_shot_code->code == 600;
  const GCode mode = state_.modal[Group::motion];
  if (single_direction) state_.modal.set(Group::motion, 0);
  const bool good = moves_.execute(words_, moved);
  state_.modal.set(Group::motion, mode);
  return good;
}

// A chamfer or corner radius at the end of a G01, G02 or G03 move.
bool Controller::request_corner() {
  const GCode mode = state_.modal[Group::motion];
  if (mode != 10 && mode != 20 && mode != 30) {
    return alarms_.raise(Code::corner_second, *corner_, "it needs a G01, G02 or G03 move");
  }
  const auto plane = plane_axes(state_.modal.plane(), axes_);
  if (!plane) return alarms_.raise(Code::illegal_plane_axis);
  if (!words_.has_any(targets_.letters()))
    return alarms_.raise(Code::corner_missing_move, *corner_, "this block does not move");
  double size = 0;
  if (!state_.values.length(*corner_, size)) return false;
  if (size < 0) return alarms_.raise(Code::illegal_minus, *corner_);
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
    const Group group = group_of(g->code);
    if (group == Group::cycle) cycle = g;
    if (group == Group::motion) motion = g;
  }
  if (motion != nullptr && motion > cycle) {
    const bool both = cycle != nullptr && cycle->code != 800;
    state_.modal.set(Group::cycle, 800);
    cycle_.cancel();
    if (both) words_.forget('Z');
    return true;
  }
  if (!state_.modal.in_cycle()) return true;
  plain = false;
  const bool starts = state_.before[Group::cycle] == 800;
  return cycle_.begin(words_, starts, moved_);
}

bool Controller::one_shot(const Words::G& g, bool& moved) {
  switch (g.code) {
    case 40: return dwell();
    case 100: return settings_.set_data(words_);
    case 110: return true;
    case 520: return settings_.local_system(words_);
    case 920: return settings_.preset(words_);
    case 921: return settings_.clear_shifts(words_);
    default: return references_.execute(g, words_, moved);
  }
}

// NUM-7, NUM-8: X and U count seconds, P milliseconds.
bool Controller::dwell() {
  double seconds = 0;
  const Word* const time = words_.has('X') ? &words_['X'] : words_.find('U');
  if (time != nullptr) {
    if (time->value < 0) return alarms_.raise(Code::illegal_minus, *time);
    if (!state_.values.angle(*time, seconds)) return false;
  } else if (words_.has('P')) {
    std::int64_t milliseconds = 0;
    if (!state_.values.integer(words_['P'], 0, 99999999, milliseconds)) return false;
    seconds = static_cast<double>(milliseconds) / 1000;
  }
  if (seconds > 0) state_.path.act(Dwell{seconds});
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
  auxiliary_.after_motion(words_);
  if (!state_.path.end_block()) return Verdict::stop;
  Halt halt = Halt::none;
  if (codes_.stop) halt = Halt::program_stop;
  if (codes_.optional_stop && optional_stop_) halt = Halt::optional_stop;
  if (codes_.end) halt = Halt::end;
  if (halt == Halt::end || halt == Halt::program_stop || halt == Halt::optional_stop) {
    if (!state_.path.release()) return Verdict::stop;
  }
  if (halt == Halt::program_stop || halt == Halt::optional_stop)
    state_.path.act(Stop{halt == Halt::optional_stop});
  if (halt == Halt::end) state_.path.act(End{});
  buffer_.release();
  in_block_ = false;
  if (halt == Halt::end) {
    if (codes_.rewind) state_.memory.parts += 1;
    return stopped(halt);
  }
  if (!set_interrupt() || !finish_calls()) return Verdict::stop;
  if (halt != Halt::none) return stopped(halt);
  if (single_block_) return stopped(Halt::single_block);
  if (!buffer_.ready()) return Verdict::pause;
  return transferred_ ? Verdict::transferred : Verdict::go_on;
}

bool Controller::set_interrupt() {
  if (codes_.interrupt_off) interrupt_program_ = 0;
  if (!codes_.interrupt_on) return true;
  std::int64_t p = 0;
  if (!words_.has('P')) return alarms_.raise(Code::interrupt_statement, "M96 needs P");
  if (!state_.values.integer(words_['P'], 0, 99999999, p)) return false;
  interrupt_program_ = static_cast<std::uint32_t>(p);
  state_.assume(Assumed::interrupt,
                "M96: the interrupt program runs only when a signal is injected");
  return true;
}

// Calls and returns behind the block's own actions. Frames are stacked, so what must run first is
// entered last: the modal macro of the motion before the subprogram of the block.
bool Controller::finish_calls() {
  const std::size_t depth = interpreter_.depth();
  if (codes_.return_) {
    std::optional<std::uint32_t> label;
    std::int64_t p = 0;
    if (words_.has('P')) {
      if (!state_.values.integer(words_['P'], 0, 99999999, p)) return false;
      label = static_cast<std::uint32_t>(p);
    }
    transferred_ = true;
    return calls_.return_from_program(label);
  }
  if (codes_.call && !calls_.call_subprogram(words_, call_name_, ProgramCalls::Kind::subprogram))
    return false;
  if (codes_.external_call &&
      !calls_.call_subprogram(words_, call_name_, ProgramCalls::Kind::external))
    return false;
  bool called = false;
  if (!call_by_code(words_, called)) return false;
  if (moved_ && !calls_.trigger()) return false;
  transferred_ = interpreter_.depth() != depth;
  return true;
}

// M codes of 6071 to 6079, and T, S, B where they call programs (fanuc-dialect.md §6.4).
bool Controller::call_by_code(const Words& words, bool& called) {
  if (!codes_call_subprograms_ || calls_.codes_are_ordinary()) return true;
  using Kind = ProgramCalls::Kind;
  std::int64_t repeats = 1;
  if (called_m_ != nullptr) {
    const auto sub =
        std::find(parameters_.m_sub.begin(), parameters_.m_sub.end(), code_number(*called_m_));
    if (words.has('L') && !state_.values.integer(words['L'], 0, 9999, repeats)) return false;
    called = true;
    const auto number = kFirstMSub + static_cast<std::uint32_t>(sub - parameters_.m_sub.begin());
    if (!calls_.call_fixed(number, repeats, Kind::code_sub)) return false;
  }
  auto& commons = state_.memory.commons;
  if (parameters_.t_calls_program && words.has('T')) {
    commons[kToolCommon] = static_cast<double>(state_.words.tool);
    called = true;
    if (!calls_.call_fixed(kToolProgram, 1, Kind::code_sub)) return false;
  }
  if (parameters_.s_calls_program && words.has('S')) {
    commons[kSpeedCommon] = state_.words.speed;
    if (!calls_.call_fixed(kSpeedProgram, 1, Kind::code_sub)) return false;
  }
  if (parameters_.b_calls_program && words.has('B') && !axes_.find('B')) {
    commons[kSecondAuxiliaryCommon] = words['B'].value;
    if (!calls_.call_fixed(kSecondAuxiliaryProgram, 1, Kind::code_sub)) return false;
  }
  return true;
}

}  // namespace kerf::control
