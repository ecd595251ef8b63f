#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "control/gcode/cycles/turning_passes.hpp"
#include "control/gcode/cycles/turning_shape.hpp"
#include "geometry/arc.hpp"

namespace kerf::test {

using control::ShapePiece;
using control::TurningMove;
using control::TurningPasses;
using control::TurningShape;
using geometry::Vec2;
using Moves = std::vector<TurningMove>;

/// A point as programs write it: X as a diameter, then Z.
struct XZ {
  double x = 0;
  double z = 0;
};
inline Vec2 in_plane(XZ point) { return {point.z, point.x / 2}; }

/// Makes a shape of blocks 1, 2, … ; ns is block 0.
class ShapeMaker {
 public:
  ShapeMaker(XZ start, XZ first) : at_(in_plane(first)) { shape.start = in_plane(start); }

  /// ns is G01.
  ShapeMaker& by_feed() {
    shape.approach_is_rapid = false;
    return *this;
  }
  /// ns has X and Z.
  ShapeMaker& both_axes() {
    shape.both_axes = true;
    return *this;
  }
  ShapeMaker& line(XZ to) { return add({.to = in_plane(to)}); }
  ShapeMaker& arc(XZ to, double radius, bool clockwise) {
    const auto centre = geometry::centre_from_radius(at_, in_plane(to), radius, clockwise, 1e-6);
    return add({.to = in_plane(to), .is_arc = true, .clockwise = clockwise, .centre = *centre});
  }
  ShapeMaker& clockwise(XZ to, double radius) { return arc(to, radius, true); }
  ShapeMaker& counterclockwise(XZ to, double radius) { return arc(to, radius, false); }
  ShapeMaker& circle(XZ centre) {
    return add({.to = at_, .is_arc = true, .clockwise = true, .centre = in_plane(centre)});
  }

  TurningShape shape;

 private:
  ShapeMaker& add(ShapePiece piece) {
    piece.from = at_;
    piece.block = static_cast<std::uint32_t>(shape.pieces.size() + 1);
    shape.pieces.push_back(piece);
    at_ = piece.to;
    return *this;
  }

  Vec2 at_;
};

/// All moves of a cycle. More than `most` fail the test.
inline Moves moves_of(TurningPasses& passes, std::size_t most = 1'000'000) {
  Moves moves;
  TurningMove move;
  while (passes.next(move)) {
    moves.push_back(move);
    if (moves.size() > most) {
      ADD_FAILURE() << "more than " << most << " moves";
      break;
    }
  }
  return moves;
}

/// Only what cuts.
inline Moves cuts_of(const Moves& moves) {
  Moves cuts;
  for (const TurningMove& move : moves) {
    if (move.kind == TurningMove::Kind::feed) cuts.push_back(move);
  }
  return cuts;
}

/// Moves from a text: kind R F CW CCW, X (diameter), Z, of arcs those of the centre; each ends at
/// ;.
inline Moves read_moves(const std::string& text) {
  Moves moves;
  std::istringstream lines(text);
  for (std::string one; std::getline(lines, one, ';');) {
    std::istringstream words(one);
    std::string kind;
    XZ to;
    XZ centre;
    if (!(words >> kind >> to.x >> to.z)) continue;
    words >> centre.x >> centre.z;
    moves.push_back({.kind = kind == "R" ? TurningMove::Kind::rapid : TurningMove::Kind::feed,
                     .is_arc = kind == "CW" || kind == "CCW",
                     .clockwise = kind == "CW",
                     .to = in_plane(to),
                     .centre = in_plane(centre)});
  }
  return moves;
}

/// Such a text of one.
inline std::string text(const TurningMove& move) {
  char line[120];
  const char* kind = move.kind == TurningMove::Kind::rapid ? "R" : "F";
  if (move.is_arc) kind = move.clockwise ? "CW" : "CCW";
  std::snprintf(line, sizeof line, "%s %.4f %.4f", kind, 2 * move.to.v, move.to.u);
  std::string result = line;
  if (!move.is_arc) return result;
  std::snprintf(line, sizeof line, " %.4f %.4f", 2 * move.centre.v, move.centre.u);
  return result + line;
}
inline std::string text(const Moves& moves) {
  std::string result;
  for (const TurningMove& move : moves) result += text(move) + "; ";
  return result;
}

/// Without straight moves that go nowhere.
inline Moves without_stops(const Moves& moves, Vec2 from) {
  Moves kept;
  for (const TurningMove& move : moves) {
    if (move.is_arc || length(move.to - from) > 1e-9) kept.push_back(move);
    from = move.to;
  }
  return kept;
}

inline bool are_near(const TurningMove& a, const TurningMove& b, double tolerance) {
  const auto apart = [&](Vec2 one, Vec2 other) {
    return std::fabs(one.u - other.u) > tolerance || 2 * std::fabs(one.v - other.v) > tolerance;
  };
  if (a.kind != b.kind || a.is_arc != b.is_arc || apart(a.to, b.to)) return false;
  return !a.is_arc || (a.clockwise == b.clockwise && !apart(a.centre, b.centre));
}

/// The first move that differs by more than `tolerance`, Z in mm, X in diameter. Empty: none.
inline std::string difference(const Moves& wanted, const Moves& found, double tolerance = 0.0006) {
  for (std::size_t i = 0; i < std::max(wanted.size(), found.size()); ++i) {
    const bool both = i < wanted.size() && i < found.size();
    if (both && are_near(wanted[i], found[i], tolerance)) continue;
    return "move " + std::to_string(i) + ": " + (i < found.size() ? text(found[i]) : "none") +
           " instead of " + (i < wanted.size() ? text(wanted[i]) : "none") + " in\n" + text(found);
  }
  return "";
}

}  // namespace kerf::test
