#pragma once

// The dispatch loop of the interpreter, for interpreter.cpp alone: a case for each instruction, and
// nothing else.

#include <algorithm>

#include "lang/vm/interpreter.hpp"
#include "lang/vm/value.hpp"

namespace kerf::vm {

inline bool equal(double x, double y) { return x == y || (is_null(x) && is_null(y)); }
inline bool less(double x, double y) { return zero_if_null(x) < zero_if_null(y); }
inline bool less_equal(double x, double y) { return zero_if_null(x) <= zero_if_null(y); }

// `pc` is the next instruction; `frame->at` is brought up to date only before
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
