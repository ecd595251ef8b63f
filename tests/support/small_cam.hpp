#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "feature_path.hpp"
#include "geometry/contour/boolean.hpp"
#include "geometry/contour/offset.hpp"
#include "geometry/contour/sweep.hpp"

namespace kerf::test {

/// Makes tool paths for regions the way simple CAM programs do, and says what a perfect tool would
/// have removed.
class SmallCam {
 public:
  using Contour = contour::Contour;
  using Region = contour::Region;
  using Vec2 = contour::Vec2;

  SmallCam(FeaturePath& path, double radius) : path_(path), radius_(radius) {}

  /// What a disc of the tool can reach of a region without leaving it.
  [[nodiscard]] Region reachable(const Region& region) const {
    return contour::offset(contour::offset(region, -radius_), radius_);
  }

  enum class Way : std::uint8_t { inside_out, outside_in };
  /// Loops at R, R + s, … from the border; each is entered by a plunge of its own.
  void parallel(const Region& region, double z, double step, Way way) {
    std::vector<Contour> loops;
    for (double d = radius_;; d += step) {
      const Region ring = contour::offset(region, -d);
      if (ring.is_empty()) break;
      loops.insert(loops.end(), ring.loops.begin(), ring.loops.end());
    }
    if (way == Way::inside_out) std::reverse(loops.begin(), loops.end());
    for (const Contour& loop : loops) enter_and_follow(loop, z);
  }

  /// Lines there and back across a rectangle, then once round it.
  void zig_zag(Vec2 low, Vec2 high, double z, double step) {
    const Vec2 from = low + Vec2{radius_, radius_};
    const Vec2 to = high - Vec2{radius_, radius_};
    plunge(from, z);
    double y = from.v;
    for (bool forwards = true;; forwards = !forwards) {
      line({forwards ? to.u : from.u, y}, z);
      if (y >= to.v) break;
      y = std::min(y + step, to.v);
      line({forwards ? to.u : from.u, y}, z);
    }
    const Contour round{{{from}, {{to.u, from.v}}, {to}, {{from.u, to.v}}}, true};
    follow(nearest_first(round), z);
    retract();
  }

  /// One pass along an open contour.
  void pass(const Contour& open, double z) {
    plunge(open.vertices.front().point, z);
    for (std::size_t i = 0; i < contour::edge_count(open); ++i) go(contour::edge_of(open, i), z);
    retract();
  }

  void enter_and_follow(const Contour& loop, double z) {
    plunge(loop.vertices.front().point, z);
    follow(loop, z);
    retract();
  }

  void plunge(Vec2 at, double z) {
    path_.rapid(at.u, at.v, kAbove_mm).line(at.u, at.v, z);
    at_ = at;
  }
  void retract() { path_.rapid(at_.u, at_.v, kAbove_mm); }
  void line(Vec2 to, double z) {
    path_.line(to.u, to.v, z);
    at_ = to;
  }

 private:
  static constexpr double kAbove_mm = 5;

  // So that the way to it is short.
  [[nodiscard]] Contour nearest_first(Contour loop) const {
    const auto nearest = std::min_element(
        loop.vertices.begin(), loop.vertices.end(), [&](const auto& a, const auto& b) {
          return geometry::length(a.point - at_) < geometry::length(b.point - at_);
        });
    std::rotate(loop.vertices.begin(), nearest, loop.vertices.end());
    return loop;
  }

  void follow(const Contour& loop, double z) {
    if (!(loop.vertices.front().point == at_)) line(loop.vertices.front().point, z);
    for (std::size_t i = 0; i < contour::edge_count(loop); ++i) go(contour::edge_of(loop, i), z);
  }

  void go(const contour::Edge& edge, double z) {
    if (edge.bulge == 0) return line(edge.to, z);
    const Vec2 centre = contour::centre(edge);
    path_.arc(edge.to.u, edge.to.v, z, centre.u, centre.v,
              edge.bulge > 0 ? motion::Direction::counterclockwise : motion::Direction::clockwise);
    at_ = edge.to;
  }

  FeaturePath& path_;
  double radius_;
  Vec2 at_{};
};

/// Numbers in a row that are the same everywhere.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15U + 1) {}

  [[nodiscard]] std::uint64_t below(std::uint64_t count) {
    state_ ^= state_ << 13U;
    state_ ^= state_ >> 7U;
    state_ ^= state_ << 17U;
    return (state_ >> 11U) % count;
  }
  [[nodiscard]] double between(double low, double high) {
    return low + (high - low) * static_cast<double>(below(1'000'001)) / 1e6;
  }
  [[nodiscard]] bool tossed() { return below(2) == 0; }

 private:
  std::uint64_t state_;
};

}  // namespace kerf::test
