// The bodies of stock.md §9 that a height field can hold, against closed formulas.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "stock/field/field_jobs.hpp"

namespace kerf::stock::field {
namespace {

using std::numbers::pi;

/// stock.md §9: 5 % times h in mm.
double allowed(double cell) { return 0.05 * cell; }

void expect_removed(Job& job, double wanted, double relative) {
  const double removed = job.removed();
  EXPECT_NEAR(removed / wanted, 1, relative) << removed << " instead of " << wanted;
  EXPECT_NEAR(job.field().stock_mm3() - job.field().left_mm3(), removed, wanted * 1e-6);
  EXPECT_TRUE(job.met_nothing());
}

class Oracle : public testing::TestWithParam<double> {
 protected:
  [[nodiscard]] double cell() const { return GetParam(); }
  [[nodiscard]] double tolerance() const { return allowed(cell()); }
};

TEST_P(Oracle, Slot) {
  Job job({{0, 0, -20}, {70, 40, 0}}, cell(), flat(10));
  job.at({10, 20, 5}).to({10, 20, -5}).to({60, 20, -5});
  expect_removed(job, 2892.69908, tolerance());
}

TEST_P(Oracle, Pocket) {
  Job job({{0, 0, -20}, {60, 50, 0}}, cell(), flat(8));
  job.at({10, 10, 5}).to({10, 10, -6});
  for (int row = 0; row <= 10; ++row) {
    const double y = 10 + 3.0 * row;
    const double x = row % 2 == 0 ? 50 : 10;
    job.to({60 - x, y, -6}).to({x, y, -6});
  }
  expect_removed(job, 10861.5929, tolerance());
}

TEST_P(Oracle, Island) {
  Job job({{-20, -20, -20}, {20, 20, 0}}, cell(), flat(6));
  job.at({10, 0, 5}).to({10, 0, -4}).turn({0, 0, -4}, 2 * pi);
  expect_removed(job, 1507.96447, tolerance());
}

TEST_P(Oracle, Helix) {
  Job job({{-20, -20, -20}, {20, 20, 0}}, cell(), flat(10));
  job.at({3, 0, 5}).to({3, 0, 0});
  for (int turn = 0; turn < 3; ++turn) job.turn({0, 0, -2.0 * turn}, 2 * pi, -2);
  job.turn({0, 0, -6}, 2 * pi);
  expect_removed(job, 1206.37158, tolerance());
}

TEST_P(Oracle, BallShallow) {
  Job job({{0, 0, -20}, {60, 40, 0}}, cell(), ball(6));
  job.at({10, 20, 5}).to({10, 20, -2}).to({50, 20, -2});
  expect_removed(job, 359.329837, tolerance());
}

TEST_P(Oracle, BallDeep) {
  Job job({{0, 0, -20}, {60, 40, 0}}, cell(), ball(6));
  job.at({10, 20, 5}).to({10, 20, -5}).to({50, 20, -5});
  expect_removed(job, 1158.58401, tolerance());
}

TEST_P(Oracle, Bull) {
  Job job({{0, 0, -20}, {60, 40, 0}}, cell(), bull(10, 2));
  job.at({10, 20, 5}).to({10, 20, -3}).to({50, 20, -3});
  expect_removed(job, 1342.38868, tolerance());
}

TEST_P(Oracle, VGroove) {
  Job job({{0, 0, -20}, {60, 40, 0}}, cell(), cone(6, 60, 0.2));
  job.at({10, 20, 5}).to({10, 20, -1.5}).to({40, 20, -1.5});
  expect_removed(job, 49.6044692, cell() * 0.1);
}

TEST_P(Oracle, Drill) {
  Job job({{0, 0, -30}, {60, 40, 0}}, cell(), cone(10, 118, 0));
  job.at({30, 20, 2}).to({30, 20, -20});
  expect_removed(job, 1413.49138, tolerance());
}

TEST_P(Oracle, DrillThrough) {
  Job job({{0, 0, -20}, {60, 40, 0}}, cell(), cone(10, 118, 0));
  job.at({30, 20, 2}).to({30, 20, -26});
  expect_removed(job, 1570.79633, tolerance());
}

TEST_P(Oracle, Chamfer) {
  Job job({{0, 0, -20}, {50, 30, 0}}, cell(), cone(12, 90, 0));
  job.at({-10, 0, -2}).to({50, 0, -2}).to({50, 30, -2}).to({0, 30, -2}).to({0, -10, -2});
  expect_removed(job, 309.333333, tolerance());
}

TEST_P(Oracle, FacingIsExact) {
  Job job({{0, 0, -20}, {80, 50, 0}}, cell(), flat(40));
  job.at({-30, 10, -1.5}).to({110, 10, -1.5}).to({110, 40, -1.5}).to({-30, 40, -1.5});
  expect_removed(job, 6000, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Cells, Oracle, testing::Values(0.1, 0.25));

}  // namespace
}  // namespace kerf::stock::field
