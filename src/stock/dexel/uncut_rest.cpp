#include "stock/dexel/uncut_rest.hpp"

namespace kerf::stock::dexel {

UncutRest::UncutRest(const Tile& tile, int column, int row, Tile::Stretch within, float margin_mm)
    : margin_(margin_mm) {
  low_.fill(Glance::Four{1, 1, 1, 1});
  high_.fill(Glance::Four{-1, -1, -1, -1});
  const int last = std::min(column + Glance::kLines, tile.columns());
  for (int i = column; i < last; ++i) {
    const auto ends = tile.ends(tile.index(i, row));
    for (std::size_t k = 0; k < ends.size(); k += 2) {
      if (ends[k + 1].at < within.low || ends[k].at > within.high) continue;
      add(static_cast<std::size_t>(i - column), std::max(ends[k].at, within.low),
          std::min(ends[k + 1].at, within.high));
    }
  }
}

void UncutRest::add(std::size_t i, float low, float high) {
  std::size_t& count = counts_[i];
  if (count == kMost) {
    low_[kMost - 1][i] = std::min(low_[kMost - 1][i], low);
    high_[kMost - 1][i] = std::max(high_[kMost - 1][i], high);
    return;
  }
  low_[count][i] = low;
  high_[count][i] = high;
  ++count;
}

void UncutRest::take_away(std::size_t i, float low, float high) {
  const float from = low + margin_;
  const float to = high - margin_;
  if (!(from < to)) return;
  std::array<Tile::Stretch, kMost> before;
  const std::size_t count = counts_[i];
  for (std::size_t k = 0; k < count; ++k) {
    before[k] = {low_[k][i], high_[k][i]};
    low_[k][i] = 1;
    high_[k][i] = -1;
  }
  counts_[i] = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const auto [a, b] = before[k];
    const bool is_all = from <= a && b <= to;
    if (is_all) continue;
    if (from >= b || to <= a) {
      add(i, a, b);
      continue;
    }
    if (a < from) add(i, a, from);
    if (to < b) add(i, to, b);
  }
}

}  // namespace kerf::stock::dexel
