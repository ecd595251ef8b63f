#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "face/server/protocol/json.hpp"
#include "machine/definition/machine_definition.hpp"
#include "motion/axis_point.hpp"

namespace kerf::server {

/// The last seconds of a machine's step pulses. It keeps the set-points and makes the pulses of
/// them when somebody asks; whoever asks keeps it awake for kAwake_s, and asleep it costs nothing.
class PulseWindow : public motion::AxisPointSink {
 public:
  static constexpr double kMost_s = 10;
  static constexpr double kAwake_s = 30;  ///< of machine time
  static constexpr std::size_t kMostEdges = 200'000;

  explicit PulseWindow(const machine::MachineDefinition& definition) : definition_(definition) {}

  void start(const motion::AxisPoint& at) override;
  void take(const motion::AxisPoint& point) override;

  /// `pulses` and `lines` of the command: the edges of the last `seconds`, at most kMostEdges, the
  /// newest. Begins to keep set-points, if it did not.
  [[nodiscard]] Json edges(double seconds);

 private:
  struct Point {
    double time_s = 0;
    base::JointPoint joints;
    std::uint32_t line = 0;
  };

  void drop_before(double time_s);

  machine::MachineDefinition definition_;
  std::deque<Point> points_;
  double last_s_ = 0;
  double awake_until_s_ = -1;
};

}  // namespace kerf::server
