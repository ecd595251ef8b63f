#pragma once

#include <cstdint>
#include <deque>

#include "control/core/control.hpp"
#include "machine/run/stepper.hpp"
#include "motion/motion.hpp"

namespace kerf::machine {

/// Remembers how far the program was read when it handed out each motion, until that motion is
/// made: what is behind it has not been begun by the axes.
///
/// Bounded: where more than kMost changes are ahead of the axes, the newest ones count as one, and
/// more counts as begun than is.
class ReadAhead : public motion::MotionSink {
 public:
  static constexpr std::size_t kMost = 4096;

  struct Place {
    std::uint64_t blocks = 0;   ///< begun, as far as the stepper counts them
    std::uint64_t slashes = 0;  ///< come to
    bool operator==(const Place&) const = default;
  };

  /// Both must outlive this.
  ReadAhead(control::Control& control, const Stepper& stepper)
      : control_(control), stepper_(stepper) {}

  void take(const motion::Motion& motion) override;
  /// With motion number `motion`, counted from 1; forgets what was before it. 0: none is made yet.
  [[nodiscard]] Place at(std::uint64_t motion);
  [[nodiscard]] Place newest() { return {stepper_.blocks(), control_.slashes()}; }

 private:
  struct Entry {
    std::uint64_t first = 0;  ///< the first motion that was handed out there
    Place place;
  };

  control::Control& control_;
  const Stepper& stepper_;
  std::deque<Entry> entries_;
  Place last_;  // of the entry that was forgotten last
  std::uint64_t motions_ = 0;
};

}  // namespace kerf::machine
