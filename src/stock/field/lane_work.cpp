// Compiled for each width of registers: straight ways over the columns of a tile.
#include "stock/field/lane_work.hpp"

#include <utility>

#include "stock/field/lane_pieces.hpp"
#include "stock/field/lanes.hpp"
#include "stock/sweep/outcome.hpp"

namespace kerf::stock::field {
namespace KERF_LANES {
namespace {

constexpr float kMostBin = Outcome::kBins - 1.0F;

/// Calls with the number of each part of a block that fills the lanes.
template <class Do>
void for_parts(const Do& act) {
  [&]<int... part>(std::integer_sequence<int, part...>) {
    (act(std::integral_constant<int, part>{}), ...);
  }
  (std::make_integer_sequence<int, kBlockCells / static_cast<int>(kLanes)>{});
}

/// What is within [first, last] along the way and `beside` it is behind its beginning: before it,
/// or more than √(lean2 - lean out²) past the end.
[[gnu::always_inline]] inline LaneInts is_behind(const Behind& behind, Lanes first, Lanes last,
                                                 Lanes beside) {
  if (behind.after >= kNowhere) return last < all(behind.before);
  const Lanes past = first - behind.after;
  const Lanes out = larger(beside - behind.core, Lanes{});
  return (last < all(behind.before)) |
         ((past > Lanes{}) & (past * past > behind.lean2 - behind.lean * out * out));
}

/// Blocks of a row as rectangles along and across the way that hold their columns.
struct BlockLanes {
  BlockLanes(const StraightSight& way, Lanes x, Lanes y) {
    const Lanes along = x * way.dx + y * way.dy;
    const Lanes beside = y * way.dx - x * way.dy;
    const Lanes none{};
    const Lanes u = larger(larger(beside, -beside) - way.half_across, none);
    const Lanes past = larger(larger(-along, along - way.length) - way.half_along, none);
    tip = way.lowest_z + way.slope * larger(along - way.reach, none);
    if (way.begins_behind) {
      tip = is_behind(way.behind, along - way.half_along, along + way.half_along, u) ? all(kNowhere)
                                                                                     : tip;
    }
    distance2 = u * u + past * past;
  }
  Lanes tip;
  Lanes distance2;
};

/// Calls with the blocks of a row that are asked for, as many at a time as there are lanes.
template <class Do>
void for_blocks(const StraightSight& way, const BlockGrid& grid, std::size_t row, const Do& act) {
  const auto from_x = static_cast<float>(way.x - grid.origin_x);
  const Lanes y = all(static_cast<float>(grid.y[row] - way.y));
  for (std::size_t i = grid.first_x / kLanes * kLanes; i < grid.end_x; i += kLanes)
    act(i, BlockLanes(way, load(grid.x + i) - from_x, y));
}

/// `low` gives the surface over blocks, not above it.
template <class Low>
void meet_rows(const StraightSight& way, float reach2, const BlockGrid& grid, BlockMasks& met,
               const Low& low) {
  for (std::size_t row = grid.first_y; row < grid.end_y; ++row) {
    const float* const tops = grid.tops + row * kTileBlocks;
    met[row] = 0;
    for_blocks(way, grid, row, [&](std::size_t i, const BlockLanes& at) {
      const LaneInts is_met =
          (at.distance2 <= all(reach2)) & (larger(Lanes{}, low(at)) < load(tops + i));
      met[row] |= bits(is_met) << i;
    });
  }
}

void meets(const StraightSight& way, const RoundFloor& tool, const BlockGrid& grid,
           BlockMasks& met) {
  if (tool.core == 0 && tool.base == 0) {  // a ball
    return meet_rows(way, tool.reach2, grid, met, [&](const BlockLanes& at) {
      return at.tip + tool.z - root(tool.radius2 - at.distance2);
    });
  }
  meet_rows(way, tool.reach2, grid, met, [&](const BlockLanes& at) {
    const Lanes out = larger(root(at.distance2) - tool.core, Lanes{}) - tool.base;
    return at.tip + tool.z - root(tool.radius2 - out * out);
  });
}

void places(const StraightSight& way, const BlockGrid& grid, std::size_t row, RowValues& tip,
            RowValues& distance) {
  for_blocks(way, grid, row, [&](std::size_t i, const BlockLanes& at) {
    store(at.tip, &tip[i]);
    store(root(at.distance2), &distance[i]);
  });
}

unsigned below(const float* low, const float* high) {
  unsigned of = 0;
  for (std::size_t i = 0; i < kBlockCells; i += kLanes) {
    of |= bits(larger(Lanes{}, load(low + i)) < load(high + i)) << i;
  }
  return of;
}

/// Columns behind have been cut, and rounding is not to cut them once more: otherwise what a block
/// that is looked at for another column holds would depend on where blocks are.
[[gnu::always_inline]] inline ColumnLanes columns(const StraightSight& way, Lanes x, Lanes y) {
  if (way.length == 0) {  // no direction is better than another
    const Lanes distance2 = x * x + y * y;
    return {Lanes{}, distance2, root(distance2)};
  }
  const Lanes u = y * way.dx - x * way.dy;
  ColumnLanes at{x * way.dx + y * way.dy, u * u, way.left * u};
  if (way.begins_behind) {
    at.across2 =
        is_behind(way.behind, at.along, at.along, larger(u, -u)) ? all(kNowhere) : at.across2;
  }
  return at;
}

/// Calls with the number of the first column and where they are, as many as there are lanes.
template <class Do>
void for_columns(const StraightSight& way, const BlockPoints& points, const Do& act) {
  const Lanes x = along_rows(from_origin(points.x, way.x));
  const FourFloats y = from_origin(points.y, way.y);
  for_parts([&](auto part) {
    constexpr int first = decltype(part)::value * static_cast<int>(kLanes);
    act(static_cast<std::size_t>(first), columns(way, x, across_rows<first / kBlockSide>(y)));
  });
}

Lanes lowest(const StraightSight& way, std::span<const EnvelopePiece> pieces,
             const ColumnLanes& at) {
  Lanes low = all(kNowhere);
  for (const EnvelopePiece& piece : pieces) low = smaller(low, piece_low(way, piece, at));
  return low;
}

void lower(const StraightSight& way, std::span<const EnvelopePiece> pieces,
           const BlockPoints& points, BlockValues& low) {
  for_columns(way, points, [&](std::size_t first, const ColumnLanes& at) {
    store(smaller(load(&low[first]), lowest(way, pieces, at)), &low[first]);
  });
}

Lanes bottoms(const Columns::Tile& tile, std::size_t column) {
  return tile.bottoms != nullptr ? load(tile.bottoms + column) : Lanes{};
}

float highest(Lanes of) {
  float most = 0;
  for (std::size_t i = 0; i < kLanes; ++i) most = of[i] > most ? of[i] : most;
  return most;
}

/// One part of a block is lowered.
struct Lowering {
  Lanes before;
  Lanes height;
  Lanes offset;
  LaneInts is_lower;
};

void note_sides(const Lowering& of, std::size_t first, Sides& sides, Lowered& lowered) {
  const LaneInts sided = of.is_lower & (of.offset < all(kNowhere));
  const Lanes bin =
      smaller(larger((of.offset + sides.reach) * sides.bins_per_mm, Lanes{}), all(kMostBin));
  const LaneInts bins = __builtin_convertvector(bin, LaneInts);
  std::memcpy(&lowered.bins[first], &bins, sizeof bins);
  lowered.sided |= bits(sided) << first;
  const auto most = [&](Lanes value, BlockValues& into) {
    store(larger(load(&into[first]), sided ? value : all(-kNowhere)), &into[first]);
  };
  const auto least = [&](Lanes value, BlockValues& into) {
    store(smaller(load(&into[first]), sided ? value : all(kNowhere)), &into[first]);
  };
  most(of.offset, sides.left);
  least(of.offset, sides.right);
  most(of.before, sides.highest);
  least(of.height, sides.lowest);
}

/// `low` gives the surface over columns.
template <class Low>
std::size_t look_at(const StraightSight& way, const Columns::Tile& tile,
                    std::span<const int> blocks, Look* looks, std::size_t* lowered,
                    const Low& low) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const auto column = static_cast<std::size_t>(blocks[k]) * kBlockCells;
    LaneInts lowers{};
    for_columns(way, tile.points(blocks[k]), [&](std::size_t i, const ColumnLanes& at) {
      const Lanes surface = low(at);
      store(surface, &looks[k].low[i]);
      store(at.offset, &looks[k].offsets[i]);
      lowers |= larger(surface, bottoms(tile, column + i)) < load(tile.heights + column + i);
    });
    lowered[count] = k;
    count += static_cast<std::size_t>(bits(lowers) != 0);
  }
  return count;
}

std::size_t look(const StraightSight& way, std::span<const EnvelopePiece> pieces,
                 const Columns::Tile& tile, std::span<const int> blocks, Look* looks,
                 std::size_t* lowered) {
  if (pieces.size() == 1 && is_whole_ball(pieces[0])) {
    const BallLow ball(way, pieces[0]);
    return look_at(way, tile, blocks, looks, lowered,
                   [&](const ColumnLanes& at) { return ball(way, at); });
  }
  return look_at(way, tile, blocks, looks, lowered,
                 [&](const ColumnLanes& at) { return lowest(way, pieces, at); });
}

void own(LaneInts those, std::uint32_t motion, std::uint32_t* owners) {
  LaneInts owner;
  std::memcpy(&owner, owners, sizeof owner);
  owner = those ? LaneInts{} + static_cast<std::int32_t>(motion) : owner;
  std::memcpy(owners, &owner, sizeof owner);
}

void settle(const Look& look, std::uint32_t motion, const Columns::Tile& tile, int block,
            Sides& sides, Lowered& lowered) {
  const auto first = static_cast<std::size_t>(block) * kBlockCells;
  Lanes top{};
  lowered.columns = lowered.sided = 0;
  for (std::size_t i = 0; i < kBlockCells; i += kLanes) {
    const Lanes bottom = bottoms(tile, first + i);
    const Lanes before = load(tile.heights + first + i);
    const Lanes height = larger(load(&look.low[i]), bottom);
    const Lowering of{before, height, load(&look.offsets[i]), height < before};
    const Lanes after = of.is_lower ? height : before;
    store(after, tile.heights + first + i);
    store(before - height, &lowered.by[i]);
    own(of.is_lower, motion, tile.owners + first + i);
    lowered.columns |= bits(of.is_lower) << i;
    note_sides(of, i, sides, lowered);
    top = larger(top, after > bottom ? after : Lanes{});
  }
  tile.block_tops[block] = highest(top);
}

}  // namespace

extern const LaneWork kLaneWork;
const LaneWork kLaneWork{.meets = meets,
                         .places = places,
                         .below = below,
                         .lower = lower,
                         .look = look,
                         .settle = settle};

}  // namespace KERF_LANES
}  // namespace kerf::stock::field
