#pragma once

#include <cstdint>
#include <optional>

namespace kerf::drive {

/// Most pulses of one axis in one triplet.
inline constexpr std::int64_t kMostTripletPulses = 30;

/// A cutting move of the arm in signed pulses: theta3 turns first, alone; then theta1 and theta2
/// move together in the same time.
struct SlowMove {
  std::int64_t theta3 = 0;
  std::int64_t theta1 = 0;
  std::int64_t theta2 = 0;

  friend bool operator==(const SlowMove&, const SlowMove&) = default;
};

/// Cuts a slow move of any length into triplets, moves of at most kMostTripletPulses an axis, whose
/// sum it is (docs/drives.md, "Triplets"). The arms stay within one pulse of the straight line.
/// Each count is at most 2^31 in size.
class SlowMoveSplitter {
 public:
  explicit SlowMoveSplitter(const SlowMove& move);

  /// The next triplet; nothing after the last one. A move of nothing has none.
  [[nodiscard]] std::optional<SlowMove> next();

 private:
  SlowMove move_;  // theta3: what is left
  std::int64_t parts_;
  std::int64_t part_ = 0;
};

}  // namespace kerf::drive
