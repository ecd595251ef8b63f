// Offsets of contours with many vertices, beside Clipper's of the same shape: what a person would
// take otherwise. Clipper knows no arcs, so it gets chords that leave them by 1 µm, and makes such
// arcs.

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <polyclipping/clipper.hpp>

#include "geometry/contour/offset.hpp"

namespace {

using namespace kerf::contour;

constexpr double kPerMm = 1e6;
constexpr double kChord_mm = 1e-3;
constexpr double kSpacing_mm = 2;
constexpr double kInwards_mm = -0.5;

/// A wavy ring, every second edge an arc; `amplitude` in parts of the radius. With more turns than
/// one it crosses itself.
Contour ring(std::int64_t vertices, int turns) {
  const double radius =
      kSpacing_mm * static_cast<double>(vertices) / (2 * std::numbers::pi * turns);
  Contour contour;
  contour.vertices.reserve(static_cast<std::size_t>(vertices));
  for (std::int64_t i = 0; i < vertices; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(vertices);
    const double angle = 2 * std::numbers::pi * turns * share;
    const double wave =
        radius * (1 + 0.1 * std::sin(2 * std::numbers::pi * (turns == 1 ? 12 : 1) * share)) +
        0.4 * std::sin(static_cast<double>(i) * 1.7);
    contour.vertices.push_back(
        {{wave * std::cos(angle), wave * std::sin(angle)}, i % 2 == 0 ? 0.3 : 0, 0});
  }
  return contour;
}

ClipperLib::Path flat(const Contour& contour) {
  ClipperLib::Path path;
  for (std::size_t i = 0; i < edge_count(contour); ++i) {
    const Edge edge = edge_of(contour, i);
    int parts = 1;
    if (edge.bulge != 0) {
      const double step = 2 * std::acos(1 - std::min(1.0, kChord_mm / radius(edge)));
      parts = std::max(1, static_cast<int>(std::ceil(std::fabs(sweep_rad(edge)) / step)));
    }
    for (int k = 0; k < parts; ++k) {
      const Vec2 point = point_at(edge, static_cast<double>(k) / parts);
      path.emplace_back(std::llround(point.u * kPerMm), std::llround(point.v * kPerMm));
    }
  }
  return path;
}

void Offset(benchmark::State& state) {
  const Region shape = region_of(ring(state.range(0), static_cast<int>(state.range(1))));
  std::size_t vertices = 0;
  for (auto _ : state) vertices = vertex_count(offset(shape, kInwards_mm));
  state.counters["vertices"] = static_cast<double>(vertices);
}

/// The input is not simple yet: what region_of() does is part of it.
void RegionAndOffset(benchmark::State& state) {
  const Contour contour = ring(state.range(0), static_cast<int>(state.range(1)));
  for (auto _ : state) benchmark::DoNotOptimize(offset(region_of(contour), kInwards_mm));
}

void ClipperOffset(benchmark::State& state) {
  const ClipperLib::Path path = flat(ring(state.range(0), static_cast<int>(state.range(1))));
  std::size_t vertices = 0;
  for (auto _ : state) {
    ClipperLib::Paths simple{path};
    if (state.range(1) > 1) ClipperLib::SimplifyPolygons(simple, ClipperLib::pftNonZero);
    ClipperLib::ClipperOffset offsetter(2, kChord_mm * kPerMm);
    offsetter.AddPaths(simple, ClipperLib::jtRound, ClipperLib::etClosedPolygon);
    ClipperLib::Paths result;
    offsetter.Execute(result, kInwards_mm * kPerMm);
    vertices = 0;
    for (const ClipperLib::Path& each : result) vertices += each.size();
  }
  state.counters["vertices"] = static_cast<double>(vertices);
}

}  // namespace

BENCHMARK(Offset)
    ->ArgNames({"vertices", "turns"})
    ->Args({10'000, 1})
    ->Args({100'000, 1})
    ->Args({1'000'000, 1})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(RegionAndOffset)
    ->ArgNames({"vertices", "turns"})
    ->Args({100'000, 1})
    ->Args({100'000, 3})
    ->Unit(benchmark::kMillisecond);
// Its time grows with the square of the vertices: 10^5 take minutes, 10^6 would take hours.
BENCHMARK(ClipperOffset)
    ->ArgNames({"vertices", "turns"})
    ->Args({10'000, 1})
    ->Args({100'000, 1})
    ->Unit(benchmark::kMillisecond);
