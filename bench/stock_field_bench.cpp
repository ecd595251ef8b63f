// A ball of 6 mm over the wavy surface of bench/programs.py: 10⁶ moves of about 0.1 mm in a box of
// 100 × 100 × 14 mm, cells of 0.1 and 0.05 mm. `Stamp` is the measure of this machine: at the end
// of each move the ball's heights, worked out beforehand, go into a plain array of heights. It
// knows neither sweeps nor what it removed.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "math/math.hpp"
#include "stock/field/height_field.hpp"

namespace {

using namespace kerf::stock;

constexpr int kMoves = 1'000'000;
constexpr int kColumns = 1001;
constexpr double kStep_mm = 0.1;
constexpr double kSize_mm = 100;
constexpr double kRadius_mm = 3;
const Bounds kBox{{0, 0, -14}, {kSize_mm, kSize_mm, 0}};

double surface(double x, double y) {
  return -5.6 + 2.5 * kerf::math::sin(x * 0.12) * kerf::math::cos(y * 0.09) +
         1.5 * kerf::math::sin(x * 0.05 + y * 0.07);
}

std::vector<Vec3> raster() {
  std::vector<Vec3> points;
  for (int i = 0; i <= kMoves; ++i) {
    const int row = i / kColumns;
    const int column = row % 2 == 0 ? i % kColumns : kColumns - 1 - i % kColumns;
    const double x = column * kStep_mm;
    const double y = row * kStep_mm;
    points.push_back({x, y, surface(x, y)});
  }
  return points;
}

const std::vector<Vec3>& points() {
  static const std::vector<Vec3> all = raster();
  return all;
}

Body ball() {
  const double r = kRadius_mm;
  return {.profile = Profile({{{0, 0}, {r, r}, std::sqrt(2.0) - 1}, {{r, r}, {r, 20}}})};
}

void Stamp(benchmark::State& state) {
  const double cell = static_cast<double>(state.range(0)) / 1000;
  const int n = static_cast<int>(std::lround(kSize_mm / cell));
  const int half = static_cast<int>(kRadius_mm / cell);
  const int side = 2 * half + 1;
  std::vector<float> stamp;
  for (int i = 0; i < side * side; ++i) {
    const double s = cell * std::hypot(i % side - half, i / side - half);
    stamp.push_back(s <= kRadius_mm ? static_cast<float>(kRadius_mm -
                                                         std::sqrt(kRadius_mm * kRadius_mm - s * s))
                                    : 1e6F);
  }
  for (auto _ : state) {
    std::vector<float> heights(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
    for (const Vec3& at : points()) {
      const int i0 = static_cast<int>(at.x / cell) - half;
      const int j0 = static_cast<int>(at.y / cell) - half;
      const int from = std::max(0, -i0);
      const int to = std::min(side, n - i0);
      for (int j = std::max(0, -j0); j < std::min(side, n - j0); ++j) {
        float* row = heights.data() + (j0 + j) * n + i0;
        const float* shape = stamp.data() + j * side;
        const float z = static_cast<float>(at.z);
        for (int i = from; i < to; ++i) row[i] = std::min(row[i], z + shape[i]);
      }
    }
    benchmark::DoNotOptimize(heights.data());
  }
}

void Cut(benchmark::State& state) {
  const double cell = static_cast<double>(state.range(0)) / 1000;
  const auto jobs = static_cast<unsigned>(state.range(1));
  double visited = 0;
  double bytes = 0;
  for (auto _ : state) {
    field::HeightField field(field::grid_of(kBox, cell), jobs);
    const BodyId body = field.add_body(ball());
    std::vector<Sweep> sweeps;
    std::vector<Outcome> outcomes;
    for (std::size_t i = 1; i < points().size(); ++i) {
      sweeps.push_back({.way = StraightWay{points()[i - 1], points()[i]}, .body = body});
      sweeps.back().motion = static_cast<std::uint32_t>(i);
      if (sweeps.size() < 4096 && i + 1 < points().size()) continue;
      outcomes.assign(sweeps.size(), {});
      field.cut(sweeps, outcomes);
      for (const Outcome& outcome : outcomes) visited += static_cast<double>(outcome.visited);
      sweeps.clear();
    }
    bytes = static_cast<double>(field.bytes());
  }
  const double footprint =
      (3.14159265 * kRadius_mm * kRadius_mm + 2 * kRadius_mm * kStep_mm) / (cell * cell);
  state.counters["visited_%"] =
      100 * visited / static_cast<double>(state.iterations()) / kMoves / footprint;
  state.counters["MiB"] = bytes / 1048576;
}

BENCHMARK(Stamp)->Arg(100)->Arg(50)->Unit(benchmark::kMillisecond);
BENCHMARK(Cut)
    ->ArgNames({"um", "jobs"})
    ->ArgsProduct({{100, 50}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
