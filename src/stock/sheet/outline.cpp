#include "stock/sheet/outline.hpp"

#include "geometry/contour/boolean.hpp"
#include "geometry/contour/sweep.hpp"
#include "geometry/contour/tolerance.hpp"
#include "math/math.hpp"

namespace kerf::stock::sheet {
namespace {

using contour::Contour;
using contour::Region;

// Longer paths are swept in parts, which are united: sweeping costs more than linearly where a path
// meets itself.
constexpr std::size_t kMostVertices = 1000;

bool goes_on(const Contour& path, const Trace& trace) {
  return !path.vertices.empty() && path.vertices.size() < kMostVertices &&
         length(path.vertices.back().point - trace.from) <= contour::kSame_mm;
}

/// An arc as parts of at most half a circle.
void append(Contour& path, const Trace& trace, std::uint32_t owner) {
  if (path.vertices.empty()) path.vertices.push_back({trace.from});
  path.vertices.back().owner = owner;
  if (!(trace.radius > 0)) {
    if (trace.to != trace.from) path.vertices.push_back({trace.to, 0, owner});
    return;
  }
  constexpr double kParts = 4;
  const Vec2 out = trace.from - trace.centre;
  for (double i = 1; i <= kParts; ++i) {
    const auto [s, c] = math::sine_cosine(trace.turn_rad * (i / kParts));
    path.vertices.back().bulge = math::tan(trace.turn_rad / kParts / 4);
    const Vec2 end = trace.centre + Vec2{c * out.u - s * out.v, s * out.u + c * out.v};
    path.vertices.push_back({i == kParts ? trace.to : end, 0, owner});
  }
}

}  // namespace

Region outline_of(std::span<const Trace> traces, double kerf_mm,
                  std::span<const std::uint32_t> owners) {
  std::vector<Region> swept;
  Contour path{.vertices = {}, .is_closed = false};
  const auto sweep = [&] {
    if (!path.vertices.empty()) swept.push_back(contour::sweep_of_disc(path, kerf_mm / 2));
    path.vertices.clear();
  };
  for (std::size_t i = 0; i < traces.size(); ++i) {
    if (!goes_on(path, traces[i])) sweep();
    append(path, traces[i], owners.empty() ? 0 : owners[i]);
  }
  sweep();
  return contour::unite(swept);
}

}  // namespace kerf::stock::sheet
