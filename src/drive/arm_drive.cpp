#include "drive/arm_drive.hpp"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <limits>

namespace kerf::drive {

/// Motors that move together, at most one train each.
class ArmDrive::Trains {
 public:
  void add(const Train& train) { trains_[count_++] = train; }
  void set_duration(std::int64_t ticks) { duration_ = ticks; }
  [[nodiscard]] std::int64_t duration() const { return duration_; }

  /// The train whose next pulse rises first; null when all are done.
  [[nodiscard]] Train* earliest() {
    Train* found = nullptr;
    for (std::size_t i = 0; i < count_; ++i) {
      Train& train = trains_[i];
      if (train.done == train.pulses) continue;
      if (found == nullptr || train.rise() < found->rise()) found = &train;
    }
    return found;
  }

 private:
  std::array<Train, kArmAxes> trains_{};
  std::size_t count_ = 0;
  std::int64_t duration_ = 0;
};

base::Result<ArmDrive::Trains> ArmDrive::plan(const ArmCounts& counts,
                                              std::int64_t half_period) const {
  std::int64_t most = 0;
  for (const std::int64_t count : counts.values) most = std::max(most, std::abs(count));
  assert(most <= kMostPulses);
  Trains trains;
  trains.set_duration(2 * most * half_period);
  for (std::size_t i = 0; i < kArmAxes; ++i) {
    const std::int64_t count = counts.values[i];
    if (count == 0) continue;
    const auto half = split_half_period(settings_.split, most, std::abs(count), half_period);
    if (!half) return base::unexpected(half.error());
    trains.add({static_cast<ArmAxis>(i), count < 0 ? Direction::negative : Direction::positive,
                std::abs(count), *half});
  }
  return trains;
}

base::Result<void> ArmDrive::slow(const SlowMove& triplet) {
  return slow(triplet, settings_.half_period_ticks);
}

base::Result<void> ArmDrive::slow(const SlowMove& triplet, std::int64_t half_period_ticks) {
  ArmCounts wheel;
  wheel[ArmAxis::theta3] = triplet.theta3;
  ArmCounts arms;
  arms[ArmAxis::theta1] = triplet.theta1;
  arms[ArmAxis::theta2] = triplet.theta2;
  auto turn = plan(wheel, settings_.half_period_ticks);
  if (!turn) return base::unexpected(turn.error());
  auto swing = plan(arms, half_period_ticks);
  if (!swing) return base::unexpected(swing.error());
  run(*turn);
  run(*swing);
  return {};
}

base::Result<void> ArmDrive::linked(const ArmCounts& counts) {
  auto trains = plan(counts, settings_.half_period_ticks);
  if (!trains) return base::unexpected(trains.error());
  run(*trains);
  return {};
}

void ArmDrive::run(Trains& trains) {
  while (Train* const train = trains.earliest()) {
    pulse(train->axis, train->direction, now_ + train->rise(), now_ + train->fall());
    ++train->done;
  }
  now_ += trains.duration();
}

void ArmDrive::fast(const FastMove& move) {
  const Direction direction = move.count < 0 ? Direction::negative : Direction::positive;
  for (std::int64_t left = std::abs(move.count); left > 0;) {
    const std::int64_t pulses = std::min(left, kMostPulses);
    fast_record(move.axis, direction, pulses);
    left -= pulses;
  }
}

void ArmDrive::fast_record(ArmAxis axis, Direction direction, std::int64_t pulses) {
  const FastProfile profile(settings_.fast, pulses);
  for (std::int64_t edge = 1; edge < 2 * pulses; edge += 2) {
    pulse(axis, direction, now_ + settings_.clock.ticks(profile.edge_s(edge)),
          now_ + settings_.clock.ticks(profile.edge_s(edge + 1)));
  }
  now_ += settings_.clock.ticks(profile.edge_s(2 * pulses));
}

void ArmDrive::pulse(ArmAxis axis, Direction direction, std::int64_t rise, std::int64_t fall) {
  const std::int64_t rise_ns = settings_.clock.nanoseconds(rise);
  const std::int64_t width = settings_.clock.nanoseconds(fall) - rise_ns;
  constexpr std::int64_t kLongest = std::numeric_limits<std::uint32_t>::max();
  const auto width_ns = static_cast<std::uint32_t>(std::clamp<std::int64_t>(width, 1, kLongest));
  sink_->take({rise_ns, width_ns, axis_of(axis), direction});
  counters_[axis] += sign(direction);
}

}  // namespace kerf::drive
