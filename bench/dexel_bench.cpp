// Stock as dexels, by itself: a million moves of 0.1 mm with a ball of 6 mm over the wavy surface
// of bench/programs.py, out of a box of 100 x 100 x 14 mm. Arguments: cell in micrometres, threads.
#include <benchmark/benchmark.h>

#include <vector>

#include "math/math.hpp"
#include "stock/dexel/tri_dexel.hpp"

namespace {

using namespace kerf::stock;
using namespace kerf::stock::dexel;

constexpr std::size_t kMoves = 50000;
constexpr std::size_t kAtOnce = 10'000;

Vec3 surface_point(std::size_t number) {
  constexpr std::size_t kRow = 1001;
  const std::size_t row = number / kRow;
  const std::size_t column = number % kRow;
  const double x = 0.1 * static_cast<double>(row % 2 == 0 ? column : kRow - 1 - column);
  const double y = 0.1 * static_cast<double>(row);
  const double z = -5.6 + 2.5 * kerf::math::sin(x * 0.12) * kerf::math::cos(y * 0.09) +
                   1.5 * kerf::math::sin(x * 0.05 + y * 0.07);
  return {x, y, z};
}

Body ball(double radius) {
  constexpr double kQuarter = 0.41421356237309503;  // tan(pi / 8)
  const ProfilePoint equator{radius, radius};
  return {Profile({{{0, 0}, equator, kQuarter}, {equator, {radius, Profile::kEndless_mm}}})};
}

std::vector<Sweep> moves(BodyId body, std::size_t first, std::size_t count) {
  std::vector<Sweep> sweeps;
  for (std::size_t i = first; i < first + count; ++i) {
    sweeps.push_back({StraightWay{surface_point(i), surface_point(i + 1)},
                      {0, 0, 1},
                      body,
                      SweepKind::cut,
                      static_cast<std::uint32_t>(i + 1)});
  }
  return sweeps;
}

void stock_dexel(benchmark::State& state) {
  const double cell = static_cast<double>(state.range(0)) / 1000;
  double visited = 0;
  for (auto _ : state) {
    TriDexel model(box_shape({{0, 0, -14}, {100, 100, 0}}), cell,
                   static_cast<unsigned>(state.range(1)));
    const BodyId body = model.add_body(ball(3));
    for (std::size_t i = 0; i < kMoves; i += kAtOnce) {
      const std::vector<Sweep> sweeps = moves(body, i, kAtOnce);
      std::vector<Outcome> outcomes(sweeps.size());
      model.cut(sweeps, outcomes);
      for (const Outcome& each : outcomes) visited += static_cast<double>(each.visited);
    }
    state.counters["MiB"] = static_cast<double>(model.bytes()) / (1 << 20);
    state.counters["removed_mm3"] = model.stock_mm3() - model.left_mm3();
  }
  state.counters["visited_a_move"] = visited / static_cast<double>(kMoves);
  state.counters["moves"] = benchmark::Counter(static_cast<double>(kMoves),
                                               benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(stock_dexel)
    ->Args({500, 2})
    ->Args({200, 1})
    ->Args({200, 2})
    ->Args({100, 2})
    ->Iterations(1)
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
