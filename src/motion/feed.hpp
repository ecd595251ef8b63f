#pragma once

#include "motion/motion.hpp"

namespace kerf::motion {

inline constexpr double kMillimetresPerInch = 25.4;
inline constexpr double kSecondsPerMinute = 60;  ///< mm/min outside, mm/s inside

/// mm/min of a move of this length while the spindle has this speed.
inline double feed_per_minute(const Feed& feed, double length_mm, double speed_rpm) {
  switch (feed.mode) {
    case FeedMode::per_minute: return feed.value;
    case FeedMode::per_revolution: return feed.value * speed_rpm;
    case FeedMode::inverse_time: return feed.value * length_mm;
  }
  return 0;
}

}  // namespace kerf::motion
