#include "lang/vm/interpreter.hpp"

#include <algorithm>
#include <cassert>

#include "lang/vm/value.hpp"

namespace kerf::vm {
namespace {

constexpr std::size_t kCachedJumps = 1024;

bool equal(double x, double y) { return x == y || (is_null(x) && is_null(y)); }
bool less(double x, double y) { return zero_if_null(x) < zero_if_null(y); }
bool less_equal(double x, double y) { return zero_if_null(x) <= zero_if_null(y); }

// Whether a loop that counts by `step` has a pass at `value`: an end that rounding has missed by a
// millionth of a step is reached.
bool is_within(double value, double to, double step) {
  constexpr double kMissed = 1e-6;
  return step > 0 ? value <= to + kMissed * step : value >= to + kMissed * step;
}

std::size_t slot_of(CodeId code, Address from, std::uint32_t label) {
  const std::uint64_t mixed =
      (static_cast<std::uint64_t>(code) * 0x9e3779b97f4a7c15ULL) ^
      ((std::uint64_t{from.page} << 32 | from.instruction) * 0xc2b2ae3d27d4eb4fULL) ^
      (label * 0x165667b19e3779f9ULL);
  return static_cast<std::size_t>(mixed >> 54) % kCachedJumps;
}

}  // namespace

Interpreter::Interpreter(CodeSource& source, Host& host, const Settings& settings)
    : source_(source),
      host_(host),
      settings_(settings),
      registers_(kRegisters, kNull),
      jumps_(kCachedJumps) {
  assert(settings.locals < kRegisters);
}

void Interpreter::start(CodeId main) {
  registers_.assign(kRegisters, kNull);
  frames_.assign(1, Frame{.code = main});
  loops_.clear();
  saved_.clear();
  steps_left_ = settings_.steps;
  steps_end_.reset();
  steps_spent_ = false;
  std::fill(jumps_.begin(), jumps_.end(), CachedJump{});
  running_ = {};
  begun_.reset();
  note_ = 0;
}

Interpreter::Stop Interpreter::run(std::uint64_t instructions) {
  if (tracing_ || steps_end_) return run_loop<true>(instructions);
  begun_.reset();
  return run_loop<false>(instructions);
}

void Interpreter::call(CodeId code, Locals locals) {
  std::uint32_t base = frames_.back().base;
  if (locals == Locals::fresh) {
    base += kRegisters;
    if (registers_.size() < base + kRegisters) registers_.resize(base + kRegisters, kNull);
    std::fill_n(registers_.begin() + base, settings_.locals, kNull);
  }
  frames_.push_back(Frame{.code = code,
                          .base = base,
                          .first_loop = loops_.size(),
                          .first_saved = saved_.size(),
                          .call = ++calls_,
                          .by = block()});
}

void Interpreter::return_to_caller() {
  assert(frames_.size() > 1);
  const Frame& frame = frames_.back();
  for (; saved_.size() > frame.first_saved; saved_.pop_back())
    variable(saved_.back().variable) = saved_.back().value;
  loops_.resize(frame.first_loop);
  frames_.pop_back();
}

void Interpreter::restart() { jump({}); }

void Interpreter::jump(Address target) {
  drop_left_regions(target);
  frames_.back().at = target;
}

// What stands behind the last block of a page leads to the next page, or is the end.
bool Interpreter::leave_block() {
  if (steps_spent_) return false;
  Frame& frame = frames_.back();
  const bool stands_behind = frame.code == running_.code &&
                             frame.at == Address{running_.at.page, running_.at.instruction + 1};
  if (!stands_behind) return true;
  const CodePage& page = source_.page(frame.code, running_.at.page);
  const auto last = static_cast<std::uint32_t>(page.instructions.size() - 1);
  if (running_.at.instruction >= last) return false;
  const auto next = std::upper_bound(
      page.marks.begin(), page.marks.end(), running_.at.instruction,
      [](std::uint32_t at, const BlockMark& mark) { return at < mark.instruction; });
  jump({page.number, next == page.marks.end() ? last : next->instruction});
  begun_.reset();
  return true;
}

std::span<double> Interpreter::locals() {
  return std::span(registers_).subspan(frames_.back().base, settings_.locals);
}

base::Place Interpreter::place() {
  base::Place place =
      source_.page(running_.code, running_.at.page).place_of(running_.at.instruction);
  // A page may hold no block at all: comments, or nothing but the end of the program.
  for (std::uint32_t page = running_.at.page; place.line == 0 && page > 0; --page) {
    const CodePage& before = source_.page(running_.code, page - 1);
    place = before.place_of(static_cast<std::uint32_t>(before.instructions.size() - 1));
  }
  if (steps_spent_) {
    place.column = steps_end_->column;
    place.length = 1;
  }
  return place;
}

base::Place Interpreter::place_of_call(std::size_t depth) {
  const Frame& caller = frames_[depth - 1];
  const std::uint32_t behind = caller.at.instruction;
  return source_.page(caller.code, caller.at.page).place_of(behind == 0 ? 0 : behind - 1);
}

// What belongs to no block, as the end of the program, counts to the block before it.
base::BlockId Interpreter::block() {
  for (Address at = running_.at;; at = {at.page - 1, ~0U}) {
    const CodePage& page = source_.page(running_.code, at.page);
    if (const BlockMark* const mark = page.mark_of(at.instruction)) return page.id_of(*mark);
    if (at.page == 0) return {.file = page.file};
  }
}

// Leaving a region by a jump ends it; one whose text still surrounds the target stays active.
void Interpreter::drop_left_regions(Address target) {
  for (ActiveRegion& region : frames_.back().regions) {
    if (region.active && (target < region.head || region.end < target)) region.active = false;
  }
}

bool Interpreter::jump_to_label(std::uint32_t label) {
  const Frame& frame = frames_.back();
  CachedJump& cached = jumps_[slot_of(frame.code, frame.at, label)];
  if (cached.label != label || cached.code != frame.code || cached.from != frame.at) {
    const std::optional<Address> found = source_.find_label(frame.code, frame.at, label);
    if (!found) return false;
    cached = {frame.code, frame.at, label, *found};
  }
  jump(cached.to);
  return true;
}

bool Interpreter::go_to_label(double label) {
  if (!(label >= 0 && label <= 4294967295.0)) return fail(Fault::label_range);
  return jump_to_label(static_cast<std::uint32_t>(label)) || fail(Fault::label_missing);
}

const Region* Interpreter::closed_region(std::uint32_t number) {
  const Address at = running_.at;
  const CodeId code = frames_.back().code;
  Region* region = &source_.page(code, at.page).regions[number];
  if (region->state == Region::State::unresolved) {
    const Region resolved = source_.resolve_region(code, at.page, number);
    region = &source_.page(code, at.page).regions[number];
    *region = resolved;
  }
  if (region->state == Region::State::closed) return region;
  fail(region->state == Region::State::open ? Fault::region_open : Fault::region_crossing);
  return nullptr;
}

bool Interpreter::enter_region(std::uint32_t number) {
  const Region* const region = closed_region(number);
  if (region == nullptr) return false;
  frames_.back().regions[region->slot] = {true, {running_.at.page, region->head}, region->end};
  return true;
}

bool Interpreter::leave_region(std::uint32_t number) {
  const Region* const region = closed_region(number);
  if (region == nullptr) return false;
  frames_.back().regions[region->slot].active = false;
  frames_.back().at = {region->end.page, region->end.instruction + 1};
  return true;
}

bool Interpreter::repeat_region(std::uint8_t slot) {
  const ActiveRegion& region = frames_.back().regions[slot];
  if (!region.active || region.end != running_.at) return fail(Fault::region_not_entered);
  frames_.back().at = region.head;
  return true;
}

double& Interpreter::variable(std::uint32_t number) {
  return number < kRegisters ? registers_[frames_.back().base + number]
                             : settings_.globals[number - kRegisters];
}

// A loop that was left by a jump and begins anew: it and what was inside of it are over.
void Interpreter::discard_loop_of(std::uint32_t variable) {
  const auto begin = loops_.begin() + static_cast<std::ptrdiff_t>(frames_.back().first_loop);
  const auto found = std::find_if(
      begin, loops_.end(), [&](const CountedLoop& loop) { return loop.variable == variable; });
  loops_.erase(found, loops_.end());
}

// Precondition: the frame's `at` is the next instruction, which a loop with a pass skips.
bool Interpreter::open_loop(const Instruction& instruction, bool& has_pass) {
  const double* const r = registers_.data() + frames_.back().base + instruction.a;
  CountedLoop loop;
  loop.variable = instruction.n;
  loop.first = loop.last = zero_if_null(r[0]);
  loop.to = zero_if_null(r[1]);
  loop.step = zero_if_null(r[2]);
  if (loop.step == 0) return fail(Fault::zero_step);
  discard_loop_of(loop.variable);
  variable(loop.variable) = loop.first;
  has_pass = is_within(loop.first, loop.to, loop.step);
  if (!has_pass) return true;
  if (loops_.size() >= settings_.most_loops) return fail(Fault::loop_depth);
  const Address next = frames_.back().at;
  loop.head = {next.page, next.instruction + 1};
  loops_.push_back(loop);
  return true;
}

// Where it goes on, the frame's `at` becomes the head of the loop.
bool Interpreter::repeat_loop(std::uint32_t number, bool& goes_on) {
  const std::size_t first = frames_.back().first_loop;
  while (number != kAnyLoop && loops_.size() > first && loops_.back().variable != number)
    loops_.pop_back();
  if (loops_.size() == first) return fail(Fault::loop_not_open);
  CountedLoop& loop = loops_.back();
  double& value = variable(loop.variable);
  if (value != loop.last) {
    loop.first = zero_if_null(value);
    loop.passes = 0;
  }
  ++loop.passes;
  value = loop.last = loop.first + loop.passes * loop.step;
  if (!is_number(value)) return fail(Fault::overflow);
  goes_on = is_within(value, loop.to, loop.step);
  if (goes_on) {
    frames_.back().at = loop.head;
  } else {
    loops_.pop_back();
  }
  return true;
}

bool Interpreter::call_label(std::uint32_t label) {
  if (frames_.size() > settings_.most_calls) return fail(Fault::call_depth);
  Frame called = frames_.back();
  called.first_loop = loops_.size();
  called.first_saved = saved_.size();
  called.regions = {};
  called.call = ++calls_;
  called.by = block();
  frames_.push_back(called);
  if (jump_to_label(label)) return true;
  frames_.pop_back();
  return fail(Fault::label_missing);
}

// Once a call: what was saved first is what comes back.
void Interpreter::save_variable(std::uint32_t number) {
  const auto begin = saved_.begin() + static_cast<std::ptrdiff_t>(frames_.back().first_saved);
  const bool saved = std::any_of(begin, saved_.end(), [&](const SavedVariable& candidate) {
    return candidate.variable == number;
  });
  if (!saved) saved_.push_back({number, variable(number)});
}

// Steps are counted many at a time; the last ones one by one, so that the program ends where it
// should however it is cut.
void Interpreter::end_steps_behind(const CodePage& page, std::uint32_t count_steps) {
  const BlockMark& end = page.mark_of(count_steps)[steps_left_];
  steps_end_ = StepsEnd{{page.number, end.instruction}, end.offset - end.line_offset + 1};
  steps_left_ = 0;
}

bool Interpreter::fail(Fault fault) {
  host_.fault(fault);
  return false;
}

// The dispatch loop. `pc` is the next instruction; `frame->at` is brought up to date only before
// something outside of the loop can look at it. The budget counts jumps, blocks and pages: between
// two of them lies at most a page of plain arithmetic.
template <bool kTracing>
Interpreter::Stop Interpreter::run_loop(std::uint64_t budget) {
  CodePage* page = nullptr;
  const Instruction* code = nullptr;
  const double* constants = nullptr;
  double* r = nullptr;
  std::uint32_t pc = 0;
  std::uint32_t next_mark = 0;  // instruction at which the next block begins

  const auto find_mark = [&] {
    if constexpr (kTracing) {
      const auto mark = std::lower_bound(
          page->marks.begin(), page->marks.end(), pc,
          [](const BlockMark& candidate, std::uint32_t at) { return candidate.instruction < at; });
      next_mark = mark == page->marks.end() ? ~0U : mark->instruction;
    }
  };
  const auto load = [&] {
    const Frame& frame = frames_.back();
    page = &source_.page(frame.code, frame.at.page);
    code = page->instructions.data();
    constants = page->constants.data();
    r = registers_.data() + frame.base;
    pc = frame.at.instruction;
    find_mark();
  };
  // Of the pass that begins: most often it is on this page.
  const auto go_on_at_head = [&] {
    const Address head = frames_.back().at;
    if (head.page != page->number) return load();
    pc = head.instruction;
    find_mark();
  };
  // What the host may see: where we are (`running_`) and where we go on (`at`).
  const auto save = [&] {
    Frame& frame = frames_.back();
    running_ = {frame.code, {page->number, pc - 1}};
    frame.at = {page->number, pc};
  };
  // The host does not go on: `again` puts the instruction before itself, its block as begun.
  const auto left = [&](Verdict verdict) {
    if (verdict == Verdict::stop) return Stop::over;
    if (verdict == Verdict::again) {
      frames_.back().at = running_.at;
      begun_ = running_.at;
    }
    return Stop::paused;
  };
  const auto faulty = [&](Fault fault) {
    save();
    fail(fault);
    return Stop::over;
  };

  budget = std::max<std::uint64_t>(budget, 1);
  load();
  for (;;) {
    if constexpr (kTracing) {
      if (pc == next_mark) {
        const Address here{page->number, pc};
        if (steps_end_ && steps_end_->at == here) {
          ++pc;
          steps_spent_ = true;
          return faulty(Fault::steps_spent);
        }
        if (begun_ != here) {
          ++pc, save(), --pc;
          frames_.back().at = here;
          begun_ = here;
          const Verdict verdict = host_.begin_block(*page, *page->mark_of(pc));
          if (verdict == Verdict::stop) return Stop::over;
          if (verdict == Verdict::pause) return Stop::paused;
          if (verdict == Verdict::transferred) {
            begun_.reset();
            load();
            continue;
          }
        }
        begun_.reset();
        ++pc;
        find_mark();
        --pc;
      }
    }
    const Instruction i = code[pc++];
    switch (i.op) {
      case Op::load_constant: r[i.a] = constants[i.n]; break;
      case Op::load_null: r[i.a] = kNull; break;
      case Op::move: r[i.a] = r[i.b]; break;
      case Op::load_global: r[i.a] = settings_.globals[i.n]; break;
      case Op::store_global: settings_.globals[i.n] = r[i.a]; break;
      case Op::read:
      case Op::read_fixed: {
        save();
        double value = kNull;
        const Verdict verdict = host_.read(i.op == Op::read ? zero_if_null(r[i.b]) : i.n, value);
        if (verdict != Verdict::go_on) return left(verdict);
        r[i.a] = value;
        break;
      }
      case Op::write:
      case Op::write_fixed: {
        save();
        const bool fixed = i.op == Op::write_fixed;
        const Verdict verdict =
            host_.write(fixed ? i.n : zero_if_null(r[i.a]), fixed ? r[i.a] : r[i.b]);
        if (verdict != Verdict::go_on) return left(verdict);
        break;
      }
      case Op::negate: r[i.a] = -zero_if_null(r[i.b]); break;

#define KERF_ARITHMETIC(operation, right)                          \
  {                                                                \
    double result = r[i.b] operation right;                        \
    if (!is_number(result)) {                                      \
      result = zero_if_null(r[i.b]) operation zero_if_null(right); \
      if (!is_number(result)) return faulty(Fault::overflow);      \
    }                                                              \
    r[i.a] = result;                                               \
    break;                                                         \
  }
      case Op::add: KERF_ARITHMETIC(+, r[i.c])
      case Op::subtract: KERF_ARITHMETIC(-, r[i.c])
      case Op::multiply: KERF_ARITHMETIC(*, r[i.c])
      case Op::add_constant: KERF_ARITHMETIC(+, constants[i.n])
      case Op::subtract_constant: KERF_ARITHMETIC(-, constants[i.n])
      case Op::multiply_constant: KERF_ARITHMETIC(*, constants[i.n])
#undef KERF_ARITHMETIC

      case Op::divide:
      case Op::divide_constant: {
        const double divisor = zero_if_null(i.op == Op::divide ? r[i.c] : constants[i.n]);
        if (divisor == 0) return faulty(Fault::zero_divide);
        const double result = zero_if_null(r[i.b]) / divisor;
        if (!is_number(result)) return faulty(Fault::overflow);
        r[i.a] = result;
        break;
      }
      case Op::equal: r[i.a] = equal(r[i.b], r[i.c]); break;
      case Op::not_equal: r[i.a] = !equal(r[i.b], r[i.c]); break;
      case Op::less: r[i.a] = less(r[i.b], r[i.c]); break;
      case Op::less_equal: r[i.a] = less_equal(r[i.b], r[i.c]); break;
      case Op::greater: r[i.a] = less(r[i.c], r[i.b]); break;
      case Op::greater_equal: r[i.a] = less_equal(r[i.c], r[i.b]); break;

#define KERF_BRANCH(condition)           \
  if ((condition) == (i.a != 0)) {       \
    pc = i.n;                            \
    if constexpr (kTracing) find_mark(); \
  }                                      \
  break;
      case Op::branch_equal: KERF_BRANCH(equal(r[i.b], r[i.c]))
      case Op::branch_not_equal: KERF_BRANCH(!equal(r[i.b], r[i.c]))
      case Op::branch_less: KERF_BRANCH(less(r[i.b], r[i.c]))
      case Op::branch_less_equal: KERF_BRANCH(less_equal(r[i.b], r[i.c]))
      case Op::branch_greater: KERF_BRANCH(less(r[i.c], r[i.b]))
      case Op::branch_greater_equal: KERF_BRANCH(less_equal(r[i.c], r[i.b]))
      case Op::branch: KERF_BRANCH(zero_if_null(r[i.b]) != 0)
#undef KERF_BRANCH

      case Op::jump:
        drop_left_regions({page->number, i.n});
        if (--budget == 0) {
          save();
          frames_.back().at = {page->number, i.n};
          return Stop::budget;
        }
        pc = i.n;
        find_mark();
        break;
      case Op::jump_to_label: {
        save();
        if (!go_to_label(i.c != 0 ? i.n : r[i.b])) return Stop::over;
        if (--budget == 0) return Stop::budget;
        load();
        break;
      }
      case Op::call_builtin: {
        BuiltinContext context{settings_.builtin_rules, Fault::none};
        const double result = page->builtins[i.n].call(r + i.b, context);
        if (context.fault != Fault::none) return faulty(context.fault);
        if (!is_number(result)) return faulty(Fault::overflow);
        r[i.a] = result;
        break;
      }
      case Op::do_block: {
        save();
        const Verdict verdict = host_.execute(*page, i.n, r);
        if (verdict == Verdict::stop) return Stop::over;
        if (verdict == Verdict::pause) return Stop::paused;
        if (verdict == Verdict::transferred) load();
        if (--budget == 0) {
          if (verdict == Verdict::go_on) save();
          return Stop::budget;
        }
        break;
      }
      case Op::enter_region: {
        const Region& region = page->regions[i.n];
        if (region.state == Region::State::closed) {
          frames_.back().regions[region.slot] = {true, {page->number, region.head}, region.end};
          break;
        }
        save();
        if (!enter_region(i.n)) return Stop::over;
        load();
        break;
      }
      case Op::leave_region:
        save();
        if (!leave_region(i.n)) return Stop::over;
        load();
        break;
      case Op::repeat_region:
        save();
        if (!repeat_region(i.a)) return Stop::over;
        if (--budget == 0) return Stop::budget;
        go_on_at_head();
        break;
      case Op::read_if_null:
        if (is_null(r[i.a])) {
          save();
          double value = kNull;
          const Verdict verdict = host_.read(i.n, value);
          if (verdict != Verdict::go_on) return left(verdict);
          r[i.a] = value;
        }
        break;
      case Op::open_loop: {
        save();
        bool has_pass = false;
        if (!open_loop(i, has_pass)) return Stop::over;
        if (has_pass) ++pc;
        find_mark();
        break;
      }
      case Op::repeat_loop: {
        save();
        bool goes_on = false;
        if (!repeat_loop(i.n, goes_on)) return Stop::over;
        if (--budget == 0) return Stop::budget;
        if (goes_on) go_on_at_head();
        break;
      }
      case Op::call_label:
        save();
        if (!call_label(i.n)) return Stop::over;
        if (--budget == 0) return Stop::budget;
        load();
        break;
      case Op::leave_call:
        if (frames_.size() == 1) return faulty(Fault::return_without_call);
        save();
        return_to_caller();
        if (--budget == 0) return Stop::budget;
        load();
        break;
      case Op::save_variable: save_variable(i.n); break;
      case Op::count_steps:
        if (steps_left_ >= i.n) {
          steps_left_ -= i.n;
          break;
        }
        save();
        steps_spent_ = steps_left_ == 0;
        end_steps_behind(*page, pc - 1);
        if (steps_spent_) return faulty(Fault::steps_spent);
        if constexpr (!kTracing) return run_loop<true>(budget);
        break;
      case Op::skip_when_on:
        ++switches_read_;
        if ((switches_ >> i.a & 1U) != 0) {
          pc = i.n;
          find_mark();
        }
        break;
      case Op::note: note_ = i.n; break;
      case Op::fail:
        save();
        host_.failure(page->failures[i.n]);
        return Stop::over;
      case Op::next_page: {
        Frame& frame = frames_.back();
        frame.at = {page->number + 1, 0};
        load();
        if (--budget == 0) {
          running_ = {frame.code, frame.at};
          return Stop::budget;
        }
        break;
      }
      case Op::end_of_code: {
        save();
        const Verdict verdict = host_.end_of_code();
        if (verdict == Verdict::stop) return Stop::over;
        if (verdict == Verdict::pause) return Stop::paused;
        load();
        break;
      }
    }
  }
}

}  // namespace kerf::vm
