#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "stock/sweep/way.hpp"

namespace kerf::stock {

/// Material that hangs together.
struct Piece {
  static constexpr std::size_t kMostCutBy = 256;

  double volume_mm3 = 0;
  Bounds extents;
  bool held = true;  ///< by what the stock is clamped in
  /// Of one that is not held: the motions that left its faces, rising; of very many the last ones.
  std::vector<std::uint32_t> cut_by{};
};

}  // namespace kerf::stock
