#include "stock/dexel/late_normals.hpp"

#include <algorithm>

#include "stock/dexel/passage.hpp"

namespace kerf::stock::dexel {

std::uint16_t LateNormals::begin(const Frame& frame, const PosedSolid& solid,
                                 const Stroke& stroke) {
  if (cuts_.size() == kMostCuts) settle();
  // Of one that left nothing the place is free.
  if (cuts_.empty() || has_left_ends_) cuts_.emplace_back();
  cuts_.back() = {&frame, &solid, &stroke};
  has_left_ends_ = false;
  return static_cast<std::uint16_t>(cuts_.size());
}

void LateNormals::note(int column, int row) {
  has_left_ends_ = true;
  const std::size_t block =
      tile_.index(column / Tile::kBlock * Tile::kBlock, row / Tile::kBlock * Tile::kBlock);
  if (is_open_.empty()) is_open_.resize(tile_.count());
  if (is_open_[block]) return;
  is_open_[block] = true;
  open_.push_back(block);
}

void LateNormals::settle() {
  for (const std::size_t block : open_) {
    settle_block(static_cast<int>(block) % tile_.columns(),
                 static_cast<int>(block) / tile_.columns());
    is_open_[block] = false;
  }
  open_.clear();
  cuts_.clear();
}

void LateNormals::settle_block(int column, int row) {
  for (int r = row; r < std::min(row + Tile::kBlock, tile_.rows()); ++r) {
    for (int i = column; i < std::min(column + Tile::kBlock, tile_.columns()); ++i) {
      tile_.each_end(tile_.index(i, r), [&](DexelEnd& end, std::size_t number) {
        if (end.spare != 0) end = settled(end, place_.b_of(i), place_.c_of(r), number % 2 == 0);
      });
    }
  }
}

/// Material begins where the tool ends, and looks towards it.
DexelEnd LateNormals::settled(DexelEnd end, double b, double c, bool begins) const {
  const Cut& cut = cuts_[end.spare - std::size_t{1}];
  const Passage passage(cut.solid->solid, *cut.frame, cut.stroke->from, cut.stroke->way,
                        place_.lattice.axis);
  Meeting m;
  if (passage.meet(b, c, m))
    end.normal = octahedral(-1.0 * passage.normal(begins ? m.high : m.low, b, c));
  end.spare = 0;
  return end;
}

}  // namespace kerf::stock::dexel
