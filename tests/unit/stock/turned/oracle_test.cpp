// The turned bodies of stock.md §9, against closed formulas to 1e-9.
#include <gtest/gtest.h>

#include "stock/turned/turned_job.hpp"

namespace kerf::stock::turned {
namespace {

using std::numbers::pi;

constexpr double kRelative = 1e-9;

double disc(double rho, double length) { return pi * rho * rho * length; }
double ring(double outer, double inner, double length) {
  return disc(outer, length) - disc(inner, length);
}
double cone(double a, double b, double length) { return pi * length / 3 * (a * a + a * b + b * b); }
/// A quarter of a disc that turns about the axis, its centre at ρ, towards the axis from there.
double quarter_below(double rho, double r) {
  const double area = pi * r * r / 4;
  return 2 * pi * area * (rho - 4 * r / (3 * pi));
}

void expect_removed(Job& job, double formula, double of_spec) {
  EXPECT_NEAR(formula / of_spec, 1, 1e-8);
  EXPECT_NEAR(job.removed() / formula, 1, kRelative) << job.removed() << " not " << formula;
  EXPECT_NEAR((job.part().stock_mm3() - job.part().left_mm3()) / formula, 1, kRelative);
  EXPECT_TRUE(job.met_nothing());
}

TEST(TurnedOracle, Cylinder) {
  Job job(50, -80, 0);
  job.with(turning(0));
  job.at(54, 2).rapid(40, 2).to(40, -60).to(52, -60).rapid(200, 100);
  expect_removed(job, ring(25, 20, 60), 42411.5008);
}

TEST(TurnedOracle, NoseLeavesItsRingInTheCorner) {
  Job job(50, -80, 0);
  job.with(turning(0.8));
  job.at(54, 2).rapid(40, 2).to(40, -60).to(52, -60).rapid(200, 100);
  expect_removed(job, ring(25, 20, 60) - ring(20.8, 20, 0.8) + quarter_below(20.8, 0.8),
                 42394.0873);
}

TEST(TurnedOracle, Taper) {
  Job job(50, -80, 0);
  job.with(turning(0));
  job.at(60, 2).rapid(30, 2).to(30, 0).to(50, -20).to(54, -20).rapid(200, 100);
  expect_removed(job, disc(25, 20) - cone(15, 25, 20), 13613.5682);
}

// What cutter compensation makes of it: the centre of the nose stays r away from the cone. The
// slope of ρ over z is -1/2; tip = centre - (r, r).
TEST(TurnedOracle, TaperWithNoseRoundTheContour) {
  Job job(50, -80, 0);
  job.with(turning(0.8));
  const auto x_of = [](double z) { return 2 * (15 - z / 2 + 0.8 * (std::sqrt(1.25) - 1.5)); };
  job.at(70, 10).rapid(x_of(3), 3).to(x_of(-23), -23).to(62, -23).rapid(200, 100);
  expect_removed(job, disc(25, 20) - cone(15, 25, 20), 13613.5682);
}

TEST(TurnedOracle, TaperOfANoseWithoutCompensation) {
  Job job(50, -80, 0);
  job.with(turning(0.8));
  job.at(60, 2).rapid(30, 2).to(30, 0).to(50, -10).to(54, -10).rapid(200, 100);
  const double at_front = 15 + 2 * 0.8 - 0.8 * std::sqrt(2.0);
  expect_removed(job, disc(25, 25 - at_front) - cone(at_front, 25, 25 - at_front), 6228.34413);
}

TEST(TurnedOracle, Sphere) {
  Job job(40, -60, 0);
  job.with(turning(0)).at(44, 2).rapid(0, 2).to(0, 0);
  job.turn(0, -20, pi / 2).to(40, -21).to(44, -21).rapid(200, 100);
  expect_removed(job, disc(20, 20) - 2 * pi / 3 * 8000, 8377.58041);
}

TEST(TurnedOracle, SphereWithNoseRoundTheContour) {
  Job job(40, -60, 0);
  job.with(turning(0.8)).at(44, 4).rapid(-1.6 - 4, 0).to(-1.6, 0);
  job.turn(-1.6, -20.8, pi / 2).to(40, -30).to(46, -30);
  expect_removed(job, disc(20, 20) - 2 * pi / 3 * 8000, 8377.58041);
}

TEST(TurnedOracle, Fillet) {
  Job job(50, -80, 0);
  job.with(turning(0));
  job.at(54, 2).rapid(40, 2).to(40, -20).turn(50, -20, -pi / 2).to(54, -25).rapid(200, 100);
  expect_removed(job, ring(25, 20, 20) + quarter_below(25, 5), 16959.6189);
}

TEST(TurnedOracle, Groove) {
  Job job(50, -80, 0);
  job.with(blade(3));
  job.at(54, -40).to(34, -40).rapid(54, -40).rapid(200, 100);
  expect_removed(job, ring(25, 17, 3), 3166.72539);
}

TEST(TurnedOracle, Drill) {
  Job job(50, -80, 0);
  job.with(drill(10));
  job.at(0, 5).to(0, -25).rapid(0, 5).rapid(200, 100);
  const double point = 5 / std::tan(59 * pi / 180);
  expect_removed(job, disc(5, 25 - point) + disc(5, point) / 3, 1806.19047);
}

TEST(TurnedOracle, Parting) {
  Job job(50, -80, 0);
  job.with(blade(3));
  job.at(54, -40).to(0, -40).rapid(54, -40).rapid(200, 100);
  expect_removed(job, disc(25, 3), 5890.48623);
  const auto pieces = job.part().pieces();
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_NEAR(pieces[0].volume_mm3, disc(25, 40), 1e-4);
  EXPECT_TRUE(pieces[0].held);
  EXPECT_NEAR(pieces[1].volume_mm3 / disc(25, 37), 1, kRelative);
  EXPECT_FALSE(pieces[1].held);
  EXPECT_NEAR(pieces[1].extents.low.z, -37, 1e-9);
}

}  // namespace
}  // namespace kerf::stock::turned
