#include "machine/panel/internal/forecast.hpp"

#include <limits>

#include "machine/panel/internal/journal.hpp"

namespace kerf::machine {
namespace {

// Stops one behind the other before a program that only stops counts as endless.
constexpr int kMostIdleStops = 200;

RunStart untouched(RunStart start) {
  const std::uint32_t skip_levels = start.panel.skip_levels;
  start.panel = {};
  start.panel.skip_levels = skip_levels;
  start.breakpoints.clear();
  return start;
}

}  // namespace

Forecast::Forecast(RunStart start) : core_(untouched(std::move(start))) {
  static_cast<void>(core_.perform(CycleStart{}));
}

void Forecast::go_to(double time_s) {
  for (int idle = 0; idle < kMostIdleStops;) {
    const std::uint64_t before = core_.points();
    make_points(core_, time_s, LiveCore::kNever);
    if (core_.is_active() || core_.status() != Status::stopped || !core_.perform(CycleStart{}))
      return;
    idle = core_.points() == before ? idle + 1 : 0;
  }
}

}  // namespace kerf::machine
