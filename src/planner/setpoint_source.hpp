#pragma once

#include "base/interface.hpp"
#include "motion/motion.hpp"
#include "motion/motion_end_sink.hpp"
#include "motion/setpoint.hpp"
#include "planner/overrides.hpp"

namespace kerf::planner {

/// Makes set-points of motions.
///
///   while there are motions:   while (room()) take(motion);   while (next(point)) …
///   at the end:                finish();                      while (next(point)) …
///
/// Points come in the order of their times. Each belongs to the motion that is under way or ends
/// there; what follows a standstill begins with the point after it.
class SetpointSource : public base::Interface {
 public:
  [[nodiscard]] virtual bool room() const = 0;
  /// Precondition: room().
  virtual void take(const motion::Motion& motion) = 0;
  /// The axes come to rest behind what was taken. Precondition: room().
  virtual void finish() = 0;

  /// The next point; false when more motions are needed, or all is done.
  [[nodiscard]] virtual bool next(motion::Setpoint& point) = 0;
  /// Passes over all that next() would give.
  virtual void skip() = 0;

  /// Is told when motions end; a source that knows no such times tells none. Precondition: nothing
  /// was taken yet, and no operator will interfere.
  virtual void tell_ends(motion::MotionEndSink& /*sink*/) {}

  /// Time at the last point, s.
  [[nodiscard]] virtual double time_s() const = 0;
  /// The last point; where the axes stand at power-on, before there is one.
  [[nodiscard]] virtual const base::TipPoint& tip() const = 0;
  /// Where the motion of the last point ends, as far as that is known: else the tip.
  [[nodiscard]] virtual base::TipPoint motion_end() const = 0;

  // The operator. Each of these takes effect as soon as it breaks no limit: speeds change along the
  // path, which is not left.

  /// 0 < feed, rapid <= 2.
  virtual void set_overrides(const Overrides& overrides) = 0;
  /// What he makes of spindle speeds, > 0: feeds per revolution of motions taken from now on.
  virtual void set_spindle_override(double factor) = 0;
  /// The axes come to rest on the path.
  virtual void hold() = 0;
  /// They come to rest at the end of the block that is under way, or of the first one behind it
  /// where that can be done.
  virtual void hold_behind_block() = 0;
  virtual void resume() = 0;
  /// As hold(); at rest everything ahead is dropped, and the next motion begins where the tool is.
  virtual void reset() = 0;
  /// hold() or reset() was asked for, and not resume() since.
  [[nodiscard]] virtual bool wants_hold() const = 0;
  /// At rest after hold() or reset().
  [[nodiscard]] virtual bool held() const = 0;
  /// At rest after reset(), with nothing ahead.
  [[nodiscard]] virtual bool at_reset() const = 0;
  /// Everything that was taken is made.
  [[nodiscard]] virtual bool empty() const = 0;
  /// At the last point the axes were at rest.
  [[nodiscard]] virtual bool standing() const = 0;
};

}  // namespace kerf::planner
