#pragma once

#include "control/motion.hpp"
#include "motion/setpoint.hpp"

namespace kerf::motion {

/// Makes set-points of motions.
///
///   while there are motions:   while (room()) take(motion);   while (next(point)) …
///   at the end:                finish();                      while (next(point)) …
///
/// Points come in the order of their times. Each belongs to the motion that is under way or ends
/// there; what follows a standstill begins with the point after it.
class SetpointSource {
 public:
  SetpointSource() = default;
  virtual ~SetpointSource() = default;
  SetpointSource(const SetpointSource&) = delete;
  SetpointSource& operator=(const SetpointSource&) = delete;

  [[nodiscard]] virtual bool room() const = 0;
  /// Precondition: room().
  virtual void take(const control::Motion& motion) = 0;
  /// The axes come to rest behind what was taken. Precondition: room().
  virtual void finish() = 0;

  /// The next point; false when more motions are needed, or all is done.
  [[nodiscard]] virtual bool next(Setpoint& point) = 0;
  /// Passes over all that next() would give.
  virtual void skip() = 0;

  /// Time at the last point, s.
  [[nodiscard]] virtual double time_s() const = 0;
  /// The last point; where the axes stand at power-on, before there is one.
  [[nodiscard]] virtual const base::AxisVector& tip() const = 0;
};

}  // namespace kerf::motion
