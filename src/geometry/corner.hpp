#pragma once

#include <optional>

#include "geometry/vec2.hpp"

namespace kerf::geometry {

/// A line from `from` to `to`, or an arc between them about `centre`.
struct Piece {
  Vec2 from;
  Vec2 to;
  bool is_arc = false;
  bool clockwise = false;
  Vec2 centre{};
};

/// What is put in the place of the corner between two pieces: from a point of the first to a point
/// of the second.
struct Blend {
  Vec2 begin;
  Vec2 end;
  bool is_arc = false;
  bool clockwise = false;
  Vec2 centre{};
};

/// Direction of travel at the ends of a piece, unit length. The piece must have a length.
[[nodiscard]] Vec2 direction_at_start(const Piece& piece);
[[nodiscard]] Vec2 direction_at_end(const Piece& piece);

/// True when the pieces go on in the same direction: there is no corner.
[[nodiscard]] bool is_smooth(const Piece& first, const Piece& second);

/// Arc of `radius` > 0 tangent to both pieces. Nothing when it does not fit on them.
[[nodiscard]] std::optional<Blend> fillet(const Piece& first, const Piece& second, double radius);

/// Line between the points that lie `distance` > 0 from the corner on either piece. Nothing when a
/// piece is shorter.
[[nodiscard]] std::optional<Blend> chamfer(const Piece& first, const Piece& second,
                                           double distance);

}  // namespace kerf::geometry
