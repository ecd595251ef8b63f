#pragma once

#include <cstdint>
#include <limits>

namespace kerf::stock {

/// What a tool did in a run.
struct ToolRecord {
  std::uint32_t tool = 0;
  double cut_mm = 0;  ///< of moves at feed that removed material
  double air_mm = 0;  ///< of the others at feed
  double removed_mm3 = 0;
  double lowest = std::numeric_limits<double>::infinity();  ///< of the tip in moves that removed, Z
                                                            ///< of the stock
};

}  // namespace kerf::stock
