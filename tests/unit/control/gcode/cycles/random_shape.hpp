#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "control/gcode/cycles/rough_passes.hpp"
#include "geometry/arc.hpp"
#include "seeded_random.hpp"
#include "turning_bench.hpp"

namespace kerf::test {

/// A piece of a random shape that never goes back in u. Arcs are at most half a circle.
struct RandomPiece {
  Vec2 from{};
  Vec2 to{};
  bool is_arc = false;
  bool clockwise = false;  ///< the upper half of its circle, otherwise the lower
  Vec2 centre{};

  [[nodiscard]] double height(double u) const;
};

/// A random shape in a frame of its own: the start at (0, `start`), u along the travel of the
/// passes, v upward; every height lies in [0, start].
struct RandomShape {
  double start = 0;
  std::vector<RandomPiece> pieces;

  [[nodiscard]] double first() const { return pieces.front().from.v; }
  [[nodiscard]] double end() const { return pieces.back().to.u; }
  /// Height at `u` in [0, end()]: at walls the least.
  [[nodiscard]] double height(double u) const;
  /// All u in [a, b] where a piece begins or ends, or passes `level`, and both limits; in order.
  [[nodiscard]] std::vector<double> crossings(double level, double a, double b) const;
  /// The least height in [a, b].
  [[nodiscard]] double lowest(double a, double b) const;
};

inline double RandomPiece::height(double u) const {
  if (to.u == from.u) return std::min(from.v, to.v);
  if (u == from.u || u == to.u) return u == to.u ? to.v : from.v;
  if (!is_arc) return from.v + (u - from.u) / (to.u - from.u) * (to.v - from.v);
  const double r = length(from - centre);
  const double aside = u - centre.u;
  const double half = std::sqrt(std::max(0.0, (r - aside) * (r + aside)));
  return clockwise ? centre.v + half : centre.v - half;
}

inline double RandomShape::height(double u) const {
  if (u < pieces.front().from.u) return first();
  double least = INFINITY;
  for (const RandomPiece& piece : pieces) {
    if (u >= piece.from.u && u <= piece.to.u) least = std::min(least, piece.height(u));
  }
  return least;
}

inline std::vector<double> RandomShape::crossings(double level, double a, double b) const {
  std::vector<double> all{a, b};
  const auto add = [&](const RandomPiece& piece, double u) {
    if (u >= std::max(a, piece.from.u) && u <= std::min(b, piece.to.u)) all.push_back(u);
  };
  for (const RandomPiece& piece : pieces) {
    add(piece, piece.from.u);
    add(piece, piece.to.u);
    if (piece.is_arc) {
      const double r = length(piece.from - piece.centre);
      const double above = level - piece.centre.v;
      const double half = std::sqrt(std::max(0.0, (r - above) * (r + above)));
      add(piece, piece.centre.u - half);
      add(piece, piece.centre.u + half);
    } else if (piece.from.v != piece.to.v) {
      const double share = (level - piece.from.v) / (piece.to.v - piece.from.v);
      add(piece, piece.from.u + share * (piece.to.u - piece.from.u));
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

inline double RandomShape::lowest(double a, double b) const {
  double least = std::min(height(a), height(b));
  for (const RandomPiece& piece : pieces) {
    const bool bottom = piece.is_arc && !piece.clockwise;
    for (const double u : {piece.from.u, piece.to.u, bottom ? piece.centre.u : piece.to.u}) {
      if (u < a || u > b || u < piece.from.u || u > piece.to.u) continue;
      // A wall between levels is only as deep as it is inside of [a, b]: its ends are others' too.
      if (piece.from.u != piece.to.u) least = std::min(least, piece.height(u));
    }
  }
  return least;
}

/// Makes random shapes, on a coarse grid as often as not, so that flats and corners lie on levels.
class ShapeDice {
 public:
  explicit ShapeDice(unsigned seed) : random(seed), on_grid_(random.coin()) {}

  RandomShape shape(bool pockets);
  control::RoughSettings settings();

  SeededRandom random;

 private:
  double size(double low, double high) {
    const double value = random.in(low, high);
    return on_grid_ ? std::ceil(value * 2) / 2 : value;
  }
  [[nodiscard]] Vec2 next_point(const RandomShape& shape, Vec2 from, bool pockets);
  void add_arc(RandomShape& shape, Vec2 from, Vec2 to, bool pockets);

  bool on_grid_;
};

inline RandomShape ShapeDice::shape(bool pockets) {
  RandomShape shape{.start = size(3, 20), .pieces = {}};
  Vec2 at{pockets && random.count(0, 4) == 0 ? size(0, 3) : 0, pockets ? size(0, 3) : 0};
  at.v = std::min(at.v, shape.start);
  for (int i = random.count(1, 14); i > 0; --i) {
    const Vec2 to = next_point(shape, at, pockets);
    if (to == at) continue;
    if (to.u > at.u && random.count(0, 2) == 0) {
      add_arc(shape, at, to, pockets);
    } else {
      shape.pieces.push_back({.from = at, .to = to});
    }
    at = to;
  }
  if (shape.pieces.empty() || at.u == 0)
    shape.pieces.push_back({.from = at, .to = {at.u + 1, at.v}});
  return shape;
}

inline Vec2 ShapeDice::next_point(const RandomShape& shape, Vec2 from, bool pockets) {
  const bool was_wall = !shape.pieces.empty() && shape.pieces.back().from.u == from.u;
  const int kind = random.count(was_wall ? 1 : 0, 4);
  const double ahead = kind == 0 ? 0 : size(0.01, 6);
  double up = kind == 1 ? 0 : size(0.01, 6);
  if (pockets && random.coin()) up = -up;
  return {from.u + ahead, std::clamp(from.v + up, 0.0, shape.start)};
}

// An arc where one fits that goes back neither in u nor, without pockets, in v; else a line.
inline void ShapeDice::add_arc(RandomShape& shape, Vec2 from, Vec2 to, bool pockets) {
  const bool clockwise = random.coin();
  const double chord = length(to - from);
  const double radius = chord / 2 * (random.coin() ? 1 : random.size(1.0001, 5));
  RandomPiece piece{.from = from, .to = to, .is_arc = true, .clockwise = clockwise};
  piece.centre = *geometry::centre_from_radius(from, to, radius, clockwise, 1e-6);
  if (random.coin() && to.v != from.v)  // a quarter
    piece.centre = clockwise == (to.v > from.v) ? Vec2{to.u, from.v} : Vec2{from.u, to.v};
  const auto is_half = [&](Vec2 end) {
    return clockwise ? end.v >= piece.centre.v : end.v <= piece.centre.v;
  };
  const bool turns_in_v = piece.centre.u > from.u && piece.centre.u < to.u;
  const double off = length(from - piece.centre) - length(to - piece.centre);
  if (std::fabs(off) > 1e-12 || !is_half(from) || !is_half(to)) piece.is_arc = false;
  if (turns_in_v &&
      (!pockets || piece.height(piece.centre.u) > shape.start || piece.height(piece.centre.u) < 0))
    piece.is_arc = false;
  shape.pieces.push_back(piece);
}

inline control::RoughSettings ShapeDice::settings() {
  const auto allowance = [&] { return random.coin() ? 0 : random.in(-0.5, 0.5); };
  return {.depth_mm = size(0.2, 4),
          .retreat_mm = random.count(0, 3) == 0 ? 0 : size(0, 1.5),
          .allowance = {allowance(), allowance()}};
}

/// Where the frame of random shapes lies in the plane: one of both axes of travel, each of them in
/// one of both directions.
struct Quadrant {
  double along = 1;
  double up = 1;
  bool exchanged = false;

  [[nodiscard]] Vec2 in_plane(Vec2 point) const {
    const Vec2 turned{along * point.u, up * point.v};
    return exchanged ? Vec2{turned.v, turned.u} : turned;
  }
  [[nodiscard]] Vec2 local(Vec2 point) const {
    const Vec2 turned = exchanged ? Vec2{point.v, point.u} : point;
    return {along * turned.u, up * turned.v};
  }
  [[nodiscard]] bool turns_over() const { return exchanged != (along * up < 0); }
  [[nodiscard]] control::Travel travel() const {
    return exchanged ? control::Travel::along_x : control::Travel::along_z;
  }
};

/// The quadrants of one axis of travel.
inline std::vector<Quadrant> quadrants(bool exchanged) {
  return {{1, 1, exchanged}, {-1, 1, exchanged}, {1, -1, exchanged}, {-1, -1, exchanged}};
}

inline TurningShape place(const RandomShape& shape, const Quadrant& quadrant, bool pockets) {
  TurningShape placed{.start = quadrant.in_plane({0, shape.start}),
                      .approach_is_rapid = true,
                      .both_axes = pockets,
                      .pieces = {},
                      .first_block = 0};
  for (const RandomPiece& piece : shape.pieces) {
    placed.pieces.push_back({.from = quadrant.in_plane(piece.from),
                             .to = quadrant.in_plane(piece.to),
                             .is_arc = piece.is_arc,
                             .clockwise = piece.clockwise != quadrant.turns_over(),
                             .centre = quadrant.in_plane(piece.centre),
                             .block = static_cast<std::uint32_t>(placed.pieces.size() + 1)});
  }
  return placed;
}

/// A shape as text, to be seen beside a failure.
inline std::string text(const RandomShape& shape) {
  std::ostringstream out;
  out.precision(17);
  out << "start " << shape.start << ", from " << shape.pieces.front().from.u << " "
      << shape.first();
  for (const RandomPiece& piece : shape.pieces) {
    out << (piece.is_arc ? piece.clockwise ? "\nCW " : "\nCCW " : "\nF ") << piece.to.u << " "
        << piece.to.v;
    if (piece.is_arc) out << " about " << piece.centre.u << " " << piece.centre.v;
  }
  return out.str();
}

}  // namespace kerf::test
