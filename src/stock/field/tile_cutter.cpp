#include "stock/field/tile_cutter.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "stock/field/settling.hpp"

namespace kerf::stock::field {
namespace {

constexpr std::size_t kBlocksAtOnce = 32;
constexpr double kHalfBlock = (kBlockSide - 1) / 2.0;

/// Of a row of blocks those from one to another.
unsigned between(int first, int last) { return (2U << last) - (1U << first); }

}  // namespace

TileCutter::TileCutter(Columns& columns, std::size_t tile)
    : columns_(columns),
      index_(tile),
      tile_(columns.tile(tile)),
      base_(columns.grid().box.low.z),
      half_{kHalfBlock * columns.grid().cell_x(), kHalfBlock * columns.grid().cell_y()} {
  for (std::size_t i = 0; i < kTileBlocks; ++i) {
    const std::size_t first = i * kBlockSide;
    const std::size_t last = first + kBlockSide - 1;
    block_x_[i] = static_cast<float>((tile_.x[first] + tile_.x[last]) / 2 - tile_.x[0]);
    block_y_[i] = (tile_.y[first] + tile_.y[last]) / 2;
  }
}

TileCutter::~TileCutter() { columns_.changed(index_, changes_); }

void TileCutter::cut(const ReadySweep& sweep, Tally& tally) {
  Blocks met{};
  bool any_met = false;
  for (std::size_t i = 0; i < kToolParts; ++i) {
    any_met |= guard(sweep, static_cast<ToolPart>(i), met);
  }
  if (sweep.cuts) {
    for_each_leg(sweep.legs, [&](const auto& leg) { cut_by(leg, sweep, met, tally); });
  }
  for (int block = 0; any_met && block < kTileBlocks * kTileBlocks; ++block) {
    if (is_in(met, block)) settle(sweep, block, tally);
  }
  if (tally.has_removed()) ++changes_;
}

bool TileCutter::guard(const ReadySweep& sweep, ToolPart part, Blocks& met) {
  const LowerEnvelope& body = sweep.tool->part(part).shrunk;
  if (!sweep.guards(part) || body.is_empty()) return false;
  if (sweep.tip.low.z + body.lowest() - base_ >= columns_.top_of(index_)) return false;
  bool any = false;
  for_each_leg(sweep.legs, [&](const auto& leg) {
    for_blocks(leg.view(body, base_, half_), around(leg.box(), body.reach()), [&](int block) {
      met[static_cast<std::size_t>(block / kTileBlocks)] |=
          static_cast<std::uint16_t>(1U << (block % kTileBlocks));
      any = true;
    });
  });
  return any;
}

/// Calls with each block that the leg may lower, or meet.
template <class Do>
void TileCutter::for_blocks(const auto& view, const Bounds& reached, const Do& act) {
  const Grid& grid = columns_.grid();
  const Range across = range(reached.low.x, reached.high.x, tile_.x[0], kBlockSide * grid.cell_x());
  const Range rows = range(reached.low.y, reached.high.y, tile_.y[0], kBlockSide * grid.cell_y());
  if (across.first > across.last || rows.first > rows.last) return;
  const BlockGrid blocks{.x = block_x_.data(),
                         .y = block_y_.data(),
                         .tops = tile_.block_tops,
                         .origin_x = tile_.x[0],
                         .half = half_,
                         .first_x = static_cast<std::size_t>(across.first),
                         .end_x = static_cast<std::size_t>(across.last) + 1,
                         .first_y = static_cast<std::size_t>(rows.first),
                         .end_y = static_cast<std::size_t>(rows.last) + 1};
  BlockMasks met;
  view.meets(blocks, met);
  const unsigned asked = between(across.first, across.last);
  for (int by = rows.first; by <= rows.last; ++by) {
    for (unsigned left = met[static_cast<std::size_t>(by)] & asked; left != 0; left &= left - 1)
      act(by * kTileBlocks + std::countr_zero(left));
  }
}

TileCutter::Range TileCutter::range(double low, double high, double first, double size) const {
  // As rounding down: what is less than 0 becomes -1.
  const auto block = [&](double at) {
    return static_cast<int>(std::clamp((at - first) / size + 1, 0.0, kTileBlocks + 1.0)) - 1;
  };
  // The columns of a block lie within 3/4 of its size from the first one.
  return {std::max(0, block(low)), std::min(kTileBlocks - 1, block(high))};
}

void TileCutter::cut_by(const auto& leg, const ReadySweep& sweep, const Blocks& met, Tally& tally) {
  const LowerEnvelope& edges = sweep.tool->edges();
  const auto view = leg.view(edges, base_, half_);
  std::array<int, kBlocksAtOnce> blocks;
  std::size_t count = 0;
  const bool is_all = !std::holds_alternative<std::vector<StraightLeg>>(sweep.legs);
  const Bounds reached = is_all ? sweep.reached : leg.reached(edges);
  for_blocks(view, reached, [&](int block) {
    if (is_in(met, block)) return;
    blocks[count++] = block;
    if (count < kBlocksAtOnce) return;
    cut_blocks(blocks, leg, view, sweep, tally);
    count = 0;
  });
  cut_blocks({blocks.data(), count}, leg, view, sweep, tally);
}

/// First all of them are looked at, then those are taken down that are lowered: which ones no
/// processor can foresee, and it would begin each look anew.
void TileCutter::cut_blocks(std::span<const int> blocks, const auto& leg, const auto& view,
                            const ReadySweep& sweep, Tally& tally) {
  if (sweep.tool->core_mm > 0) {
    for (const int block : blocks)
      take_by_core(leg, *sweep.tool, tile_.points(block), material(block), tally);
  }
  std::array<Look, kBlocksAtOnce> looks;
  std::array<std::size_t, kBlocksAtOnce + 1> lowered;
  const std::size_t count = view.look(tile_, blocks, looks.data(), lowered.data());
  tally.visit(blocks.size() * kBlockCells);
  lane_work().settle(tile_, sweep.motion, blocks, looks.data(), {lowered.data(), count},
                     tally.taken());
}

TileCutter::Material TileCutter::material(int block) const {
  Material all;
  const std::size_t first = static_cast<std::size_t>(block) * kBlockCells;
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    all[i] = {static_cast<double>(bottom(first + i)),
              static_cast<double>(tile_.heights[first + i])};
  }
  return all;
}

void TileCutter::take_by_core(const auto& leg, const FieldTool& tool, const BlockPoints& at,
                              const Material& material, Tally& tally) const {
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    const auto [bottom, top] = material[i];
    const double taken = leg.taken_by_core(tool.core_mm, at.x_of(i), at.y_of(i), base_ + top);
    tally.take_by_core(std::min(taken, top - bottom));
  }
}

/// As the core takes it, with what the legs before have left.
void TileCutter::settle_core(const ReadySweep& sweep, const BlockPoints& at, Material material,
                             Tally& tally) const {
  for_each_leg(sweep.legs, [&](const auto& leg) {
    take_by_core(leg, *sweep.tool, at, material, tally);
    BlockValues low;
    low.fill(kNowhere);
    leg.view(sweep.tool->edges(), base_, half_).lower(at, low);
    for (std::size_t i = 0; i < kBlockCells; ++i) {
      material[i].high =
          std::max(material[i].low, std::min(material[i].high, static_cast<double>(low[i])));
    }
  });
}

void TileCutter::settle(const ReadySweep& sweep, int block, Tally& tally) {
  const BlockPoints at = tile_.points(block);
  const Material all = material(block);
  const Settling settling(sweep, at, base_);
  tally.visit(kBlockCells);
  if (sweep.cuts && sweep.tool->core_mm > 0) settle_core(sweep, at, all, tally);
  Look look{.low = {}, .offsets = settling.offsets()};
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    double lowest = settling.edges_low(i);
    for (std::size_t p = 0; p < kToolParts; ++p) {
      const auto part = static_cast<ToolPart>(p);
      const Meeting met = settling.meets(part, i, all[i]);
      if (met.depth_mm <= 0) continue;
      tally.meet(part, {at.x_of(i), at.y_of(i), base_ + met.z}, met.depth_mm);
      lowest = std::min(lowest, settling.part_low(part, i));
    }
    look.low[i] = static_cast<float>(lowest);
  }
  constexpr std::size_t kThis = 0;
  lane_work().settle(tile_, sweep.motion, {&block, 1}, &look, {&kThis, 1}, tally.taken());
}

}  // namespace kerf::stock::field
