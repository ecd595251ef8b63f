// Compiled for each width of registers: straight ways over the columns of a tile.
#include "stock/field/lane_work.hpp"

#include <algorithm>
#include <utility>

#include "stock/field/lane_pieces.hpp"
#include "stock/field/lanes.hpp"
#include "stock/sweep/outcome.hpp"

namespace kerf::stock::field {
namespace KERF_LANES {
namespace {

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
      tip = pick(is_behind(way.behind, along - way.half_along, along + way.half_along, u),
                 all(kNowhere), tip);
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

/// Calls `is_low(at, over)` for blocks that the tool reaches, `over` being how high the surface is
/// above their tops where the tool has no roundness.
template <class IsLow>
void meet_rows(const StraightSight& way, const RoundFloor& tool, const BlockGrid& grid,
               BlockMasks& met, const IsLow& is_low) {
  const Lanes reach2 = all(tool.reach2);
  const Lanes z = all(tool.z);
  for (std::size_t row = grid.first_y; row < grid.end_y; ++row) {
    const float* const tops = grid.tops + row * kTileBlocks;
    unsigned of_row = 0;
    for_blocks(way, grid, row, [&](std::size_t i, const BlockLanes& at) {
      const Lanes top = load(tops + i);
      const LaneInts is_met =
          (at.distance2 <= reach2) & (top > Lanes{}) & is_low(at, at.tip + z - top);
      of_row |= bits(is_met) << i;
    });
    met[row] = of_row;
  }
}

/// over < √depth2.
LaneInts is_below_root(Lanes over, Lanes depth2) {
  return (over < Lanes{}) | (over * over < depth2);
}

void meets(const StraightSight& way, const RoundFloor& tool, const BlockGrid& grid,
           BlockMasks& met) {
  const Lanes radius2 = all(tool.radius2);
  if (tool.core == 0 && tool.base == 0) {  // a ball
    return meet_rows(way, tool, grid, met, [&](const BlockLanes& at, Lanes over) {
      return is_below_root(over, radius2 - at.distance2);
    });
  }
  meet_rows(way, tool, grid, met, [&](const BlockLanes& at, Lanes over) {
    const Lanes out = larger(root(at.distance2) - tool.core, Lanes{}) - tool.base;
    return is_below_root(over, radius2 - out * out);
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

/// Which columns are behind a leg: none, those before a line, those past a round tool without a
/// flat, those past any tool.
enum class Rear { open, before, past_round, past };

/// Where columns are from a straight way that is not vertical.
///
/// Columns behind have been cut, and rounding is not to cut them once more: otherwise what a block
/// that is looked at for another column holds would depend on where blocks are.
template <Rear rear>
class Beside {
 public:
  explicit Beside(const StraightSight& way)
      : behind_(way.behind),
        dx_(all(way.dx)),
        dy_(all(way.dy)),
        left_(all(way.left)),
        before_(all(way.behind.before)),
        after_(all(way.behind.after)),
        lean_(all(way.behind.lean)),
        lean2_(all(way.behind.lean2)) {}

  [[nodiscard]] ColumnLanes operator()(Lanes x, Lanes y) const {
    const Lanes u = y * dx_ - x * dy_;
    ColumnLanes at{x * dx_ + y * dy_, u * u, left_ * u};
    if constexpr (rear != Rear::open)
      at.across2 = pick(are_behind(at, u), all(kNowhere), at.across2);
    return at;
  }

 private:
  [[nodiscard]] LaneInts are_behind(const ColumnLanes& at, Lanes u) const {
    if constexpr (rear == Rear::before) return at.along < before_;
    if constexpr (rear == Rear::past_round)
      return signed_square(at.along - after_) > lean2_ - lean_ * at.across2;
    return is_behind(behind_, at.along, at.along, size_of(u));
  }

  const Behind& behind_;
  Lanes dx_, dy_, left_, before_, after_, lean_, lean2_;
};

/// No direction is better than another.
struct Around {
  [[nodiscard]] ColumnLanes operator()(Lanes x, Lanes y) const {
    const Lanes distance2 = x * x + y * y;
    return {Lanes{}, distance2, root(distance2)};
  }
};

/// Calls with what says where columns are from the way.
template <class Do>
void with_places(const StraightSight& way, const Do& act) {
  if (way.length == 0) return act(Around{});
  if (!way.begins_behind) return act(Beside<Rear::open>(way));
  if (way.behind.after >= kNowhere) return act(Beside<Rear::before>(way));
  if (way.behind.core == 0) return act(Beside<Rear::past_round>(way));
  act(Beside<Rear::past>(way));
}

/// Calls with the number of the first column and where they are, as many as there are lanes.
template <class Place, class Do>
[[gnu::always_inline]] inline void for_columns(const StraightSight& way, const Place& place,
                                               const BlockPoints& points, const Do& act) {
  const Lanes x = along_rows(from_origin(points.x, way.x));
  const FourFloats y = from_origin(points.y, way.y);
  for_parts([&](auto part) {
    constexpr int first = decltype(part)::value * static_cast<int>(kLanes);
    act(static_cast<std::size_t>(first), place(x, across_rows<first / kBlockSide>(y)));
  });
}

Lanes lowest_of(const StraightSight& way, std::span<const EnvelopePiece> pieces,
                const ColumnLanes& at) {
  Lanes low = all(kNowhere);
  for (const EnvelopePiece& piece : pieces) low = smaller(low, piece_low(way, piece, at));
  return low;
}

void lower(const StraightSight& way, std::span<const EnvelopePiece> pieces,
           const BlockPoints& points, BlockValues& low) {
  with_places(way, [&](const auto& place) {
    for_columns(way, place, points, [&](std::size_t first, const ColumnLanes& at) {
      store(smaller(load(&low[first]), lowest_of(way, pieces, at)), &low[first]);
    });
  });
}

Lanes bottoms(const Columns::Tile& tile, std::size_t column) {
  return tile.bottoms != nullptr ? load(tile.bottoms + column) : Lanes{};
}

/// Blocks of a tile that are looked at, and what is seen there.
struct Looks {
  const Columns::Tile& tile;
  std::span<const int> blocks;
  Look* looks;
  std::size_t* lowered;
};

/// `low` gives the surface over columns.
template <class Place, class Low>
std::size_t look_at(const StraightSight& way, const Looks& of, const Place& place, const Low& low) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < of.blocks.size(); ++k) {
    const auto column = static_cast<std::size_t>(of.blocks[k]) * kBlockCells;
    LaneInts lowers{};
    Look& look = of.looks[k];
    for_columns(
        way, place, of.tile.points(of.blocks[k]), [&](std::size_t i, const ColumnLanes& at) {
          const Lanes surface = low(at);
          store(surface, &look.low[i]);
          store(at.offset, &look.offsets[i]);
          lowers |=
              larger(surface, bottoms(of.tile, column + i)) < load(of.tile.heights + column + i);
        });
    of.lowered[count] = k;
    count += static_cast<std::size_t>(bits(lowers) != 0);
  }
  return count;
}

std::size_t look(const StraightSight& way, std::span<const EnvelopePiece> pieces,
                 const Columns::Tile& tile, std::span<const int> blocks, Look* looks,
                 std::size_t* lowered) {
  const Looks of{tile, blocks, looks, lowered};
  std::size_t count = 0;
  with_places(way, [&](const auto& place) {
    if (pieces.size() == 1 && is_whole_ball(pieces[0])) {
      count = look_at(way, of, place, BallLow(way, pieces[0]));
    } else {
      count = look_at(way, of, place,
                      [&](const ColumnLanes& at) { return lowest_of(way, pieces, at); });
    }
  });
  return count;
}

/// Blocks as they are lowered.
class Settler {
 public:
  Settler(const Columns::Tile& tile, std::uint32_t motion, Taken& taken)
      : tile_(tile),
        taken_(taken),
        motion_(LaneInts{} + static_cast<std::int32_t>(motion)),
        reach_(all(taken.reach)),
        bins_per_mm_(all(taken.bins_per_mm)) {
    std::memcpy(&heights_, taken.heights.data(), sizeof heights_);
  }

  void settle(int block, const Look& look) {
    const auto first = static_cast<std::size_t>(block) * kBlockCells;
    Lanes top{};
    for_parts([&](auto part) {
      constexpr int i = decltype(part)::value * static_cast<int>(kLanes);
      settle_part<i>(first + i, load(&look.low[i]), load(&look.offsets[i]), top);
    });
    tile_.block_tops[block] = highest(top);
    add_to_bins();
  }

  void finish() {
    std::memcpy(taken_.heights.data(), &heights_, sizeof heights_);
    taken_.left = std::max(taken_.left, highest(left_));
    taken_.right = std::min(taken_.right, lowest(right_));
    taken_.highest = std::max(taken_.highest, highest(highest_));
    taken_.lowest = std::min(taken_.lowest, lowest(lowest_));
  }

 private:
  /// Those from `column` on, number i of their block.
  template <int i>
  void settle_part(std::size_t column, Lanes low, Lanes offset, Lanes& top) {
    const Lanes bottom = bottoms(tile_, column);
    const Lanes before = load(tile_.heights + column);
    const Lanes height = larger(low, bottom);
    const LaneInts is_lower = height < before;
    const Lanes after = smaller(height, before);
    store(after, tile_.heights + column);
    own(is_lower, tile_.owners + column);
    top = larger(top, pick(after > bottom, after, Lanes{}));
    const LaneInts is_sided = offset < all(kNowhere);
    see(is_lower & is_sided, offset, before, height);
    sort_out<i>(is_sided, offset, before - after);
  }

  void own(LaneInts those, std::uint32_t* owners) const {
    LaneInts owner;
    std::memcpy(&owner, owners, sizeof owner);
    owner = those ? motion_ : owner;
    std::memcpy(owners, &owner, sizeof owner);
  }

  void see(LaneInts those, Lanes offset, Lanes before, Lanes height) {
    left_ = larger(left_, pick(those, offset, all(-kNowhere)));
    right_ = smaller(right_, pick(those, offset, all(kNowhere)));
    highest_ = larger(highest_, pick(those, before, all(-kNowhere)));
    lowest_ = smaller(lowest_, pick(those, height, all(kNowhere)));
  }

  // What is not lowered goes to its bin as well, by nothing: that takes less than a look whether.
  template <int i>
  void sort_out(LaneInts those, Lanes offset, Lanes by) {
    const Lanes place = smaller(larger((offset + reach_) * bins_per_mm_, Lanes{}), all(kLastBin));
    const LaneInts bins = those ? __builtin_convertvector(place, LaneInts) : LaneInts{} + kNoBin;
    std::memcpy(&bins_[i], &bins, sizeof bins);
    add_doubles<0>(by, &by_[i], heights_);
    if constexpr (kLanes == 8) add_doubles<4>(by, &by_[i + 4], heights_);
  }

  // Columns that are neighbours have the same bin, and a sum takes long to be there for the next
  // one to be added: so along diagonals, and to two sums in turn.
  void add_to_bins() {
    for (std::size_t diagonal = 0; diagonal < kBlockSide; ++diagonal) {
      for (std::size_t row = 0; row < kBlockSide; ++row) {
        const std::size_t i = row * kBlockSide + (row + diagonal) % kBlockSide;
        taken_.across[diagonal % 2][bins_[i]] += by_[i];
      }
    }
  }

  static constexpr float kLastBin = Outcome::kBins - 1.0F;
  static constexpr std::int32_t kNoBin = Outcome::kBins;

  const Columns::Tile& tile_;
  Taken& taken_;
  LaneInts motion_;
  Lanes reach_, bins_per_mm_;
  FourDoubles heights_{};
  Lanes left_ = all(-kNowhere), right_ = all(kNowhere);
  Lanes highest_ = all(-kNowhere), lowest_ = all(kNowhere);
  std::array<double, kBlockCells> by_{};  // of the block
  std::array<std::uint32_t, kBlockCells> bins_{};
};

void settle(const Columns::Tile& tile, std::uint32_t motion, std::span<const int> blocks,
            const Look* looks, std::span<const std::size_t> lowered, Taken& taken) {
  Settler settler(tile, motion, taken);
  for (const std::size_t k : lowered) settler.settle(blocks[k], looks[k]);
  settler.finish();
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
