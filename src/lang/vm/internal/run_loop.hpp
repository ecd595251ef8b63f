#pragma once

// The dispatch loop of the interpreter, for interpreter.cpp alone.

#include <algorithm>
#include <functional>

#include "lang/vm/interpreter.hpp"
#include "lang/vm/value.hpp"

namespace kerf::vm {

inline bool equal(double x, double y) { return x == y || (is_null(x) && is_null(y)); }
inline bool less(double x, double y) { return zero_if_null(x) < zero_if_null(y); }
inline bool less_equal(double x, double y) { return zero_if_null(x) <= zero_if_null(y); }

// Where the loop is, and what each instruction does. Every member is inlined into run_loop(), so
// that nothing has the address of the object and the compiler keeps all of it in registers.
//
// A member that returns a bool tells whether the run goes on, at `pc`; if not, `stop` says why.
//
// `at` of the frame is brought up to date only before something outside of the loop can look at it.
// The budget counts jumps, blocks and pages: between two of them lies at most a page of plain
// arithmetic.
template <bool kTracing>
struct Interpreter::Loop {
  Interpreter& vm;
  std::uint64_t budget;
  Stop stop = Stop::over;
  CodePage* page = nullptr;
  const Instruction* code = nullptr;
  const double* constants = nullptr;
  double* r = nullptr;
  std::uint32_t pc = 0;         // the next instruction
  std::uint32_t next_mark = 0;  // instruction at which the next block begins

  // `i` is that before `pc`, on a page: it is not looked at again behind a call of the host.
  [[gnu::always_inline]] bool execute(const Instruction& i) {
    switch (i.op) {
      case Op::load_constant: r[i.a] = constants[i.n]; return true;
      case Op::load_null: r[i.a] = kNull; return true;
      case Op::move: r[i.a] = r[i.b]; return true;
      case Op::load_global: r[i.a] = vm.settings_.globals[i.n]; return true;
      case Op::store_global: vm.settings_.globals[i.n] = r[i.a]; return true;
      case Op::read: return read(i.a, zero_if_null(r[i.b]));
      case Op::read_fixed: return read(i.a, i.n);
      case Op::read_if_null: return !is_null(r[i.a]) || read(i.a, i.n);
      case Op::write: return write(zero_if_null(r[i.a]), r[i.b]);
      case Op::write_fixed: return write(i.n, r[i.a]);
      case Op::negate: r[i.a] = -zero_if_null(r[i.b]); return true;
      case Op::add: return calculate(i, r[i.c], std::plus<>());
      case Op::subtract: return calculate(i, r[i.c], std::minus<>());
      case Op::multiply: return calculate(i, r[i.c], std::multiplies<>());
      case Op::divide: return divide(i, r[i.c]);
      case Op::add_constant: return calculate(i, constants[i.n], std::plus<>());
      case Op::subtract_constant: return calculate(i, constants[i.n], std::minus<>());
      case Op::multiply_constant: return calculate(i, constants[i.n], std::multiplies<>());
      case Op::divide_constant: return divide(i, constants[i.n]);
      case Op::equal: r[i.a] = equal(r[i.b], r[i.c]); return true;
      case Op::not_equal: r[i.a] = !equal(r[i.b], r[i.c]); return true;
      case Op::less: r[i.a] = less(r[i.b], r[i.c]); return true;
      case Op::less_equal: r[i.a] = less_equal(r[i.b], r[i.c]); return true;
      case Op::greater: r[i.a] = less(r[i.c], r[i.b]); return true;
      case Op::greater_equal: r[i.a] = less_equal(r[i.c], r[i.b]); return true;
      case Op::branch_equal: branch(i, equal(r[i.b], r[i.c])); return true;
      case Op::branch_not_equal: branch(i, !equal(r[i.b], r[i.c])); return true;
      case Op::branch_less: branch(i, less(r[i.b], r[i.c])); return true;
      case Op::branch_less_equal: branch(i, less_equal(r[i.b], r[i.c])); return true;
      case Op::branch_greater: branch(i, less(r[i.c], r[i.b])); return true;
      case Op::branch_greater_equal: branch(i, less_equal(r[i.c], r[i.b])); return true;
      case Op::branch: branch(i, zero_if_null(r[i.b]) != 0); return true;
      case Op::jump: return jump(i.n);
      case Op::jump_to_label: return jump_to_label(i);
      case Op::call_builtin: return call_builtin(i);
      case Op::do_block: return do_block(i.n);
      case Op::enter_region: return enter_region(i.n);
      case Op::leave_region: return leave_region(i.n);
      case Op::repeat_region: return repeat_region(i.a);
      case Op::open_loop: return open_loop(i);
      case Op::repeat_loop: return repeat_loop(i.n);
      case Op::call_label: return call_label(i.n);
      case Op::leave_call: return leave_call();
      case Op::save_variable: vm.save_variable(i.n); return true;
      case Op::count_steps: return count_steps(i.n);
      case Op::skip_when_on: skip_when_on(i); return true;
      case Op::note: vm.note_ = i.n; return true;
      case Op::fail: return fail(i.n);
      case Op::next_page: return go_to_next_page();
      case Op::end_of_code: return end_of_code();
    }
    __builtin_unreachable();  // spares the test whether there is such an instruction
  }

  // Where we are, and where we go on.

  [[gnu::always_inline]] void find_mark(std::uint32_t from) {
    if constexpr (kTracing) {
      const auto mark = std::lower_bound(
          page->marks.begin(), page->marks.end(), from,
          [](const BlockMark& candidate, std::uint32_t at) { return candidate.instruction < at; });
      next_mark = mark == page->marks.end() ? ~0U : mark->instruction;
    }
  }

  [[gnu::always_inline]] void go_to(std::uint32_t instruction) {
    pc = instruction;
    find_mark(pc);
  }

  [[gnu::always_inline]] void load() {
    const Frame& frame = vm.frames_.back();
    page = &vm.source_.page(frame.code, frame.at.page);
    code = page->instructions.data();
    constants = page->constants.data();
    r = vm.registers_.data() + frame.base;
    go_to(frame.at.instruction);
  }

  // Of the pass that begins: most often it is on this page.
  [[gnu::always_inline]] void go_on_at_head() {
    const Address head = vm.frames_.back().at;
    if (head.page != page->number) return load();
    go_to(head.instruction);
  }

  [[gnu::always_inline]] bool go_on_elsewhere() {
    if (!spend()) return false;
    load();
    return true;
  }

  // What the host may see: where we are (`running_`) and where we go on (`at`).
  [[gnu::always_inline]] void save() {
    Frame& frame = vm.frames_.back();
    vm.running_ = {frame.code, {page->number, pc - 1}};
    frame.at = {page->number, pc};
  }

  // How the run ends.

  [[gnu::always_inline]] bool ends(Stop why) {
    stop = why;
    return false;
  }

  [[gnu::always_inline]] bool spend() { return --budget != 0 || ends(Stop::budget); }

  // The host does not go on: `again` puts the instruction before itself, its block as begun.
  [[gnu::always_inline]] bool left(Verdict verdict) {
    if (verdict == Verdict::stop) return ends(Stop::over);
    if (verdict == Verdict::again) {
      vm.frames_.back().at = vm.running_.at;
      vm.begun_ = vm.running_.at;
    }
    return ends(Stop::paused);
  }

  [[gnu::always_inline]] bool faulty(Fault fault) {
    save();
    vm.fail(fault);
    return ends(Stop::over);
  }

  // What happens before and in an instruction.

  // The host may send us on to where another block begins.
  [[gnu::always_inline]] bool begin_blocks() {
    if constexpr (kTracing) {
      while (pc == next_mark) {
        if (!begin_block()) return false;
      }
    }
    return true;
  }

  [[gnu::always_inline]] bool begin_block() {
    const Address here{page->number, pc};
    if (vm.steps_end_ && vm.steps_end_->at == here) {
      ++pc;
      vm.steps_spent_ = true;
      return faulty(Fault::steps_spent);
    }
    if (vm.begun_ != here) {
      const Verdict verdict = announce_block(here);
      if (verdict == Verdict::stop || verdict == Verdict::pause) return left(verdict);
      if (verdict == Verdict::transferred) {
        vm.begun_.reset();
        load();
        return true;
      }
    }
    vm.begun_.reset();
    find_mark(pc + 1);
    return true;
  }

  [[gnu::always_inline]] Verdict announce_block(Address here) {
    Frame& frame = vm.frames_.back();
    vm.running_ = {frame.code, here};
    frame.at = here;
    vm.begun_ = here;
    return vm.host_.begin_block(*page, *page->mark_of(pc));
  }

  [[gnu::always_inline]] bool read(std::uint8_t to, double number) {
    save();
    double value = kNull;
    const Verdict verdict = vm.host_.read(number, value);
    if (verdict != Verdict::go_on) return left(verdict);
    r[to] = value;
    return true;
  }

  [[gnu::always_inline]] bool write(double number, double value) {
    save();
    const Verdict verdict = vm.host_.write(number, value);
    return verdict == Verdict::go_on || left(verdict);
  }

  // A result with null is not a number: only then it is looked for.
  template <typename Operation>
  [[gnu::always_inline]] bool calculate(const Instruction& i, double right, Operation operation) {
    double result = operation(r[i.b], right);
    if (!is_number(result)) {
      result = operation(zero_if_null(r[i.b]), zero_if_null(right));
      if (!is_number(result)) return faulty(Fault::overflow);
    }
    r[i.a] = result;
    return true;
  }

  [[gnu::always_inline]] bool divide(const Instruction& i, double right) {
    const double divisor = zero_if_null(right);
    if (divisor == 0) return faulty(Fault::zero_divide);
    const double result = zero_if_null(r[i.b]) / divisor;
    if (!is_number(result)) return faulty(Fault::overflow);
    r[i.a] = result;
    return true;
  }

  [[gnu::always_inline]] bool call_builtin(const Instruction& i) {
    BuiltinContext context{vm.settings_.builtin_rules, Fault::none};
    const double result = page->builtins[i.n].call(r + i.b, context);
    if (context.fault != Fault::none) return faulty(context.fault);
    if (!is_number(result)) return faulty(Fault::overflow);
    r[i.a] = result;
    return true;
  }

  [[gnu::always_inline]] void branch(const Instruction& i, bool condition) {
    if (condition == (i.a != 0)) go_to(i.n);
  }

  [[gnu::always_inline]] void skip_when_on(const Instruction& i) {
    ++vm.switches_read_;
    if ((vm.switches_ >> i.a & 1U) != 0) go_to(i.n);
  }

  [[gnu::always_inline]] bool jump(std::uint32_t instruction) {
    vm.drop_left_regions({page->number, instruction});
    if (!spend()) {
      save();
      vm.frames_.back().at = {page->number, instruction};
      return false;
    }
    go_to(instruction);
    return true;
  }

  [[gnu::always_inline]] bool jump_to_label(const Instruction& i) {
    save();
    if (!vm.go_to_label(i.c != 0 ? i.n : r[i.b])) return ends(Stop::over);
    return go_on_elsewhere();
  }

  [[gnu::always_inline]] bool do_block(std::uint32_t block) {
    save();
    const Verdict verdict = vm.host_.execute(*page, block, r);
    if (verdict == Verdict::stop || verdict == Verdict::pause) return left(verdict);
    if (verdict == Verdict::transferred) load();
    if (!spend()) {
      if (verdict == Verdict::go_on) save();
      return false;
    }
    return true;
  }

  [[gnu::always_inline]] bool enter_region(std::uint32_t number) {
    const Region& region = page->regions[number];
    if (region.state == Region::State::closed) {
      vm.frames_.back().regions[region.slot] = {true, {page->number, region.head}, region.end};
      return true;
    }
    save();
    if (!vm.enter_region(number)) return ends(Stop::over);
    load();
    return true;
  }

  [[gnu::always_inline]] bool leave_region(std::uint32_t number) {
    save();
    if (!vm.leave_region(number)) return ends(Stop::over);
    load();
    return true;
  }

  [[gnu::always_inline]] bool repeat_region(std::uint8_t slot) {
    save();
    if (!vm.repeat_region(slot)) return ends(Stop::over);
    if (!spend()) return false;
    go_on_at_head();
    return true;
  }

  [[gnu::always_inline]] bool open_loop(const Instruction& i) {
    save();
    bool has_pass = false;
    if (!vm.open_loop(i, has_pass)) return ends(Stop::over);
    if (has_pass) go_to(pc + 1);
    return true;
  }

  [[gnu::always_inline]] bool repeat_loop(std::uint32_t variable) {
    save();
    bool goes_on = false;
    if (!vm.repeat_loop(variable, goes_on)) return ends(Stop::over);
    if (!spend()) return false;
    if (goes_on) go_on_at_head();
    return true;
  }

  [[gnu::always_inline]] bool call_label(std::uint32_t label) {
    save();
    if (!vm.call_label(label)) return ends(Stop::over);
    return go_on_elsewhere();
  }

  [[gnu::always_inline]] bool leave_call() {
    if (vm.frames_.size() == 1) return faulty(Fault::return_without_call);
    save();
    vm.return_to_caller();
    return go_on_elsewhere();
  }

  [[gnu::always_inline]] bool count_steps(std::uint32_t blocks) {
    if (vm.steps_left_ >= blocks) {
      vm.steps_left_ -= blocks;
      return true;
    }
    save();
    vm.steps_spent_ = vm.steps_left_ == 0;
    vm.end_steps_behind(*page, pc - 1);
    if (vm.steps_spent_) return faulty(Fault::steps_spent);
    if constexpr (!kTracing) return ends(vm.run_loop<true>(budget));
    return true;
  }

  [[gnu::always_inline]] bool fail(std::uint32_t failure) {
    save();
    vm.host_.failure(page->failures[failure]);
    return ends(Stop::over);
  }

  [[gnu::always_inline]] bool go_to_next_page() {
    Frame& frame = vm.frames_.back();
    frame.at = {page->number + 1, 0};
    load();
    if (!spend()) {
      vm.running_ = {frame.code, frame.at};
      return false;
    }
    return true;
  }

  [[gnu::always_inline]] bool end_of_code() {
    save();
    const Verdict verdict = vm.host_.end_of_code();
    if (verdict == Verdict::stop || verdict == Verdict::pause) return left(verdict);
    load();
    return true;
  }
};

template <bool kTracing>
Interpreter::Stop Interpreter::run_loop(std::uint64_t budget) {
  Loop<kTracing> loop{*this, std::max<std::uint64_t>(budget, 1)};
  loop.load();
  while (loop.begin_blocks() && loop.execute(loop.code[loop.pc++])) continue;
  return loop.stop;
}

}  // namespace kerf::vm
