// Stock of a lathe by itself: a bar of 100 x 200 mm, a wavy contour roughed and finished. Argument:
// moves a pass; 10000 moves in all, so the more in one pass the more edges the part has.
#include <benchmark/benchmark.h>

#include <vector>

#include "math/math.hpp"
#include "stock/turned/turned_part.hpp"

namespace {

using namespace kerf::stock;

constexpr std::size_t kMoves = 10'000;

/// Of the contour at the share `t` of its length, `deeper` mm inside of the first one.
Vec3 place(double t, double deeper) {
  const double rho = 47 - deeper + 2 * kerf::math::sin(40 * t) + kerf::math::cos(97 * t);
  return {rho, 0, 2 - 180 * t};
}

Insert insert() {
  Tool tool;
  tool.kind = ToolKind::turning;
  tool.insert = "VNMG160408";
  tool.measures.set(Measure::tip, 3);
  return insert_of(tool);
}

/// Passes of so many moves at feed, each begun and ended with rapids, each deeper than the last.
std::vector<Sweep> job(BodyId body, std::size_t moves) {
  std::vector<Sweep> sweeps;
  Vec3 at{60, 0, 5};
  const auto go = [&](Vec3 to, SweepKind kind) {
    sweeps.push_back({.way = StraightWay{at, to},
                      .body = body,
                      .kind = kind,
                      .motion = static_cast<std::uint32_t>(sweeps.size() + 1)});
    at = to;
  };
  const std::size_t passes = kMoves / moves;
  for (std::size_t pass = 0; pass < passes; ++pass) {
    const double deeper = 30.0 * static_cast<double>(pass) / static_cast<double>(passes);
    go(place(0, deeper), SweepKind::rapid);
    for (std::size_t i = 1; i <= moves; ++i)
      go(place(static_cast<double>(i) / static_cast<double>(moves), deeper), SweepKind::cut);
    go({at.x + 1, 0, at.z}, SweepKind::cut);
    go({60, 0, at.z}, SweepKind::rapid);
    go({60, 0, 5}, SweepKind::rapid);
  }
  return sweeps;
}

void stock_turned(benchmark::State& state) {
  for (auto _ : state) {
    turned::TurnedPart part(turned::bar(100, -200, 0));
    Body body;
    body.insert = insert();
    const std::vector<Sweep> sweeps =
        job(part.add_body(body), static_cast<std::size_t>(state.range(0)));
    std::vector<Outcome> outcomes(sweeps.size());
    part.cut(sweeps, outcomes);
    state.counters["edges"] = static_cast<double>(kerf::contour::vertex_count(part.region()));
    state.counters["removed_mm3"] = part.stock_mm3() - part.left_mm3();
  }
}
BENCHMARK(stock_turned)->Arg(1)->Arg(20)->Arg(200)->Unit(benchmark::kMillisecond);

}  // namespace
