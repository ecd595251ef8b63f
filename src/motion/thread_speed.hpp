#pragma once

#include <optional>

#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"
#include "motion/path_speed.hpp"

namespace kerf::motion {

/// A thread as lengths: its lead counts along the linear axis that goes farthest.
///
/// At θ turns behind its begin that axis has gone z = L θ + K θ²/2 with the lead L and its change
/// K, at the speed n/60 √(L² + 2 K z): v² grows by the same with every mm, so times are exact.
class ThreadWay {
 public:
  ThreadWay(const Thread& thread, const base::TipPoint& from, const AxisSetup& axes);

  [[nodiscard]] double length_mm() const { return length_mm_; }  ///< of the linear axes together
  [[nodiscard]] double lead_way_mm() const { return lead_way_mm_; }
  /// How many revolutions it takes; infinite where the lead shrinks to nothing on the way.
  [[nodiscard]] double revolutions() const;
  /// Along the line from its begin to its end while the spindle has this speed; without a speed or
  /// a lead no limit.
  [[nodiscard]] PathSpeed speed(double rpm) const;
  /// At most; 0 when it goes nowhere.
  [[nodiscard]] double largest_lead_mm() const;

 private:
  [[nodiscard]] double lead_square_at(double way_mm) const;

  double lead_;
  double lead_change_;
  double length_mm_ = 0;
  double lead_way_mm_ = 0;
};

/// Threads in a row are one as long as nothing but these stands between two of them.
[[nodiscard]] inline bool ends_thread(const Motion& motion) {
  return !std::holds_alternative<Thread>(motion.action) &&
         !std::holds_alternative<Power>(motion.action) &&
         !std::holds_alternative<Message>(motion.action);
}

/// The highest speed of the spindle, rpm, at which no axis needs more than its velocity for the
/// thread; infinite where it goes nowhere. A faster one must be refused: the thread would have
/// another lead.
[[nodiscard]] double highest_rpm(const Thread& thread, const base::TipPoint& from,
                                 const AxisSetup& axes);

}  // namespace kerf::motion
