// What is made again for somebody who looks back or ahead has a limit, and the machine none by it.
#include "base/work_limit.hpp"
#include "bench.hpp"

namespace kerf::test {
namespace {

using base::WorkLimit;

void expect_too_long(const base::Outcome<std::shared_ptr<const machine::Snapshot>>& then) {
  ASSERT_FALSE(then);
  EXPECT_NE(then.error().message.find("takes longer"), std::string::npos) << then.error().message;
}

constexpr const char* kEndless = "O1\nG91\nN1G01X1.F6000\nX-1.\nGOTO1\n";

TEST(ALimit, EndsAnInstantThatIsNeverReached) {
  Bench bench;
  bench.load(kEndless);
  bench->set_limit(WorkLimit(0.2));
  expect_too_long(bench->state_at(1e9));
  bench->set_limit({});
  const auto then = bench->state_at(1e-3);
  ASSERT_TRUE(then);
  EXPECT_GT((*then)->machine.values[0], 0);
}

TEST(ALimit, ThatIsStoppedEndsAtOnce) {
  std::stop_source unwanted;
  unwanted.request_stop();
  Bench bench;
  bench.load(kEndless);
  bench->set_limit(WorkLimit(0, unwanted.get_token()));
  expect_too_long(bench->state_at(1e9));
  bench.load("O1\nN1#1=#1+1\nGOTO1\nM00\n");
  EXPECT_REFUSED(bench->perform(StartAt{4}), "was not reached");
}

TEST(ALimit, LeavesARunThatCouldNotBeMadeAgainAsItIs) {
  Bench bench;
  bench.start(kEndless, 0.15);
  EXPECT_DONE(bench->perform(FeedHold{}));
  for (int i = 0; i < 100 && bench.status() != Status::held; ++i) bench->advance(0.05);
  bench->perform(Reset{});
  bench.settle();
  const double x = bench.x();
  std::stop_source unwanted;
  unwanted.request_stop();
  bench->set_limit(WorkLimit(0, unwanted.get_token()));
  EXPECT_FALSE(bench->perform(StepBack{}));
  bench->set_limit({});
  EXPECT_EQ(bench.x(), x);
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(0.1);
  EXPECT_EQ(bench.status(), Status::running);
}

// Slices of points between two looks at the limit are cuts of time like any others.
TEST(ALimit, ThatIsNotReachedChangesNothing) {
  const auto state = [](const WorkLimit& limit) {
    Bench bench;
    bench.load("O1\nG91\n#1=0\nWHILE[#1LT2000]DO1\nG01X1.F6000\nX-1.\n#1=#1+1\nEND1\nM30\n");
    bench->set_limit(limit);
    const auto then = bench->state_at(123.4567);
    EXPECT_TRUE(then);
    return then ? std::pair{(*then)->machine, (*then)->time_s}
                : std::pair<base::AxisVector, double>{};
  };
  EXPECT_EQ(state({}), state(WorkLimit(1000)));
}

}  // namespace
}  // namespace kerf::test
