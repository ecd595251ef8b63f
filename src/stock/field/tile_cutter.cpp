#include "stock/field/tile_cutter.hpp"

#include <algorithm>
#include <cmath>

#include "stock/field/settling.hpp"

namespace kerf::stock::field {
namespace {

constexpr double kHalfBlock = (kBlockSide - 1) / 2.0;

}  // namespace

TileCutter::TileCutter(Columns& columns, std::size_t tile)
    : columns_(columns),
      index_(tile),
      tile_(columns.tile(tile)),
      base_(columns.grid().box.low.z),
      block_x_(kBlockSide * columns.grid().cell_x()),
      block_y_(kBlockSide * columns.grid().cell_y()),
      radius_(kHalfBlock * math::hypot(columns.grid().cell_x(), columns.grid().cell_y())) {}

TileCutter::~TileCutter() { columns_.changed(index_, changes_); }

void TileCutter::cut(const ReadySweep& sweep, Tally& tally) {
  Blocks met{};
  for (std::size_t i = 0; i < kToolParts; ++i) {
    guard(sweep, static_cast<ToolPart>(i), met);
  }
  if (sweep.cuts) {
    for_each_leg(sweep.legs, [&](const auto& leg) { cut_by(leg, sweep, met, tally); });
  }
  for (int block = 0; block < kTileBlocks * kTileBlocks; ++block) {
    const unsigned row = met[static_cast<std::size_t>(block / kTileBlocks)];
    if ((row >> (block % kTileBlocks) & 1U) != 0) settle(sweep, block, tally);
  }
  if (tally.has_removed()) ++changes_;
}

void TileCutter::guard(const ReadySweep& sweep, ToolPart part, Blocks& met) {
  const LowerEnvelope& body = sweep.tool->part(part).shrunk;
  if (!sweep.guards(part) || body.is_empty()) return;
  if (sweep.tip.low.z + body.lowest() - base_ >= columns_.top_of(index_)) return;
  for_each_leg(sweep.legs, [&](const auto& leg) {
    for_blocks(leg, body, [&](int block) {
      met[static_cast<std::size_t>(block / kTileBlocks)] |=
          static_cast<std::uint16_t>(1U << (block % kTileBlocks));
    });
  });
}

/// Calls with each block that the leg may lower, or meet.
template <class Do>
void TileCutter::for_blocks(const auto& leg, const LowerEnvelope& tool, const Do& act) {
  const double reach = tool.reach();
  const Bounds& box = leg.box();
  const Range across = range(box.low.x - reach, box.high.x + reach, tile_.x[0], block_x_);
  const Range rows = range(box.low.y - reach, box.high.y + reach, tile_.y[0], block_y_);
  if (across.first > across.last) return;
  for (int by = rows.first; by <= rows.last; ++by) {
    RowValues lowest;
    leg.bound(tool, row(by), lowest);
    for (int bx = across.first; bx <= across.last; ++bx) {
      const int block = by * kTileBlocks + bx;
      const auto top = static_cast<double>(tile_.block_tops[block]);
      if (std::max(0.0, lowest[static_cast<std::size_t>(bx)] - base_) < top) act(block);
    }
  }
}

TileCutter::Range TileCutter::range(double low, double high, double first, double size) const {
  const auto block = [&](double at) {
    return static_cast<int>(std::clamp(std::floor((at - first) / size), -1.0, kTileBlocks + 0.0));
  };
  // The columns of a block lie within 3/4 of its size from the first one.
  return {std::max(0, block(low)), std::min(kTileBlocks - 1, block(high))};
}

BlockRow TileCutter::row(int by) const {
  BlockRow row;
  const double half_x = (tile_.x[kBlockSide - 1] - tile_.x[0]) / 2;
  for (std::size_t bx = 0; bx < kTileBlocks; ++bx) row.x[bx] = tile_.x[bx * kBlockSide] + half_x;
  row.y = (tile_.y[by * kBlockSide] + tile_.y[by * kBlockSide + kBlockSide - 1]) / 2;
  row.radius = radius_;
  return row;
}

void TileCutter::cut_by(const auto& leg, const ReadySweep& sweep, const Blocks& met, Tally& tally) {
  const LowerEnvelope& edges = sweep.tool->edges();
  for_blocks(leg, edges, [&](int block) {
    if ((met[static_cast<std::size_t>(block / kTileBlocks)] >> (block % kTileBlocks) & 1U) != 0) {
      return;
    }
    const BlockPoints at = columns_.points(index_, block);
    BlockValues low;
    low.fill(kNowhere);
    leg.lower(edges, at, low);
    tally.visit(kBlockCells);
    if (sweep.tool->core_mm > 0) take_by_core(leg, *sweep.tool, at, material(block), tally);
    lower(block, low, sweep.motion, tally,
          [&](std::size_t i) { return leg.has_sides() ? leg.offset(at.x[i], at.y[i]) : kNowhere; });
  });
}

TileCutter::Material TileCutter::material(int block) const {
  Material all;
  const std::size_t first = static_cast<std::size_t>(block) * kBlockCells;
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    all[i] = {base_ + bottom(first + i), base_ + static_cast<double>(tile_.heights[first + i])};
  }
  return all;
}

void TileCutter::take_by_core(const auto& leg, const FieldTool& tool, const BlockPoints& at,
                              const Material& material, Tally& tally) {
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    const auto [bottom, top] = material[i];
    const double taken = leg.taken_by_core(tool.core_mm, at.x[i], at.y[i], top);
    tally.take_by_core(std::min(taken, top - bottom));
  }
}

/// As the core takes it, with what the legs before have left.
void TileCutter::settle_core(const ReadySweep& sweep, const BlockPoints& at, Material material,
                             Tally& tally) {
  for_each_leg(sweep.legs, [&](const auto& leg) {
    take_by_core(leg, *sweep.tool, at, material, tally);
    BlockValues low;
    low.fill(kNowhere);
    leg.lower(sweep.tool->edges(), at, low);
    for (std::size_t i = 0; i < kBlockCells; ++i) {
      material[i].high = std::max(material[i].low, std::min(material[i].high, low[i]));
    }
  });
}

void TileCutter::settle(const ReadySweep& sweep, int block, Tally& tally) {
  const BlockPoints at = columns_.points(index_, block);
  const Material all = material(block);
  const Settling settling(sweep, at);
  tally.visit(kBlockCells);
  if (sweep.cuts && sweep.tool->core_mm > 0) settle_core(sweep, at, all, tally);
  BlockValues low;
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    low[i] = settling.edges_low(i);
    for (std::size_t p = 0; p < kToolParts; ++p) {
      const auto part = static_cast<ToolPart>(p);
      const Meeting met = settling.meets(part, i, all[i]);
      if (met.depth_mm <= 0) continue;
      tally.meet(part, {at.x[i], at.y[i], met.z}, met.depth_mm);
      low[i] = std::min(low[i], settling.part_low(part, i));
    }
  }
  lower(block, low, sweep.motion, tally, [&](std::size_t i) { return settling.offset(i); });
}

void TileCutter::lower(int block, const BlockValues& low, std::uint32_t motion, Tally& tally,
                       const auto& offset_of) {
  const std::size_t first = static_cast<std::size_t>(block) * kBlockCells;
  float* heights = tile_.heights + first;
  std::array<float, kBlockCells> fresh;
  bool any = false;
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    const double over = std::min(std::max(low[i] - base_, bottom(first + i)), kNowhere);
    const auto height = static_cast<float>(over);
    any |= height < heights[i];
    fresh[i] = height < heights[i] ? height : heights[i];
  }
  if (!any) return;
  float top = 0;
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    const double removed = static_cast<double>(heights[i]) - static_cast<double>(fresh[i]);
    if (removed > 0) {
      const double offset = offset_of(i);
      offset < kNowhere ? tally.remove_at(offset, removed) : tally.remove(removed);
      heights[i] = fresh[i];
      tile_.owners[first + i] = motion;
    }
    if (static_cast<double>(fresh[i]) > bottom(first + i)) top = std::max(top, fresh[i]);
  }
  tile_.block_tops[block] = top;
}

}  // namespace kerf::stock::field
