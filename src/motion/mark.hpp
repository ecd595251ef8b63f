#pragma once

#include <cstdint>

#include "base/block_id.hpp"
#include "motion/motion.hpp"

namespace kerf::motion {

enum class MoveKind : std::uint8_t { rapid, cut, dwell };

/// Which motion a stretch of the path or of time belongs to.
struct Mark {
  base::BlockId block{};
  MoveKind kind = MoveKind::cut;
  float power_percent = 0;           ///< of the laser, while it lasts
  bool power_follows_speed = false;  ///< the percent are those of `speed`
  double pulse_hz = 0;               ///< frequency of the laser; 0: that of the machine
  float speed = 0;                   ///< programmed, mm/s; degrees/s of rotary moves; 0: none
  std::uint32_t tool = 0;            ///< in the spindle
  /// Number of the motion among all that were taken, from 1; 0: none.
  std::uint64_t motion = 0;
};

}  // namespace kerf::motion
