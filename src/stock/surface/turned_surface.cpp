#include "stock/surface/turned_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "math/math.hpp"
#include "stock/surface/internal/flat_loop.hpp"
#include "stock/surface/internal/polygon_triangles.hpp"
#include "stock/turned/revolved.hpp"

namespace kerf::stock::surface {
namespace {

using geometry::Vec3;

/// On a round arc so much of the way outwards makes up for what chords leave.
constexpr double kUsualShare = 2.0 / 3;
constexpr int kMostTries = 4;
constexpr double kOnAxis_mm = 1e-9;
constexpr double kFewest = 96;  // around
constexpr double kMost = 1440;

/// Into how many parts a circle is divided: chords of the angle a are r (1 - cos a/2) off.
std::size_t parts_around(double radius, double tolerance_mm) {
  if (!(radius > tolerance_mm)) return static_cast<std::size_t>(kFewest);
  const double half = math::acos(1 - tolerance_mm / radius);
  return static_cast<std::size_t>(std::clamp(std::ceil(std::numbers::pi / half), kFewest, kMost));
}

constexpr double kWhole = 2 * std::numbers::pi;

/// Turns loops about the axis, all with the same angles.
class Lathe {
 public:
  /// Polygons as large as the circles.
  Lathe(std::size_t count, Surface& into) : Lathe(count, 0, kWhole, false, into) {
    const double step = kWhole / static_cast<double>(count);
    const double scale = std::sqrt(step / math::sin(step));
    for (double& sine : sines_) sine *= scale;
    for (double& cosine : cosines_) cosine *= scale;
  }
  /// `sections`: at the ends of what is no whole turn.
  Lathe(std::size_t count, double begin, double sweep, bool sections, Surface& into)
      : bands_(count), into_(into) {
    for (std::size_t i = 0; i < count + (sections ? 1 : 0); ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(count);
      const auto [sine, cosine] = math::sine_cosine(begin + sweep * share);
      sines_.push_back(sine);
      cosines_.push_back(cosine);
    }
  }

  void turn(const FlatLoop& loop) {
    std::vector<Ring>& rings = rings_.emplace_back();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t before = loop[i == 0 ? loop.size() - 1 : i - 1].owner;
      rings.push_back(add_ring(loop[i].place, std::max(before, loop[i].owner)));
    }
    for (std::size_t i = 0; i < loop.size(); ++i)
      add_band(rings[i], rings[(i + 1) % loop.size()], loop[i].owner);
  }

  /// An area between loops that were turned, at both ends.
  void close(const std::vector<FlatLoop>& loops, const std::vector<std::size_t>& area) {
    std::vector<geometry::Vec2> points;
    std::vector<Ring> rings;
    std::vector<std::vector<std::uint32_t>> numbers;
    for (const std::size_t loop : area) {
      numbers.emplace_back();
      for (std::size_t i = 0; i < loops[loop].size(); ++i) {
        numbers.back().push_back(static_cast<std::uint32_t>(points.size()));
        points.push_back(loops[loop][i].place);
        rings.push_back(rings_[loop][i]);
      }
    }
    for (const FlatTriangle& t : triangles_of(points, numbers)) {
      const auto at = [&](std::size_t k, std::size_t angle) { return point(rings[t[k]], angle); };
      add({at(0, 0), at(2, 0), at(1, 0)}, kSection);
      add({at(0, bands_), at(1, bands_), at(2, bands_)}, kSection);
    }
  }

 private:
  struct Ring {
    std::uint32_t first;
    bool is_point;
  };

  Ring add_ring(geometry::Vec2 place, std::uint32_t owner) {
    const auto first = static_cast<std::uint32_t>(into_.mesh.points.size());
    const bool is_point = place.v <= kOnAxis_mm;
    for (std::size_t i = 0; i < (is_point ? 1 : sines_.size()); ++i) {
      into_.mesh.points.push_back(is_point
                                      ? Vec3{0, 0, place.u}
                                      : Vec3{place.v * cosines_[i], place.v * sines_[i], place.u});
      into_.point_owners.push_back(owner);
    }
    return {first, is_point};
  }

  [[nodiscard]] std::uint32_t point(const Ring& ring, std::size_t angle) const {
    return ring.is_point ? ring.first
                         : ring.first + static_cast<std::uint32_t>(angle % sines_.size());
  }

  void add_band(const Ring& from, const Ring& to, std::uint32_t owner) {
    if (from.is_point && to.is_point) return;
    for (std::size_t i = 0; i < bands_; ++i) {
      if (!to.is_point) add({point(from, i), point(to, i), point(to, i + 1)}, owner);
      if (!from.is_point) add({point(from, i), point(to, i + 1), point(from, i + 1)}, owner);
    }
  }

  void add(const mesh::Triangle& triangle, std::uint32_t owner) {
    into_.mesh.triangles.push_back(triangle);
    into_.owners.push_back(owner);
  }

  std::size_t bands_;
  Surface& into_;
  std::vector<double> sines_;
  std::vector<double> cosines_;
  std::vector<std::vector<Ring>> rings_;  // of loops
};

/// What loops of straight edges go through in a turn.
double volume(const std::vector<FlatLoop>& loops) {
  contour::Region region;
  for (const FlatLoop& loop : loops) {
    region.loops.emplace_back();
    for (const FlatPoint& point : loop) region.loops.back().vertices.push_back({point.place});
  }
  return turned::volume(region);
}

/// Points on arcs go outwards by this share of what chords are off.
std::vector<FlatLoop> filled(std::vector<FlatLoop> loops, double share) {
  for (FlatLoop& loop : loops) {
    for (FlatPoint& point : loop) {
      const geometry::Vec2 to = point.place + share * point.outwards;
      if (to.v > 0) point.place = to;
    }
  }
  return loops;
}

/// They go through the volume that their arcs would: the share is found by the secant.
std::vector<FlatLoop> with_volume(const std::vector<FlatLoop>& loops, double wanted) {
  double last = 0;
  double last_off = volume(loops) - wanted;
  double share = kUsualShare;
  for (int tries = 0; tries < kMostTries; ++tries) {
    const double off = volume(filled(loops, share)) - wanted;
    if (off == last_off) break;
    const double next = std::clamp(share - off * (share - last) / (off - last_off), 0.0, 1.0);
    last = std::exchange(share, next);
    last_off = off;
  }
  return filled(loops, share);
}

}  // namespace

// A point may go outwards by two thirds of what chords are off, along and around.
Surface turned(const contour::Region& region, double tolerance_mm) {
  Surface surface;
  if (region.is_empty()) return surface;
  const double chord_mm = 0.7 * tolerance_mm;
  const std::size_t count = parts_around(contour::extents(region).high.v, chord_mm);
  Lathe lathe(count, surface);
  const std::vector<FlatLoop> loops = flat_loops(region, chord_mm);
  for (const FlatLoop& loop : with_volume(loops, turned::volume(region))) lathe.turn(loop);
  return surface;
}

Surface turned_open(const contour::Region& region, double tolerance_mm, double begin_rad,
                    double sweep_rad) {
  Surface surface;
  if (region.is_empty()) return surface;
  const auto count =
      static_cast<double>(parts_around(contour::extents(region).high.v, tolerance_mm));
  const auto parts = static_cast<std::size_t>(std::ceil(count * sweep_rad / kWhole));
  Lathe lathe(parts, begin_rad, sweep_rad, true, surface);
  const std::vector<FlatLoop> loops = flat_loops(region, tolerance_mm);
  for (const FlatLoop& loop : loops) lathe.turn(loop);
  for (const auto& area : areas_of(loops)) lathe.close(loops, area);
  return surface;
}

}  // namespace kerf::stock::surface
