#include "stock/surface/internal/flat_loop.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "math/math.hpp"

namespace kerf::stock::surface {
namespace {

using geometry::Vec2;

constexpr double kAside_mm = 1e-4;
constexpr double kSame_mm = 1e-6;
constexpr double kMostChords = 4096;

double chords(const contour::Edge& edge, double tolerance_mm) {
  if (edge.bulge == 0) return 1;
  const double r = contour::radius(edge);
  const double reach = std::min(1.0, tolerance_mm / r);
  const double step = 2 * math::acos(1 - reach);
  return std::clamp(std::ceil(std::fabs(contour::sweep_rad(edge)) / step), 1.0, kMostChords);
}

Vec2 outwards(const contour::Edge& edge, Vec2 at, double chords) {
  const double quarter = math::sin(contour::sweep_rad(edge) / chords / 4);
  return (2 * quarter * quarter) * (at - contour::centre(edge));
}

FlatLoop flat(const contour::Contour& loop, double tolerance_mm) {
  FlatLoop out;
  for (std::size_t i = 0; i < contour::edge_count(loop); ++i) {
    const contour::Edge edge = contour::edge_of(loop, i);
    const double count = chords(edge, tolerance_mm);
    for (double k = 0; k < count; ++k) {
      const Vec2 at = k == 0 ? edge.from : contour::point_at(edge, k / count);
      const bool is_new = out.empty() || length(at - out.back().place) > kSame_mm;
      if (is_new)
        out.push_back({at, edge.owner, k == 0 ? Vec2{} : outwards(edge, at, count)});
      else
        out.back().owner = edge.owner;
    }
  }
  while (out.size() > 1 && length(out.front().place - out.back().place) <= kSame_mm) out.pop_back();
  return out;
}

/// Corners that are told apart.
class Places {
 public:
  /// True: nothing was there.
  bool claim(Vec2 p) { return places_.insert(cell(p)).second; }

 private:
  static std::pair<double, double> cell(Vec2 p) {
    return {std::nearbyint(p.u / (kAside_mm / 2)), std::nearbyint(p.v / (kAside_mm / 2))};
  }
  std::set<std::pair<double, double>> places_;
};

/// To the left of the way through a corner: where the material is.
Vec2 inwards(const FlatLoop& loop, std::size_t i) {
  const Vec2 before = loop[(i + loop.size() - 1) % loop.size()].place;
  const Vec2 behind = loop[(i + 1) % loop.size()].place;
  const Vec2 way = behind - before;
  const double size = length(way);
  return size > 0 ? Vec2{-way.v / size, way.u / size} : Vec2{0, 1};
}

/// A loop with what is asked of it often.
struct Measured {
  const FlatLoop* loop;
  double area = 0;
  contour::Box box;

  explicit Measured(const FlatLoop& of) : loop(&of) {
    for (std::size_t i = 0; i < of.size(); ++i) {
      area += cross(of[i].place - of[0].place, of[(i + 1) % of.size()].place - of[0].place) / 2;
      box.take(of[i].place);
    }
  }

  [[nodiscard]] bool holds(Vec2 p) const {
    if (p.u < box.low.u || p.u > box.high.u || p.v < box.low.v || p.v > box.high.v) return false;
    bool in = false;
    for (std::size_t i = 0, j = loop->size() - 1; i < loop->size(); j = i++) {
      const Vec2 a = (*loop)[i].place;
      const Vec2 b = (*loop)[j].place;
      if ((a.v > p.v) == (b.v > p.v)) continue;
      if (p.u < (b.u - a.u) * (p.v - a.v) / (b.v - a.v) + a.u) in = !in;
    }
    return in;
  }
};

/// The smallest loop around a hole.
std::optional<std::size_t> outer_of(const std::vector<Measured>& loops, const Measured& hole) {
  std::optional<std::size_t> best;
  const Vec2 inside = 0.5 * ((*hole.loop)[0].place + (*hole.loop)[1].place);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (loops[i].area <= 0 || loops[i].area < -hole.area) continue;
    if (best && loops[i].area >= loops[*best].area) continue;
    if (loops[i].holds(inside)) best = i;
  }
  return best;
}

}  // namespace

std::vector<FlatLoop> flat_loops(const contour::Region& region, double tolerance_mm) {
  std::vector<FlatLoop> loops;
  Places places;
  for (const contour::Contour& each : region.loops) {
    FlatLoop loop = flat(each, tolerance_mm);
    if (loop.size() < 3) continue;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      constexpr int kMostTries = 8;
      for (int tries = 0; tries < kMostTries && !places.claim(loop[i].place); ++tries)
        loop[i].place = loop[i].place + kAside_mm * inwards(loop, i);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

std::vector<std::vector<std::size_t>> areas_of(const std::vector<FlatLoop>& loops) {
  const std::vector<Measured> measured(loops.begin(), loops.end());
  std::vector<std::vector<std::size_t>> of_outer(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (measured[i].area > 0) of_outer[i].insert(of_outer[i].begin(), i);
    if (measured[i].area > 0) continue;
    if (const auto outer = outer_of(measured, measured[i])) of_outer[*outer].push_back(i);
  }
  std::erase_if(of_outer, [](const auto& area) { return area.empty(); });
  return of_outer;
}

}  // namespace kerf::stock::surface
