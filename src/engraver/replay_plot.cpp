#include "engraver/replay_plot.hpp"

#include <array>

namespace kerf::engraver {

ReplayPlot::ReplayPlot(PatternReplay& replay, output::PathPlot& into)
    : replay_(replay), into_(into) {
  replay.add_sink(static_cast<motion::MotionSink&>(*this));
}

void ReplayPlot::follow() {
  const machine::PatternMachine& machine = replay_.machine();
  std::array<double, drive::kArmAxes> counts{};
  for (int n = 1; n < kPieces; ++n) {
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const auto from = static_cast<double>(at_.values[i]);
      const auto to = static_cast<double>(replay_.counters().values[i]);
      counts[i] = from + (to - from) * n / kPieces;
    }
    into_.travel_through(machine.kinematics().forward(machine.joints_at(counts)));
  }
}

void ReplayPlot::take(const motion::Motion& motion) {
  const auto* const rapid = std::get_if<motion::Rapid>(&motion.action);
  if (rapid != nullptr) {
    follow();
    motion::Motion last = motion;
    last.action = motion::Rapid{rapid->to, true};
    into_.take(last);
  } else {
    into_.take(motion);
  }
  at_ = replay_.counters();
}

}  // namespace kerf::engraver
