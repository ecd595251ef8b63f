#include "stock/field/tile_cutter.hpp"

#include <algorithm>
#include <cmath>

#include "stock/field/lanes.hpp"
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
      half_x_(kHalfBlock * columns.grid().cell_x()),
      half_y_(kHalfBlock * columns.grid().cell_y()) {
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
    for_blocks(leg, body, [&](int block) {
      met[static_cast<std::size_t>(block / kTileBlocks)] |=
          static_cast<std::uint16_t>(1U << (block % kTileBlocks));
      any = true;
    });
  });
  return any;
}

/// Calls with each block that the leg may lower, or meet.
template <class Do>
void TileCutter::for_blocks(const auto& leg, const LowerEnvelope& tool, const Do& act) {
  const Grid& grid = columns_.grid();
  const double reach = tool.reach();
  const Bounds& box = leg.box();
  const Range across =
      range(box.low.x - reach, box.high.x + reach, tile_.x[0], kBlockSide * grid.cell_x());
  const Range rows =
      range(box.low.y - reach, box.high.y + reach, tile_.y[0], kBlockSide * grid.cell_y());
  if (across.first > across.last) return;
  BlockRow row{block_x_.data(), tile_.x[0], 0, half_x_, half_y_};
  row.first = static_cast<std::size_t>(across.first) / kLanes * kLanes;
  row.last = (static_cast<std::size_t>(across.last) / kLanes + 1) * kLanes;
  RowValues lowest;
  for (int by = rows.first; by <= rows.last; ++by) {
    row.y = block_y_[static_cast<std::size_t>(by)];
    leg.bound(tool, row, base_, lowest);
    const float* tops = tile_.block_tops + by * kTileBlocks;
    for (int bx = across.first; bx <= across.last; ++bx) {
      if (larger(0.0F, lowest[static_cast<std::size_t>(bx)]) < tops[bx]) {
        act(by * kTileBlocks + bx);
      }
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

void TileCutter::cut_by(const auto& leg, const ReadySweep& sweep, const Blocks& met, Tally& tally) {
  for_blocks(leg, sweep.tool->edges(), [&](int block) {
    if (is_in(met, block)) return;
    const BlockPoints at = columns_.points(index_, block);
    BlockValues low;
    low.fill(kNowhere);
    leg.lower(sweep.tool->edges(), at, base_, low);
    tally.visit(kBlockCells);
    if (sweep.tool->core_mm > 0) take_by_core(leg, *sweep.tool, at, material(block), tally);
    if (!lowers(block, low)) return;
    BlockValues offsets;
    offsets.fill(kNowhere);
    leg.offsets(at, offsets);
    lower(block, low, sweep.motion, offsets, tally);
  });
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
    leg.lower(sweep.tool->edges(), at, base_, low);
    for (std::size_t i = 0; i < kBlockCells; ++i) {
      material[i].high =
          std::max(material[i].low, std::min(material[i].high, static_cast<double>(low[i])));
    }
  });
}

void TileCutter::settle(const ReadySweep& sweep, int block, Tally& tally) {
  const BlockPoints at = columns_.points(index_, block);
  const Material all = material(block);
  const Settling settling(sweep, at, base_);
  tally.visit(kBlockCells);
  if (sweep.cuts && sweep.tool->core_mm > 0) settle_core(sweep, at, all, tally);
  BlockValues low;
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    double lowest = settling.edges_low(i);
    for (std::size_t p = 0; p < kToolParts; ++p) {
      const auto part = static_cast<ToolPart>(p);
      const Meeting met = settling.meets(part, i, all[i]);
      if (met.depth_mm <= 0) continue;
      tally.meet(part, {at.x_of(i), at.y_of(i), base_ + met.z}, met.depth_mm);
      lowest = std::min(lowest, settling.part_low(part, i));
    }
    low[i] = static_cast<float>(lowest);
  }
  if (lowers(block, low)) lower(block, low, sweep.motion, settling.offsets(), tally);
}

bool TileCutter::lowers(int block, const BlockValues& low) const {
  const std::size_t first = static_cast<std::size_t>(block) * kBlockCells;
  const float* heights = tile_.heights + first;
  int lowered = 0;
  for (std::size_t i = 0; i < kBlockCells; ++i) lowered |= low[i] < heights[i] ? 1 : 0;
  return lowered != 0;
}

void TileCutter::lower(int block, const BlockValues& low, std::uint32_t motion,
                       const BlockValues& offsets, Tally& tally) {
  const std::size_t first = static_cast<std::size_t>(block) * kBlockCells;
  float* heights = tile_.heights + first;
  float top = 0;
  for (std::size_t i = 0; i < kBlockCells; ++i) {
    const float bottom = this->bottom(first + i);
    const float height = std::max(low[i], bottom);
    if (height < heights[i]) {
      tally.remove(offsets[i], heights[i], height);
      heights[i] = height;
      tile_.owners[first + i] = motion;
    }
    if (heights[i] > bottom) top = std::max(top, heights[i]);
  }
  tile_.block_tops[block] = top;
}

}  // namespace kerf::stock::field
