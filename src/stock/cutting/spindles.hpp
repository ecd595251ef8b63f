#pragma once

#include <cstdint>

#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"

namespace kerf::stock {

/// Turns of a spindle as checks see them.
enum class Turning : std::uint8_t { stopped, right, left };

/// What the spindles of a run do: that of a mill, or on a lathe that of the work and that of driven
/// tools. The sub-spindle is not looked at.
class Spindles {
 public:
  /// The axes outlive this. `turns_work`: the machine is a lathe.
  Spindles(const motion::AxisSetup& axes, bool turns_work) : axes_(axes), turns_work_(turns_work) {}

  void take(const motion::Spindle& spindle);
  /// A rotary axis of a lathe that moves is its spindle, which does not turn any more by itself.
  void move(const base::TipPoint& from, const base::TipPoint& to);

  enum class Of : std::uint8_t { work, tool };
  [[nodiscard]] const motion::Spindle& told(Of of) const { return told_[index(of)]; }
  [[nodiscard]] Turning turning(Of of) const { return turning_[index(of)]; }
  /// That which turns the tool makes the cut: it turns, and was told so later than the other one.
  [[nodiscard]] bool drive_tool() const {
    return turning(Of::tool) != Turning::stopped &&
           (turning(Of::work) == Turning::stopped || last_ == Of::tool);
  }

 private:
  [[nodiscard]] static std::size_t index(Of of) { return static_cast<std::size_t>(of); }

  const motion::AxisSetup& axes_;
  bool turns_work_;
  std::array<motion::Spindle, 2> told_{};
  std::array<Turning, 2> turning_{};
  Of last_ = Of::work;
};

}  // namespace kerf::stock
