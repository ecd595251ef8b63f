#pragma once

#include <array>
#include <cstdint>

#include "stock/field/columns.hpp"
#include "stock/field/contact_rule.hpp"
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
  using Material = std::array<Span, kBlockCells>;  ///< of a block, frame of the stock

  template <class Do>
  void for_blocks(const auto& leg, const LowerEnvelope& tool, const Do& act);
  void guard(const ReadySweep& sweep, ToolPart part, Blocks& met);
  void cut_by(const auto& leg, const ReadySweep& sweep, const Blocks& met, Tally& tally);
  static void take_by_core(const auto& leg, const FieldTool& tool, const BlockPoints& at,
                           const Material& material, Tally& tally);
  static void settle_core(const ReadySweep& sweep, const BlockPoints& at, Material material,
                          Tally& tally);
  void settle(const ReadySweep& sweep, int block, Tally& tally);
  void lower(int block, const BlockValues& low, std::uint32_t motion, Tally& tally,
             const auto& offset_of);

  [[nodiscard]] Range range(double low, double high, double first, double size) const;
  [[nodiscard]] BlockRow row(int by) const;
  [[nodiscard]] Material material(int block) const;
  [[nodiscard]] double bottom(std::size_t cell) const {
    return tile_.bottoms != nullptr ? static_cast<double>(tile_.bottoms[cell]) : 0.0;
  }

  Columns& columns_;
  std::size_t index_;
  Columns::Tile tile_;
  double base_;  // heights are over this
  double block_x_, block_y_;
  double radius_;  // of a block
  std::uint64_t changes_ = 0;
};

}  // namespace kerf::stock::field
