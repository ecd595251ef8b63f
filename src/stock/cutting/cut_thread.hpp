#pragma once

#include <cstdint>

#include "base/block_id.hpp"
#include "stock/sweep/way.hpp"
#include "stock/tool/tool.hpp"

namespace kerf::stock {

/// A thread that a tap or a thread mill has cut (stock.md §4.5): mm, frame of the stock; major and
/// minor are diameters.
struct CutThread {
  base::BlockId block;       ///< that began it
  std::uint32_t motion = 0;  ///< likewise
  std::uint32_t tool = 0;
  Vec3 from;  ///< on its axis: where it begins in the material, and ends
  Vec3 to;
  double major = 0;
  double minor = 0;
  double pitch = 0;
  int starts = 1;
  Hand hand = Hand::right;
  bool is_inside = true;   ///< in a hole
  bool is_milled = false;  ///< its groove is cut into the part; of a tap the hole alone is
  /// Milled: what was removed. Of a tap the section of the groove times the way of its centroid
  /// round the axis, times the turns.
  double volume_mm3 = 0;
};

}  // namespace kerf::stock
