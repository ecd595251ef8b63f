// Sheets under a beam: 10⁶ moves of 0.2 mm round circles, kerf 0.1 mm, cells of a quarter of it.
// `Stamp` is the measure of this machine: a plain loop that stamps a disc every half cell of the
// way into one array as large as the sheet.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "stock/sheet/pieces.hpp"

namespace {

using namespace kerf::stock::sheet;

constexpr double kKerf = 0.1;
constexpr double kCell = kKerf / 4;
constexpr double kMove = 0.2;
constexpr std::size_t kMoves = 1'000'000;
constexpr double kSide = 300;

/// Circles side by side, as many as it takes, each of chords of 0.2 mm.
const std::vector<Trace>& moves() {
  static const std::vector<Trace> all = [] {
    std::vector<Trace> made;
    constexpr double kRadius = 12;
    constexpr int kAcross = 11;
    const auto chords = static_cast<int>(2 * std::numbers::pi * kRadius / kMove);
    for (int circle = 0; made.size() < kMoves; ++circle) {
      const Vec2 centre{15 + 27.0 * (circle % kAcross), 15 + 27.0 * (circle / kAcross % kAcross)};
      const double radius = kRadius - 0.013 * (circle / (kAcross * kAcross));
      const auto at = [&](int n) {
        const double angle = 2 * std::numbers::pi * n / chords;
        return centre + radius * Vec2{std::cos(angle), std::sin(angle)};
      };
      for (int n = 0; n < chords && made.size() < kMoves; ++n)
        made.push_back(straight(at(n), at(n + 1)));
    }
    return made;
  }();
  return all;
}

Grid grid() { return grid_of({{0, 0}, {kSide, kSide}}, kCell); }

void report(benchmark::State& state, const Sheet& sheet) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kMoves));
  state.counters["MiB"] = static_cast<double>(sheet.bytes()) / (1 << 20);
  state.counters["tiles"] = static_cast<double>(sheet.touched_tiles());
  state.counters["cut_mm2"] = sheet.cut_mm2();
}

void StockSheetCoverage(benchmark::State& state) {
  Sheet::Settings settings{.kerf_mm = kKerf};
  settings.jobs = static_cast<unsigned>(state.range(0));
  for (auto _ : state) {
    Sheet sheet(grid(), settings);
    sheet.cut(moves());
    report(state, sheet);
  }
}
BENCHMARK(StockSheetCoverage)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

void StockSheetCoverageAndEnergy(benchmark::State& state) {
  Sheet::Settings settings{.kerf_mm = kKerf, .spot_mm = kKerf};
  settings.jobs = static_cast<unsigned>(state.range(0));
  std::vector<Burn> burns;
  for (const Trace& trace : moves()) burns.push_back({trace.from, trace.to, 0.1});
  for (auto _ : state) {
    Sheet sheet(grid(), settings);
    sheet.cut(moves());
    sheet.burn(burns);
    report(state, sheet);
  }
}
BENCHMARK(StockSheetCoverageAndEnergy)
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void StockSheetPieces(benchmark::State& state) {
  Sheet sheet(grid(), {.kerf_mm = kKerf});
  sheet.cut(moves());
  for (auto _ : state) {
    const Pieces pieces = pieces_of(sheet);
    state.counters["pieces"] = static_cast<double>(pieces.count);
  }
}
BENCHMARK(StockSheetPieces)->Unit(benchmark::kMillisecond);

void Stamp(benchmark::State& state) {
  const Grid cells = grid();
  const int reach = static_cast<int>(std::ceil(kKerf / 2 / kCell));
  for (auto _ : state) {
    std::vector<unsigned char> sheet(static_cast<std::size_t>(cells.nx) *
                                     static_cast<std::size_t>(cells.ny));
    for (const Trace& move : moves()) {
      const double steps = std::ceil(length(move) / (kCell / 2));
      for (double s = 0; s <= steps; ++s) {
        const Vec2 at = move.from + (s / steps) * (move.to - move.from);
        const int i0 = static_cast<int>(at.u / kCell);
        const int j0 = static_cast<int>(at.v / kCell);
        for (int j = j0 - reach; j <= j0 + reach; ++j) {
          for (int i = i0 - reach; i <= i0 + reach; ++i) {
            const double u = cells.x(i) - at.u;
            const double v = cells.y(j) - at.v;
            if (u * u + v * v > kKerf * kKerf / 4) continue;
            sheet[static_cast<std::size_t>(j) * static_cast<std::size_t>(cells.nx) +
                  static_cast<std::size_t>(i)] = 255;
          }
        }
      }
    }
    benchmark::DoNotOptimize(sheet.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kMoves));
}
BENCHMARK(Stamp)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
