#pragma once

#include "control/motion.hpp"

namespace kerf::output {

/// mm/min of a move of this length while the spindle has this speed.
inline double feed_per_minute(const control::Feed& feed, double length_mm, double speed_rpm) {
  switch (feed.mode) {
    case control::FeedMode::per_minute: return feed.value;
    case control::FeedMode::per_revolution: return feed.value * speed_rpm;
    case control::FeedMode::inverse_time: return feed.value * length_mm;
  }
  return 0;
}

}  // namespace kerf::output
