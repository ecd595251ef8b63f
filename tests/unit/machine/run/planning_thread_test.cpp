#include "machine/run/internal/planning_thread.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "lang/vm/value.hpp"
#include "machine/definition/machine_definition.hpp"
#include "machine/run/batch_run.hpp"

namespace kerf::test {
namespace {

using machine::BatchRun;
using machine::PlanningThread;

/// Has room for some motions, and notes what it is asked for and on which thread.
class SourceStandIn final : public planner::SetpointSource {
 public:
  static constexpr std::size_t kRoom = 37;

  [[nodiscard]] bool room() const override { return waiting_ < kRoom; }
  void take(const motion::Motion& motion) override {
    if (motion.block.line == throws_at) throw std::runtime_error("no more of it");
    ++waiting_;
    calls.push_back(motion.block.line);
    threads.push_back(std::this_thread::get_id());
  }
  void skip() override {
    waiting_ = 0;
    calls.push_back(kSkip);
  }
  void finish() override {}
  [[nodiscard]] bool next(motion::Setpoint& /*point*/) override { return false; }
  [[nodiscard]] double time_s() const override { return 0; }
  [[nodiscard]] const base::TipPoint& tip() const override { return tip_; }
  [[nodiscard]] base::TipPoint motion_end() const override { return tip_; }
  void set_overrides(const planner::Overrides& /*overrides*/) override {}
  void set_spindle_override(double /*factor*/) override {}
  void hold() override {}
  void hold_behind_block() override {}
  void resume() override {}
  void reset() override {}
  [[nodiscard]] bool wants_hold() const override { return false; }
  [[nodiscard]] bool held() const override { return false; }
  [[nodiscard]] bool at_reset() const override { return false; }
  [[nodiscard]] bool empty() const override { return waiting_ == 0; }
  [[nodiscard]] bool standing() const override { return true; }

  static constexpr std::uint32_t kSkip = 0;
  std::vector<std::uint32_t> calls;  // lines of motions, and kSkip
  std::vector<std::thread::id> threads;
  std::optional<std::uint32_t> throws_at;

 private:
  std::size_t waiting_ = 0;
  base::TipPoint tip_;
};

motion::Motion motion_of(std::uint32_t line) {
  motion::Motion motion;
  motion.block.line = line;
  motion.action = motion::Line{};
  return motion;
}

std::vector<std::uint32_t> calls_from_one_thread(std::uint32_t motions) {
  SourceStandIn source;
  for (std::uint32_t line = 1; line <= motions; ++line) {
    if (!source.room()) source.skip();
    source.take(motion_of(line));
  }
  return source.calls;
}

TEST(PlanningThread, TheSourceIsAskedAndFedAsFromOneThread) {
  constexpr std::uint32_t kMotions = 20'000;
  for (const std::uint32_t settle_every : {1U, 100U, 256U, 1000U, 7777U, kMotions}) {
    SourceStandIn source;
    PlanningThread beside(source);
    for (std::uint32_t line = 1; line <= kMotions; ++line) {
      beside.take(motion_of(line));
      if (line % settle_every == 0) beside.settle();
    }
    beside.settle();
    EXPECT_EQ(source.calls, calls_from_one_thread(kMotions)) << settle_every;
  }
}

TEST(PlanningThread, FewMotionsHaveNoThread) {
  SourceStandIn source;
  PlanningThread beside(source);
  for (std::uint32_t line = 1; line <= 1000; ++line) {
    beside.take(motion_of(line));
    if (line % 200 == 0) beside.settle();
  }
  for (const std::thread::id& id : source.threads) EXPECT_EQ(id, std::this_thread::get_id());
}

TEST(PlanningThread, ManyMotionsAreTakenBeside) {
  SourceStandIn source;
  PlanningThread beside(source);
  for (std::uint32_t line = 1; line <= 10'000; ++line) beside.take(motion_of(line));
  beside.settle();
  EXPECT_NE(source.threads.front(), std::this_thread::get_id());
}

TEST(PlanningThread, ThrowsWhatTheSourceThrew) {
  SourceStandIn source;
  source.throws_at = 1234;
  PlanningThread beside(source);
  const auto command_all = [&] {
    for (std::uint32_t line = 1; line <= 10'000; ++line) beside.take(motion_of(line));
    beside.settle();
  };
  EXPECT_THROW(command_all(), std::runtime_error);
  EXPECT_THROW(beside.settle(), std::runtime_error);
  EXPECT_EQ(source.calls.back(), 1233U);
}

TEST(PlanningThread, EndsWithoutTakingWhatWaits) {
  SourceStandIn source;
  {
    PlanningThread beside(source);
    for (std::uint32_t line = 1; line <= 5000; ++line) beside.take(motion_of(line));
  }
  EXPECT_LT(source.calls.size(), calls_from_one_thread(5000).size());
}

/// A run, and what there is to see of it.
struct Outcome {
  machine::RunStatus status;
  double time_s;
  std::string clocks;
  base::MachinePoint position;

  friend bool operator==(const Outcome&, const Outcome&) = default;
};

Outcome run(const std::string& program, bool on_one_thread, const machine::Budget& budget = {}) {
  const machine::MachineDefinition definition = *machine::find_machine("mill3");
  BatchRun machine(definition, control::Memory(definition.parameters.n_offsets),
                   {.on_one_thread = on_one_thread});
  std::string printed;
  machine.set_print_output([&](std::string_view text) { printed += text; });
  machine.load(base::SourceFile::from_text("part.nc", program));
  const auto status = machine.run_to_end(budget);
  return {status, machine.time_s(), printed, machine.position()};
}

// Arcs and lines of many lengths and directions; the clock is read now and then.
constexpr const char* kWanderer =
    "O1\nG90F2000.\n#1=0\n#3001=0\nPOPEN\nWHILE[#1LT20000]DO1\n#1=#1+1\n"
    "G01X[100.*SIN[#1*7.3]]Y[50.*COS[#1*3.1]]Z[10.*SIN[#1]-20.]\nIF[[#1MOD977]NE0]GOTO5\n"
    "DPRNT[#3001[71]]\nG04X0.1\nN5END1\nPCLOS\nM30\n";

TEST(PlanningThread, ARunIsTheSameWithOneThreadAndTwo) {
  const Outcome alone = run(kWanderer, true);
  EXPECT_EQ(alone.status, machine::RunStatus::end);
  EXPECT_GT(alone.clocks.size(), 100U);
  EXPECT_EQ(run(kWanderer, false), alone);
}

TEST(PlanningThread, ABudgetEndsTheRunAtTheSamePlace) {
  const machine::Budget budget{.motions = 12'345};
  const Outcome alone = run(kWanderer, true, budget);
  EXPECT_EQ(alone.status, machine::RunStatus::budget);
  EXPECT_EQ(run(kWanderer, false, budget), alone);
}

TEST(PlanningThread, AnAlarmOfTheProgramComesAtTheSameTime) {
  const std::string program =
      "O1\nG90F2000.\n#1=0\nWHILE[#1LT20000]DO1\n#1=#1+1\nG01X[#1*0.01]Y[#1MOD7]\n"
      "IF[#1EQ15000]GOTO9\nEND1\nN9G01X1.Y1.Q\nM30\n";
  const Outcome alone = run(program, true);
  EXPECT_EQ(alone.status, machine::RunStatus::alarm);
  EXPECT_GT(alone.time_s, 100);
  EXPECT_EQ(run(program, false), alone);
}

}  // namespace
}  // namespace kerf::test
