// Values: sums, comparisons, variables, faults, functions.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "lang/vm/interpreter_bench.hpp"

namespace kerf::vm::test {
namespace {

constexpr double kMost = std::numeric_limits<double>::max();

std::string text(double value) { return is_null(value) ? "null" : std::to_string(value); }

// R[3] = R[1] op R[2], and the same with a constant; `wanted` null: the fault is wanted.
void expect_result(Op op, Op constant_op, double left, double right, double wanted, Fault fault) {
  for (const bool with_constant : {false, true}) {
    if (with_constant && constant_op == op) continue;
    Machine machine;
    PageBuilder page;
    page.load(1, left).load(2, right).load(3, 77);
    if (with_constant) {
      page.with_constant(constant_op, 3, 1, right);
    } else {
      page.three(op, 3, 1, 2);
    }
    EXPECT_EQ(machine.run(page.end()), Stop::over);
    const std::string what = text(left) + ", " + text(right) + " with operation " +
                             std::to_string(static_cast<int>(op)) +
                             (with_constant ? " and a constant" : "");
    EXPECT_EQ(machine.host.last_fault, fault) << what;
    EXPECT_EQ(machine.local(3), fault == Fault::none ? wanted : 77) << what;
  }
}

TEST(Interpreter, ArithmeticReadsNullAsZero) {
  const double values[] = {kNull, 0, 3, -2.5, 1e300};
  for (const double a : values) {
    for (const double b : values) {
      const double x = zero_if_null(a);
      const double y = zero_if_null(b);
      expect_result(Op::add, Op::add_constant, a, b, x + y, Fault::none);
      expect_result(Op::subtract, Op::subtract_constant, a, b, x - y, Fault::none);
      const bool too_large = std::isinf(x * y);
      expect_result(Op::multiply, Op::multiply_constant, a, b, x * y,
                    too_large ? Fault::overflow : Fault::none);
      expect_result(Op::divide, Op::divide_constant, a, b, y == 0 ? 0 : x / y,
                    y == 0 ? Fault::zero_divide : Fault::none);
    }
  }
}

TEST(Interpreter, AResultThatNoDoubleHoldsIsAnOverflow) {
  expect_result(Op::add, Op::add_constant, kMost, kMost, 0, Fault::overflow);
  expect_result(Op::subtract, Op::subtract_constant, -kMost, kMost, 0, Fault::overflow);
  expect_result(Op::multiply, Op::multiply_constant, 1e200, -1e200, 0, Fault::overflow);
  expect_result(Op::divide, Op::divide_constant, 1e300, 1e-300, 0, Fault::overflow);
}

TEST(Interpreter, TheNegativeOfNullIsZero) {
  Machine machine;
  machine.run(PageBuilder().load(1, kNull).three(Op::negate, 2, 1, 0).end());
  EXPECT_EQ(machine.local(2), 0);
}

TEST(Interpreter, ACopyOfNullIsNull) {
  Machine machine;
  machine.run(
      PageBuilder().load(1, 5).add({.op = Op::load_null, .a = 2}).three(Op::move, 1, 2, 0).end());
  EXPECT_TRUE(is_null(machine.local(1)));
}

TEST(Interpreter, NullEqualsOnlyNullButIsOrderedAsZero) {
  struct Case {
    double a, b;
    bool equal, less;
  };
  for (const Case& c :
       {Case{kNull, kNull, true, false}, Case{kNull, 0, false, false}, Case{0, kNull, false, false},
        Case{kNull, 1, false, true}, Case{kNull, -1, false, false}, Case{-1, kNull, false, true},
        Case{2, 2, true, false}, Case{1, 2, false, true}, Case{2, 1, false, false},
        Case{0, -0.0, true, false}}) {
    const double a = zero_if_null(c.a);
    const double b = zero_if_null(c.b);
    const std::pair<Op, bool> wanted[] = {{Op::equal, c.equal}, {Op::not_equal, !c.equal},
                                          {Op::less, c.less},   {Op::less_equal, a <= b},
                                          {Op::greater, a > b}, {Op::greater_equal, a >= b}};
    for (const auto& [op, truth] : wanted)
      expect_result(op, op, c.a, c.b, truth ? 1 : 0, Fault::none);
  }
}

TEST(Interpreter, BranchesGoWhereTheComparisonsSay) {
  const std::pair<Op, Op> pairs[] = {
      {Op::branch_equal, Op::equal},     {Op::branch_not_equal, Op::not_equal},
      {Op::branch_less, Op::less},       {Op::branch_less_equal, Op::less_equal},
      {Op::branch_greater, Op::greater}, {Op::branch_greater_equal, Op::greater_equal}};
  for (const auto& [branch, compare] : pairs) {
    for (const double a : {kNull, 0.0, 1.0}) {
      for (const double b : {kNull, 0.0, 1.0}) {
        for (const bool sense : {false, true}) {
          Machine machine;
          PageBuilder page;
          page.load(1, a).load(2, b).load(4, 1).three(compare, 3, 1, 2);
          page.add({branch, static_cast<std::uint8_t>(sense), 1, 2, 6}).load(4, 0).end();
          machine.run(page);
          const bool taken = machine.local(4) == 1;
          EXPECT_EQ(taken, (machine.local(3) != 0) == sense)
              << text(a) << ", " << text(b) << ", branch " << static_cast<int>(branch);
        }
      }
    }
  }
}

TEST(Interpreter, ATruthValueIsWhatIsNeitherZeroNorNull) {
  for (const double value : {kNull, 0.0, -0.0, 1.0, -3.0}) {
    Machine machine;
    PageBuilder page;
    page.load(1, value).load(2, 1).add({Op::branch, 1, 1, 0, 4}).load(2, 0).end();
    machine.run(page);
    EXPECT_EQ(machine.local(2), value == 0 || is_null(value) ? 0 : 1) << text(value);
  }
}

TEST(Interpreter, GlobalsLieInTheStorageOfTheCaller) {
  Machine machine;
  machine.globals[2] = 7;
  machine.run(PageBuilder()
                  .add({.op = Op::load_global, .a = 1, .n = 2})
                  .add({.op = Op::store_global, .a = 1, .n = 4})
                  .end());
  EXPECT_EQ(machine.local(1), 7);
  EXPECT_EQ(machine.globals[4], 7);
  EXPECT_TRUE(is_null(machine.globals[3]));
}

TEST(Interpreter, OtherVariablesAreTheHosts) {
  Machine machine;
  machine.host.variables[50] = 5;
  machine.run(PageBuilder()
                  .load(1, 50)
                  .three(Op::read, 2, 1, 0)
                  .add({.op = Op::read_fixed, .a = 3, .n = 51})
                  .load(4, 60)
                  .three(Op::write, 4, 2, 0)
                  .add({.op = Op::write_fixed, .a = 2, .n = 61})
                  .end());
  EXPECT_EQ(machine.host.events, (Events{"read 50", "read 51", "write 60", "write 61", "end"}));
  EXPECT_EQ(machine.local(2), 5);
  EXPECT_TRUE(is_null(machine.local(3)));
  EXPECT_EQ(machine.host.variables[60], 5);
  EXPECT_EQ(machine.host.variables[61], 5);
}

TEST(Interpreter, AVariableThatCannotBeReadEndsTheProgramAtThatInstruction) {
  Machine machine;
  machine.host.readable = false;
  EXPECT_EQ(machine.run(PageBuilder().load(1, 3).three(Op::read, 2, 1, 0).block(0).end()),
            Stop::over);
  EXPECT_EQ(machine.host.events, Events{"read 3"});
  EXPECT_EQ(machine.interpreter.place().line, 2U);
}

TEST(Interpreter, AWriteThatPausesGoesOnBehindIt) {
  Machine machine;
  machine.host.on_write = [](double) { return Verdict::pause; };
  PageBuilder page;
  page.add({.op = Op::write_fixed, .a = 1, .n = 9}).block(1).end();
  EXPECT_EQ(machine.run(page), Stop::paused);
  EXPECT_EQ(machine.interpreter.run(kPlenty), Stop::over);
  EXPECT_EQ(machine.host.events, (Events{"write 9", "block 1", "end"}));
}

TEST(Interpreter, EveryFaultNamesItsInstruction) {
  Machine machine;
  machine.run(PageBuilder().load(1, 1).load(2, 0).three(Op::divide, 3, 1, 2).block(0).end());
  EXPECT_EQ(machine.host.events.size(), 1U) << "the program went on behind the fault";
  const base::Place place = machine.interpreter.place();
  EXPECT_EQ(place.line, 3U);
  EXPECT_EQ(place.column, 3U);
  EXPECT_EQ(place.length, 3U);
}

TEST(Interpreter, AFailureOfTheTextIsHandedToTheHostWhenItIsReached) {
  Machine machine;
  PageBuilder page;
  base::Diagnostic diagnostic;
  diagnostic.message = "wrong";
  page.page().failures = {base::Diagnostic{}, diagnostic};
  EXPECT_EQ(machine.run(page.block(0).add({.op = Op::fail, .n = 1}).block(1).end()), Stop::over);
  EXPECT_EQ(machine.host.events, (Events{"block 0", "failure wrong"}));
}

TEST(Interpreter, ABuiltinTakesItsArgumentsAndMayFail) {
  static constexpr Builtin kTable[] = {
      {[](const double* r, BuiltinContext&) { return r[0] * 10 + zero_if_null(r[1]); }, 2},
      {[](const double*, BuiltinContext& context) {
         context.fault = Fault::domain;
         return 0.0;
       },
       0},
      {[](const double*, BuiltinContext&) { return std::nan(""); }, 0}};
  const auto call = [&](std::uint32_t n) {
    Machine machine;
    PageBuilder page;
    page.page().builtins = kTable;
    page.load(2, 4).load(3, kNull).load(5, 77).add({Op::call_builtin, 5, 2, 0, n});
    machine.run(page.end());
    return std::pair(machine.local(5), machine.host.last_fault);
  };
  EXPECT_EQ(call(0), std::pair(40.0, Fault::none));
  EXPECT_EQ(call(1), std::pair(77.0, Fault::domain));
  EXPECT_EQ(call(2), std::pair(77.0, Fault::overflow)) << "a function made a null";
}

}  // namespace
}  // namespace kerf::vm::test
