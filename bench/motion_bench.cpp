// Planner, interpolator and step pulses by themselves.
//
// The path is a raster over a wavy surface, as a CAM system writes it: 1,001 points a row, 0.1 mm
// apart, four decimals, rows 0.1 mm apart. Limits 500 mm/s, 2,000 mm/s², with jerk 50,000 mm/s³,
// tolerance 0.01 mm, period 1 ms. `Copy` is the measure of this machine: what it costs to write a
// set-point to memory.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "drive/pulse_counter.hpp"
#include "drive/step_generator.hpp"
#include "optimum.hpp"
#include "planner/interpolator.hpp"

namespace {

using kerf::base::TipPoint;
using kerf::motion::Motion;
using kerf::motion::Setpoint;
using kerf::planner::Interpolator;

constexpr double kNoJerkLimit = std::numeric_limits<double>::infinity();
constexpr std::size_t kSegments = 1'000'000;

kerf::motion::AxisSetup three_axes() {
  kerf::motion::AxisSetup axes;
  for (const char letter : {'X', 'Y', 'Z'}) axes.axes.push_back({.letter = letter});
  return axes;
}

kerf::planner::AxisLimits limits(double jerk) {
  kerf::planner::AxisLimits limits;
  for (std::size_t m = 0; m < kerf::base::kMaxAxes; ++m) {
    limits.velocity.values[m] = 500;
    limits.acceleration.values[m] = 2000;
    limits.jerk.values[m] = jerk;
  }
  return limits;
}

Motion line_to(const TipPoint& to, double feed_mm_min, std::size_t number) {
  Motion motion;
  motion.block.line = static_cast<std::uint32_t>(number + 1);
  motion.action = kerf::motion::Line{to, {feed_mm_min}};
  return motion;
}

TipPoint tip_at(double x, double y, double z) {
  return TipPoint(kerf::base::AxisVector{{x, y, z}});
}

TipPoint surface_point(std::size_t number) {
  constexpr std::size_t kRow = 1001;
  const std::size_t row = number / kRow;
  const std::size_t column = number % kRow;
  const double x = 0.1 * static_cast<double>(row % 2 == 0 ? column : kRow - 1 - column);
  const double y = 0.1 * static_cast<double>(row);
  const double z =
      2.5 * std::sin(0.12 * x) * std::cos(0.09 * y) + 1.5 * std::sin(0.05 * x + 0.07 * y);
  return tip_at(x, y, std::round(z * 1e4) / 1e4);
}

const std::vector<Motion>& surface(double feed_mm_min) {
  static std::vector<Motion> motions;
  motions.clear();
  for (std::size_t n = 0; n < kSegments; ++n)
    motions.push_back(line_to(surface_point(n), feed_mm_min, n));
  return motions;
}

template <typename Drain>
void drive(Interpolator& interpolator, const std::vector<Motion>& motions, Drain&& drain) {
  for (const Motion& motion : motions) {
    if (!interpolator.room()) drain();
    interpolator.take(motion);
  }
  if (!interpolator.room()) drain();
  interpolator.finish();
  drain();
}

// Hands each set-point of the motions to `take`.
template <typename Take>
void interpolate(Interpolator& interpolator, const std::vector<Motion>& motions, Take&& take) {
  Setpoint point;
  drive(interpolator, motions, [&] {
    while (interpolator.next(point)) take(point);
  });
}

// How many set-points the motions have.
std::int64_t count_points(Interpolator& interpolator, const std::vector<Motion>& motions) {
  std::int64_t points = 0;
  interpolate(interpolator, motions, [&](Setpoint& point) {
    benchmark::DoNotOptimize(point);
    ++points;
  });
  return points;
}

// Arguments: feed in mm/min, jerk in mm/s³ or 0 for none.
double jerk_of(const benchmark::State& state) {
  return state.range(1) == 0 ? kNoJerkLimit : static_cast<double>(state.range(1));
}

void Plan(benchmark::State& state) {
  const auto& motions = surface(static_cast<double>(state.range(0)));
  double time_s = 0;
  for (auto _ : state) {
    Interpolator interpolator(three_axes(), limits(jerk_of(state)), {});
    drive(interpolator, motions, [&] { interpolator.skip(); });
    time_s = interpolator.time_s();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kSegments));
  state.counters["motion_s"] = time_s;
}
BENCHMARK(Plan)
    ->Args({3000, 0})
    ->Args({12000, 0})
    ->Args({3000, 50000})
    ->Args({12000, 50000})
    ->Unit(benchmark::kMillisecond);

// Not a matter of this machine: the planned time of some rows beside the best possible one.
void Optimum(benchmark::State& state) {
  constexpr std::size_t kPoints = 8 * 1001;
  auto motions = surface(static_cast<double>(state.range(0)));
  motions.resize(kPoints);
  double time_s = 0;
  double best_s = 0;
  for (auto _ : state) {
    Interpolator interpolator(three_axes(), limits(kNoJerkLimit), {});
    drive(interpolator, motions, [&] { interpolator.skip(); });
    time_s = interpolator.time_s();
    best_s = kerf::bench::optimal_time_s(three_axes(), limits(kNoJerkLimit), {}, motions);
  }
  state.counters["motion_s"] = time_s;
  state.counters["best_s"] = best_s;
  state.counters["ratio"] = time_s / best_s;
}
BENCHMARK(Optimum)->Args({3000})->Args({12000})->Iterations(1)->Unit(benchmark::kMillisecond);

void PlanAndInterpolate(benchmark::State& state) {
  const auto& motions = surface(static_cast<double>(state.range(0)));
  std::int64_t points = 0;
  for (auto _ : state) {
    Interpolator interpolator(three_axes(), limits(jerk_of(state)), {});
    points += count_points(interpolator, motions);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kSegments));
  state.counters["points_per_s"] =
      benchmark::Counter(static_cast<double>(points), benchmark::Counter::kIsRate);
}
BENCHMARK(PlanAndInterpolate)
    ->Args({3000, 0})
    ->Args({12000, 0})
    ->Args({3000, 50000})
    ->Args({12000, 50000})
    ->Unit(benchmark::kMillisecond);

// Set-points of moves of a metre at 1 m/min.
void LongMoves(benchmark::State& state) {
  std::vector<Motion> motions;
  for (std::size_t n = 0; n < 20; ++n)
    motions.push_back(line_to(tip_at(n % 2 == 0 ? 1000 : 0, n % 2 == 0 ? 700 : 0, 0), 1000, n));
  std::int64_t points = 0;
  for (auto _ : state) {
    Interpolator interpolator(three_axes(), limits(jerk_of(state)), {});
    points += count_points(interpolator, motions);
  }
  state.SetItemsProcessed(points);
}
BENCHMARK(LongMoves)->Args({0, 0})->Args({0, 50000})->Unit(benchmark::kMillisecond);

void Copy(benchmark::State& state) {
  std::vector<Setpoint> points(1 << 16);
  Setpoint point;
  for (auto _ : state) {
    for (Setpoint& p : points) {
      benchmark::DoNotOptimize(point);
      p = point;
    }
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}
BENCHMARK(Copy);

// Three axes at 100 steps/mm along the surface at 12 m/min, then counted.
void StepPulses(benchmark::State& state) {
  const auto& motions = surface(12000);
  std::vector<kerf::drive::StepAxis> axes(3);
  for (auto& axis : axes) axis.steps_per_unit = static_cast<double>(state.range(0));
  std::vector<kerf::drive::JointMoment> points;
  Interpolator interpolator(three_axes(), limits(kNoJerkLimit), {});
  interpolate(interpolator, motions, [&](const Setpoint& point) {
    points.push_back({point.time_s, kerf::base::JointPoint(point.tip.numbers())});
  });
  struct Counter : kerf::drive::PulseSink {
    std::int64_t pulses = 0;
    void take(const kerf::drive::Pulse& /*pulse*/) override { ++pulses; }
  } counter;
  for (auto _ : state) {
    kerf::drive::StepGenerator generator(
        axes, {.pulse_width_ns = 100, .pulse_gap_ns = 100, .direction_setup_ns = 100}, counter);
    for (const auto& p : points) {
      if (!generator.move_to(p)) state.SkipWithError("too fast");
    }
  }
  state.SetItemsProcessed(counter.pulses);
}
BENCHMARK(StepPulses)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
