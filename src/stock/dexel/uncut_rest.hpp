#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "stock/dexel/glance.hpp"
#include "stock/dexel/tile.hpp"

namespace kerf::stock::dexel {

/// Of four dexels in a row the material that no cut so far passes over, in a few pieces each; where
/// there would be more, some hold what lies between them as well.
class UncutRest {
 public:
  /// Of the dexels from one column on, between two places. `margin_mm`: what a cut takes off here
  /// is less by so much on both sides, so that what is left out changes no end.
  UncutRest(const Tile& tile, int column, int row, Tile::Stretch within, float margin_mm);

  /// Pieces i of all dexels, for i below this; low > high where a dexel has none.
  [[nodiscard]] std::size_t layers() const {
    return *std::max_element(counts_.begin(), counts_.end());
  }
  [[nodiscard]] Glance::Four low(std::size_t layer) const { return low_[layer]; }
  [[nodiscard]] Glance::Four high(std::size_t layer) const { return high_[layer]; }

  /// Whether is_one(low, high) holds for any piece of dexel i.
  template <class IsOne>
  [[nodiscard]] bool has_piece(std::size_t i, IsOne&& is_one) const {
    for (std::size_t k = 0; k < counts_[i]; ++k) {
      if (is_one(double{low_[k][i]}, double{high_[k][i]})) return true;
    }
    return false;
  }
  [[nodiscard]] bool reaches(std::size_t i, float low, float high) const {
    return has_piece(
        i, [&](double from, double to) { return from <= double{high} && double{low} <= to; });
  }
  void take_away(std::size_t i, float low, float high);

 private:
  static constexpr std::size_t kMost = 4;

  void add(std::size_t i, float low, float high);

  float margin_;
  std::array<Glance::Four, kMost> low_;
  std::array<Glance::Four, kMost> high_;
  std::array<std::size_t, Glance::kLines> counts_{};
};

}  // namespace kerf::stock::dexel
