// From motions and set-points to traces and burns.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "stock/sheet/beam_energy.hpp"
#include "stock/sheet/beam_tracer.hpp"

namespace kerf::stock::sheet {
namespace {

using base::TipPoint;
using motion::Motion;
using std::numbers::pi;

motion::AxisSetup axes_of(const std::string& letters) {
  motion::AxisSetup axes;
  for (const char letter : letters) {
    axes.axes.push_back({.letter = letter});
    axes.axes.back().rotary = letter == 'A' || letter == 'C';
  }
  axes.beam = true;
  return axes;
}

TipPoint tip(double x, double y, double a = 0) { return TipPoint(base::AxisVector{{x, y, 0, a}}); }

/// A run's motions, and the ways of the beam that they make.
class Beam {
 public:
  explicit Beam(const std::string& letters = "XYZ", Vec3 zero = {})
      : axes_(axes_of(letters)),
        frame_(axes_, {}),
        tracer_(axes_, frame_, 0.001,
                [this](const Trace& trace, const Motion&) { traces_.push_back(trace); }) {
    frame_.set_zero(zero);
  }

  Beam& act(const Motion::Action& action) {
    Motion motion;
    motion.action = action;
    tracer_.take(motion);
    return *this;
  }
  Beam& power(double percent) { return act(motion::Power{.percent = percent}); }
  Beam& rapid(double x, double y) { return act(motion::Rapid{tip(x, y)}); }
  Beam& line(double x, double y, double a = 0) { return act(motion::Line{tip(x, y, a), {1000}}); }
  Beam& arc(double x, double y, double cx, double cy, motion::Plane plane = motion::Plane::xy) {
    return act(motion::Arc{.to = tip(x, y), .center = {cx, cy}, .feed = {1000}, .plane = plane});
  }

  [[nodiscard]] const std::vector<Trace>& traces() const { return traces_; }
  [[nodiscard]] const BeamTracer& tracer() const { return tracer_; }

 private:
  motion::AxisSetup axes_;
  WorkFrame frame_;
  std::vector<Trace> traces_;
  BeamTracer tracer_;
};

TEST(BeamTracer, CutsWhileThereIsPower) {
  Beam beam;
  beam.rapid(5, 5).line(6, 5).power(80).line(10, 5).power(0).line(20, 5).power(30).line(20, 9);
  ASSERT_EQ(beam.traces().size(), 2U);
  EXPECT_EQ(beam.traces()[0], straight({6, 5}, {10, 5}));
  EXPECT_EQ(beam.traces()[1], straight({20, 5}, {20, 9}));
  EXPECT_EQ(beam.tracer().cut_mm(), 8);
}

TEST(BeamTracer, PowerThatIsSetAndNotOnCutsNothing) {
  Beam beam;
  beam.act(motion::Power{.percent = 50, .on = false}).line(10, 5);
  EXPECT_FALSE(beam.tracer().has_cut());
}

TEST(BeamTracer, SeesThePartFromItsZero) {
  Beam beam("XYZ", {100, 50, 0});
  beam.rapid(110, 50).power(10).line(110, 60);
  ASSERT_EQ(beam.traces().size(), 1U);
  EXPECT_EQ(beam.traces()[0], straight({10, 0}, {10, 10}));
}

TEST(BeamTracer, ADwellWithPowerBurnsAPlace) {
  Beam beam;
  beam.rapid(3, 4).power(50).act(motion::Dwell{.seconds = 0.5});
  ASSERT_EQ(beam.traces().size(), 1U);
  EXPECT_EQ(beam.traces()[0], straight({3, 4}, {3, 4}));
  EXPECT_EQ(beam.tracer().cut_mm(), 0);
  beam.act(motion::Power{.percent = 50, .follows_speed = true});
  beam.act(motion::Dwell{.seconds = 0.5});
  EXPECT_EQ(beam.traces().size(), 1U);
}

TEST(BeamTracer, ArcsStayArcs) {
  Beam beam;
  beam.rapid(10, 0).power(50).arc(10, 0, 0, 0).arc(0, 10, 0, 0);
  ASSERT_EQ(beam.traces().size(), 2U);
  EXPECT_EQ(beam.traces()[0].radius, 10);
  EXPECT_NEAR(length(beam.traces()[0]), 20 * pi, 1e-9);
  EXPECT_NEAR(length(beam.traces()[1]), 5 * pi, 1e-9);
  EXPECT_NEAR(distance(beam.traces()[1], {8, 8}), std::hypot(8, 8) - 10, 1e-9);
  EXPECT_NEAR(distance(beam.traces()[1], {0, -10}), std::hypot(10, 10), 1e-9);
}

TEST(BeamTracer, AnArcThatStandsUprightIsALineFromAbove) {
  Beam beam;
  beam.rapid(10, 0).power(50);
  beam.act(motion::Arc{.to = tip(-10, 0),
                       .center = {0, 0},  // Z, X
                       .feed = {1000},
                       .plane = motion::Plane::zx});
  ASSERT_GT(beam.traces().size(), 10U);
  for (const Trace& trace : beam.traces()) {
    EXPECT_EQ(trace.radius, 0);
    EXPECT_NEAR(trace.from.v, 0, 1e-12);
  }
  EXPECT_NEAR(beam.tracer().cut_mm(), 20, 1e-9);
}

TEST(BeamTracer, SaysWhereTheHeadTilts) {
  Beam flat("XYZA");
  flat.power(10).line(10, 0);
  EXPECT_FALSE(flat.tracer().is_tilted());
  flat.line(20, 0, 15);
  EXPECT_TRUE(flat.tracer().is_tilted());
}

TEST(Trace, SpiralsAndHelicesStayNearTheirWay) {
  const ArcWay spiral{.centre = {1, 2, 0},
                      .rise = {0, 0, -3},
                      .e1 = {0, 1, 0},
                      .e2 = {-1, 0, 0},
                      .radius = 5,
                      .radius_change = 0.1,
                      .angle_rad = 0.4,
                      .turn_rad = -3};
  const ArcWay tilted{.centre = {},
                      .rise = {},
                      .e1 = {1, 0, 0},
                      .e2 = {0, std::sqrt(0.5), std::sqrt(0.5)},
                      .radius = 5,
                      .angle_rad = 0.4,
                      .turn_rad = 4};
  for (const ArcWay& way : {spiral, tilted}) {
    std::vector<Trace> traces;
    add_traces(way, 0.001, traces);
    for (int n = 0; n <= 1000; ++n) {
      const Vec3 at = point_at(way, n / 1000.0);
      double nearest = 1e300;
      for (const Trace& trace : traces) nearest = std::min(nearest, distance(trace, {at.x, at.y}));
      EXPECT_LE(nearest, 0.001 + 1e-9);
    }
  }
}

TEST(Trace, ExtentsHoldEveryPointAndNoMore) {
  const Trace arc = round({0, 0}, 10, -pi / 4, pi / 2);
  EXPECT_NEAR(extents(arc).high.u, 10, 1e-12);
  EXPECT_NEAR(extents(arc).low.u, 10 * std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(extents(arc).high.v, 10 * std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(extents(round({0, 0}, 10, 0, 20)).low.v, -10, 1e-12);
}

motion::AxisPoint point(double time_s, double x, float percent) {
  motion::AxisPoint at;
  at.tip.time_s = time_s;
  at.tip.tip = tip(x, 0);
  at.power_percent = percent;
  return at;
}

TEST(BeamEnergy, IsThePowerOfEachPeriodOverItsWay) {
  const motion::AxisSetup axes = axes_of("XYZ");
  const WorkFrame frame(axes, {});
  std::vector<Burn> burns;
  BeamEnergy energy(frame, 60, [&](const Burn& burn) { burns.push_back(burn); });
  energy.start(point(1, 0, 0));
  energy.take(point(1.001, 0.1, 80));
  energy.take(point(1.002, 0.2, 0));
  energy.take(point(1.004, 0.2, 50));
  ASSERT_EQ(burns.size(), 2U);
  EXPECT_NEAR(burns[0].energy_j, 0.048, 1e-12);
  EXPECT_EQ(burns[0].to, (Vec2{0.1, 0}));
  EXPECT_EQ(burns[1].from, burns[1].to);
  EXPECT_NEAR(burns[1].energy_j, 0.06, 1e-12);
  EXPECT_NEAR(energy.energy_j(), 0.108, 1e-12);
}

}  // namespace
}  // namespace kerf::stock::sheet
