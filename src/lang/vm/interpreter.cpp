#include "lang/vm/interpreter.hpp"

#include <algorithm>
#include <cassert>

#include "lang/vm/internal/run_loop.hpp"
#include "lang/vm/value.hpp"

namespace kerf::vm {
namespace {

constexpr std::size_t kCachedJumps = 1024;

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

}  // namespace kerf::vm
