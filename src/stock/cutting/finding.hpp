#pragma once

#include <cstdint>
#include <string>

#include "base/block_id.hpp"
#include "base/diagnostic_code.hpp"
#include "stock/sweep/way.hpp"

namespace kerf::stock {

/// What a check has against a block. mm, frame of the stock.
struct Finding {
  base::Code code{};
  std::string detail{};   ///< behind the code's own words: which part, by how much
  base::BlockId block{};  ///< none: the whole run
  std::uint32_t tool = 0;
  std::uint64_t motion = 0;  ///< that went deepest
  Vec3 at{};                 ///< the deepest place
  double depth_mm = 0;       ///< there
  double volume_mm3 = 0;     ///< of all
  double excess = 0;         ///< of what exceeds a limit: by which factor
  std::uint64_t count = 1;   ///< motions that had it
  double time_s = 0;         ///< when the motion ends, s of the run; 0: not known
};

}  // namespace kerf::stock
