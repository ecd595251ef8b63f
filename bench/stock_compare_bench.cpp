// A wavy part of 100 × 100 × 14 mm with about 10⁶ ends, as a height field and as dexels, against a
// design of 10⁶ triangles that is 0.02 mm deeper: everything within tolerance, or everything
// beyond it. `Design` is what it takes to make the design ready to be asked.
#include <benchmark/benchmark.h>

#include <cmath>

#include "math/math.hpp"
#include "stock/compare/comparison.hpp"
#include "stock/compare/dexel_solid.hpp"
#include "stock/compare/field_solid.hpp"
#include "stock/compare/mesh_solid.hpp"
#include "stock/dexel/shape.hpp"

namespace {

using namespace kerf::stock;
using kerf::mesh::TriangleMesh;

constexpr double kSize_mm = 100;
constexpr double kBottom_mm = -14;
constexpr int kSide = 500;  // cells of two triangles along a side, above and below
constexpr double kDeeper_mm = 0.02;
const Bounds kBox{{0, 0, kBottom_mm}, {kSize_mm, kSize_mm, 0}};

double surface(double x, double y) {
  return -5.6 + 2.5 * kerf::math::sin(x * 0.12) * kerf::math::cos(y * 0.09) +
         1.5 * kerf::math::sin(x * 0.05 + y * 0.07);
}

/// Two sheets of cells and the walls between them.
TriangleMesh wavy(double deeper, int side) {
  TriangleMesh mesh;
  const auto n = static_cast<std::uint32_t>(side + 1);
  for (const bool top : {false, true}) {
    for (std::uint32_t j = 0; j < n; ++j) {
      for (std::uint32_t i = 0; i < n; ++i) {
        const double x = kSize_mm * i / side;
        const double y = kSize_mm * j / side;
        mesh.points.push_back({x, y, top ? surface(x, y) - deeper : kBottom_mm});
      }
    }
  }
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  const std::uint32_t up = n * n;
  for (std::uint32_t j = 0; j + 1 < n; ++j) {
    for (std::uint32_t i = 0; i + 1 < n; ++i) {
      const std::uint32_t at = j * n + i;
      quad(at, at + n, at + n + 1, at + 1);
      quad(up + at, up + at + 1, up + at + n + 1, up + at + n);
    }
  }
  for (std::uint32_t i = 0; i + 1 < n; ++i) {
    const std::uint32_t last = n * (n - 1);
    quad(i, i + 1, up + i + 1, up + i);
    quad(last + i + 1, last + i, up + last + i, up + last + i + 1);
    quad(n * (i + 1), n * i, up + n * i, up + n * (i + 1));
    quad(n * i + n - 1, n * (i + 1) + n - 1, up + n * (i + 1) + n - 1, up + n * i + n - 1);
  }
  return mesh;
}

const TriangleMesh& design() {
  static const TriangleMesh mesh = wavy(kDeeper_mm, kSide);
  return mesh;
}

compare::Tolerance tolerance(const benchmark::State& state) {
  const double mm = static_cast<double>(state.range(1)) / 1000;
  return {mm, mm};
}

void run(benchmark::State& state, const compare::Part& part) {
  const compare::MeshSolid solid(design());
  compare::Comparison found;
  for (auto _ : state) {
    found = compare::compare(part, solid, tolerance(state), static_cast<unsigned>(state.range(0)));
    benchmark::DoNotOptimize(found.totals);
  }
  state.counters["max_um"] = 1000 * found.of(compare::Side::excess).max_mm;
  state.counters["regions"] = static_cast<double>(found.regions.size());
}

void Design(benchmark::State& state) {
  for (auto _ : state) {
    const compare::MeshSolid solid(design());
    state.counters["MiB"] = static_cast<double>(solid.bytes()) / (1 << 20);
  }
}

void Field(benchmark::State& state) {
  const field::HeightField part(
      field::grid_of(kBox, kSize_mm / 707),
      [](double x, double y) -> field::Column {
        return {kBottom_mm, surface(x, y)};
      },
      2);
  run(state, compare::FieldSolid(part));
}

void Dexels(benchmark::State& state) {
  const auto solid = std::make_shared<kerf::mesh::SolidMesh>();
  solid->mesh = wavy(0, 250);
  const dexel::TriDexel part(dexel::mesh_shape(solid), 0.165, 2);
  run(state, compare::DexelSolid(part));
}

// Threads, and tolerance in micrometres.
BENCHMARK(Design)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(Field)
    ->Unit(benchmark::kMillisecond)
    ->Args({1, 50})
    ->Args({2, 50})
    ->Args({2, 10})
    ->Iterations(1);
BENCHMARK(Dexels)
    ->Unit(benchmark::kMillisecond)
    ->Args({1, 50})
    ->Args({2, 50})
    ->Args({2, 10})
    ->Iterations(1);

}  // namespace
