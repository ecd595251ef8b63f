#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "base/block_id.hpp"
#include "features/path/chunks.hpp"
#include "features/path/move.hpp"
#include "geometry/contour/contour.hpp"
#include "stock/tool/tool.hpp"

namespace kerf::features {

/// Rows of a recording in their order: from the first to the last one.
struct Span {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  friend bool operator==(const Span&, const Span&) = default;
};

/// All that a run has moved. Of a mill XY is the plane, of a lathe (Z, X) with X as a radius.
struct Recording {
  bool turns = false;  ///< of a lathe
  Vec3 start{};        ///< where the first row begins, coordinates of its set-up
  Chunks<Move> moves{};
  Chunks<base::BlockId> blocks{};
  std::vector<ArcRow> arcs{};
  std::vector<double> lengths{};  ///< of rows that are neither line nor arc, mm
  std::vector<State> states{};
  std::vector<SetUp> setups{};
  std::map<std::uint32_t, stock::Tool> tools{};  ///< that were in the spindle, by number
  /// Of each change of the set-up: the row that is the first in the new one, and where it begins.
  std::map<std::uint32_t, Vec3> begins{};

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(moves.size()); }
  [[nodiscard]] const State& state_of(const Move& move) const { return states[move.state]; }
  [[nodiscard]] const base::BlockId& block_of(const Move& move) const { return blocks[move.block]; }
  [[nodiscard]] std::uint32_t line_of(std::uint32_t row) const {
    return blocks[moves[row].block].line;
  }
  /// Where the row begins, in its own set-up.
  [[nodiscard]] Vec3 from(std::uint32_t row) const;
  /// The point in the plane.
  [[nodiscard]] Vec2 flat(Vec3 point) const {
    return turns ? Vec2{point.z, point.x} : Vec2{point.x, point.y};
  }
  [[nodiscard]] Vec2 flat_from(std::uint32_t row) const { return flat(from(row)); }
  [[nodiscard]] Vec2 flat_to(std::uint32_t row) const { return flat(moves[row].to); }
  /// The arc of a row that is one.
  [[nodiscard]] const ArcRow& arc_of(std::uint32_t row) const { return arcs[moves[row].shaped]; }
  /// Exact, mm.
  [[nodiscard]] double length_of(std::uint32_t row) const;
  [[nodiscard]] double length_of(Span span) const;
  /// In the plane: a line or an arc that comes elsewhere, or round in a circle.
  [[nodiscard]] bool goes_across(std::uint32_t row) const;
  /// Appends what a row is in the plane: one edge, of more than half a circle several, of a whole
  /// one of its turns. The owner is the row. Of what is neither line nor arc its chord.
  void append_edges(std::uint32_t row, std::vector<contour::Edge>& edges) const;
  /// The rows at feed that go across, as one closed contour.
  [[nodiscard]] contour::Contour contour_of(Span rows) const;
};

/// Appends an arc in the plane: one edge, of more than half a circle several.
void append_edges(Vec2 begin, Vec2 end, const ArcRow& arc, std::uint32_t owner,
                  std::vector<contour::Edge>& edges);

}  // namespace kerf::features
