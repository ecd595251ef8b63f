#include "process/settled.hpp"

#include <algorithm>
#include <cmath>

#include "motion/feed.hpp"

namespace kerf::process {
namespace {

constexpr double kMilliseconds = 1000;

void settle_power(const Operation& operation, const MachineFacts& machine, Settled& settled) {
  if (operation.ton_ms && operation.toff_ms) {
    const double period_ms = *operation.ton_ms + *operation.toff_ms;
    settled.power_percent = 100 * *operation.ton_ms / period_ms;
    settled.frequency_hz = kMilliseconds / period_ms;
  } else if (operation.power_percent) {
    settled.power_percent = *operation.power_percent;
  } else {
    settled.power_is_assumed = true;
  }
  if (operation.frequency_hz) settled.frequency_hz = *operation.frequency_hz;
  // The machine's own is said by saying nothing.
  if (settled.frequency_hz == machine.frequency_hz) settled.frequency_hz = 0;
}

void settle_feed(const Operation& operation, const MachineFacts& machine, Settled& settled) {
  if (operation.ms_per_mm) {
    settled.feed = motion::kSecondsPerMinute * kMilliseconds / *operation.ms_per_mm;
  } else if (operation.feed) {
    settled.feed = *operation.feed;
  } else {
    settled.feed = 0.5 * machine.fastest_feed;
    settled.feed_is_assumed = true;
  }
}

Beam usual_beam(Process process) {
  switch (process) {
    case Process::engrave:
    case Process::mark:
    case Process::fill:
    case Process::raster: return Beam::follow;
    case Process::cut:
    case Process::weld:
    case Process::heat:
    case Process::drill: break;
  }
  return Beam::constant;
}

double spacing_of(const Operation& operation) {
  if (operation.process == Process::heat)
    return operation.track_width.value_or(1) * (1 - operation.overlap);
  return operation.spacing.value_or(0.1);
}

double burn_of(const Operation& operation) {
  if (operation.dwell_s) return *operation.dwell_s;
  const double period_ms = operation.ton_ms.value_or(0) + operation.toff_ms.value_or(0);
  return operation.pulses.value_or(1) * period_ms / kMilliseconds;
}

}  // namespace

Settled settle(const Operation& operation, const MachineFacts& machine) {
  Settled settled;
  settle_power(operation, machine, settled);
  settle_feed(operation, machine, settled);
  settled.beam = operation.beam.value_or(usual_beam(operation.process));
  settled.overcut = operation.overcut.value_or(operation.process == Process::cut ? 0.2 : 0);
  settled.kerf = operation.kerf.value_or(machine.kerf_mm);
  settled.spacing = spacing_of(operation);
  settled.burn_s = burn_of(operation);
  return settled;
}

double run_up_mm(const MachineFacts& machine, double feed, Vec2 direction) {
  constexpr double kMargin_mm = 0.1;
  const double speed = feed / motion::kSecondsPerMinute;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [letter, part] : {std::pair{'X', direction.u}, std::pair{'Y', direction.v}}) {
    const auto axis = machine.axes.find(letter);
    if (axis && std::abs(part) > 1e-9)
      least = std::min(least, machine.axes[*axis].acceleration / std::abs(part));
  }
  return speed * speed / (2 * least) + kMargin_mm;
}

}  // namespace kerf::process
