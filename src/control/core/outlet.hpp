#pragma once

#include "control/core/alarms.hpp"
#include "control/core/stroke_limits.hpp"
#include "control/core/surroundings.hpp"
#include "motion/motion.hpp"

namespace kerf::control {

/// Where motions leave the control. A move that leads beyond a stored stroke limit, or that the
/// machine cannot make, raises its alarm here and is not handed out, nor is anything behind it,
/// until the alarm is reset.
///
/// Machines that move the program's own axes can make every move within their strokes: they are
/// not asked.
class Outlet {
 public:
  enum class Machine : std::uint8_t { makes_all, is_asked };

  /// All must outlive the outlet; `strokes` may be null.
  Outlet(Alarms& alarms, Surroundings& surroundings, Machine machine, const StrokeLimits* strokes,
         motion::MotionSink& sink)
      : alarms_(alarms),
        surroundings_(surroundings),
        machine_(machine),
        strokes_(strokes),
        sink_(sink) {}

  /// A motion that begins with the tip at `from`; `place` is that of its block, null for the
  /// executing one. False: it was refused.
  [[nodiscard]] bool let_out(const motion::Motion& motion, const base::TipPoint& from,
                             const base::Place* place = nullptr) {
    closed_ = closed_ || !admits(motion, from, Surroundings::Intent::make, place);
    if (closed_) return false;
    sink_.take(motion);
    return true;
  }
  /// Whether a move of the executing block could be made. False: an alarm was raised.
  [[nodiscard]] bool admits(const motion::Motion& motion, const base::TipPoint& from) {
    return admits(motion, from, Surroundings::Intent::ask, nullptr);
  }
  /// Open again.
  void reset() { closed_ = false; }

 private:
  bool admits(const motion::Motion& motion, const base::TipPoint& from, Surroundings::Intent intent,
              const base::Place* place) {
    if (motion::target_of(motion) == nullptr) return true;
    auto refusal = strokes_ != nullptr ? strokes_->refusal(from, motion) : std::nullopt;
    if (!refusal && machine_ == Machine::is_asked)
      refusal = surroundings_.refusal(from, motion, intent);
    return !refusal || alarms_.raise_at(refusal->code, place != nullptr ? *place : alarms_.place(),
                                        motion.block, refusal->sentence);
  }

  Alarms& alarms_;
  Surroundings& surroundings_;
  Machine machine_;
  const StrokeLimits* strokes_;
  motion::MotionSink& sink_;
  bool closed_ = false;
};

}  // namespace kerf::control
