#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "stock/field/block_points.hpp"
#include "stock/field/columns.hpp"
#include "stock/field/lower_envelope.hpp"
#include "stock/sweep/outcome.hpp"

namespace kerf::stock::field {

/// Columns whose `along` is less than `before`, or more than `after` + √(lean2 - lean out²), where
/// `out` is how far they are beside the core, are behind a leg that begins behind itself. A lean
/// of 0: more than `after`.
struct Behind {
  float before = -kNowhere;
  float after = kNowhere;
  float core = 0;
  float lean = 0;
  float lean2 = 0;
};

/// A straight way under one tool, from its lower end (straight_leg.hpp), as it is looked at from
/// the columns and the blocks of one tile: mm, heights over the base.
struct StraightSight {
  double x = 0, y = 0;  ///< the lower end
  float dx = 1, dy = 0;
  float z = 0;
  float slope = 0;
  float length = 0;  ///< 0: vertical
  float left = 1;    ///< -1: the tool goes down it, and has its left on the right
  float lean2 = 0;   ///< slope² / (1 + slope²)
  bool begins_behind = false;
  Behind behind{};
  // Of blocks: how far their columns are from their middles along and across the way, how far
  // along it the tool reaches them, and z, all of it on the safe side.
  float half_along = 0;
  float half_across = 0;
  float reach = 0;
  float lowest_z = 0;
};

/// LowerEnvelope::Round as floats; a shrunk ball has its centre beyond the axis by `base`.
struct RoundFloor {
  float reach2 = 0;
  float core = 0;
  float base = 0;
  float z = 0;
  float radius2 = 0;
};

/// What a sweep leaves over the columns of a block, and how far they are beside its way; kNowhere:
/// nothing, nowhere.
struct Look {
  BlockValues low;
  BlockValues offsets;
};

/// What a sweep took from columns, mm of heights. Sums are in the order of the blocks, four of
/// them beside each other, and do not depend on how many columns are computed with at once.
struct Taken {
  float bins_per_mm = 0;
  float reach = 0;  ///< half of what the bins go over
  std::array<double, kBlockSide> heights{};
  /// By offset, in two parts; the last one: of columns whose offset is not known.
  std::array<std::array<double, Outcome::kBins + 1>, 2> across{};
  // Of columns whose offset is known, to the sides and how high they were and are.
  float left = -kNowhere;
  float right = kNowhere;
  float highest = -kNowhere;
  float lowest = kNowhere;

  [[nodiscard]] float place_of(float offset) const { return (offset + reach) * bins_per_mm; }
};

/// What TileCutter asks of many columns at once. There is one for each width of registers, and all
/// give the same bits: they compute each column as if alone.
struct LaneWork {
  /// The blocks of the grid over which the surface may lie below their tops; a round tool.
  void (*meets)(const StraightSight& way, const RoundFloor& tool, const BlockGrid& grid,
                BlockMasks& met);
  /// For each block of a row: not above the tip while it reaches the block, kNowhere where it does
  /// not; the least distance of the axis.
  void (*places)(const StraightSight& way, const BlockGrid& grid, std::size_t row, RowValues& tip,
                 RowValues& distance);
  /// Bit i: max(0, low[i]) < high[i], of 16.
  unsigned (*below)(const float* low, const float* high);
  /// low[i] becomes the lowest surface that the pieces leave over column i, where that is lower.
  void (*lower)(const StraightSight& way, std::span<const EnvelopePiece> pieces,
                const BlockPoints& points, BlockValues& low);
  /// The surface over the columns of blocks, and where they are, in looks[i] for blocks[i]. Those
  /// that it lowers are put into `lowered` by their i; gives how many there are.
  std::size_t (*look)(const StraightSight& way, std::span<const EnvelopePiece> pieces,
                      const Columns::Tile& tile, std::span<const int> blocks, Look* looks,
                      std::size_t* lowered);
  /// For each i of `lowered`, of blocks[i] and looks[i]: heights become low, not below their
  /// bottoms, where that is lower; their owner is the motion then. The block's top is kept. Offsets
  /// that are kNowhere are not known.
  void (*settle)(const Columns::Tile& tile, std::uint32_t motion, std::span<const int> blocks,
                 const Look* looks, std::span<const std::size_t> lowered, Taken& taken);
};

/// Those that this processor can do, the widest last.
[[nodiscard]] std::span<const LaneWork* const> lane_works();
/// The widest of them.
[[nodiscard]] inline const LaneWork& lane_work() { return *lane_works().back(); }

/// By how much floats may move the surface, mm, over a leg and a tool of this size together.
constexpr double bound_safety(double size_mm) { return 1e-4 + 1e-6 * size_mm; }

}  // namespace kerf::stock::field
