#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "stock/field/columns.hpp"
#include "stock/field/contact_rule.hpp"
#include "stock/field/lane_work.hpp"
#include "stock/field/ready_sweep.hpp"
#include "stock/field/tally.hpp"

namespace kerf::stock::field {

/// Does sweeps to one tile, in their order. Blocks whose highest column lies below the lowest
/// surface that a sweep can have over them are not visited.
class TileCutter {
 public:
  TileCutter(Columns& columns, std::size_t tile);
  ~TileCutter();  ///< tells the columns what has changed
  TileCutter(const TileCutter&) = delete;
  TileCutter& operator=(const TileCutter&) = delete;

  void cut(const ReadySweep& sweep, Tally& tally);

 private:
  /// Blocks of the tile, by rows: those that must not be met may be, and are looked at whole.
  using Blocks = std::array<std::uint16_t, kTileBlocks>;
  struct Range {
    int first;
    int last;
  };
  using Material = std::array<Span, kBlockCells>;  ///< of a block, over the box

  [[nodiscard]] static bool is_in(const Blocks& blocks, int block) {
    const unsigned row = blocks[static_cast<std::size_t>(block / kTileBlocks)];
    return (row >> (block % kTileBlocks) & 1U) != 0;
  }
  template <class Do>
  void for_blocks(const auto& view, const Bounds& reached, const Do& act);
  bool guard(const ReadySweep& sweep, ToolPart part, Blocks& met);
  void cut_by(const auto& leg, const ReadySweep& sweep, const Blocks& met, Tally& tally);
  void cut_blocks(std::span<const int> blocks, const auto& leg, const auto& view,
                  const ReadySweep& sweep, Tally& tally);
  void take_by_core(const auto& leg, const FieldTool& tool, const BlockPoints& at,
                    const Material& material, Tally& tally) const;
  void settle_core(const ReadySweep& sweep, const BlockPoints& at, Material material,
                   Tally& tally) const;
  void settle(const ReadySweep& sweep, int block, Tally& tally);
  [[nodiscard]] Range range(double low, double high, double first, double size) const;
  [[nodiscard]] Material material(int block) const;
  [[nodiscard]] float bottom(std::size_t cell) const {
    return tile_.bottoms != nullptr ? tile_.bottoms[cell] : 0.0F;
  }

  Columns& columns_;
  std::size_t index_;
  Columns::Tile tile_;
  std::array<float, kTileBlocks> block_x_;  // from the first column
  std::array<double, kTileBlocks> block_y_;
  double base_;  // heights are over this
  HalfBlock half_;
  std::uint64_t changes_ = 0;
};

}  // namespace kerf::stock::field
