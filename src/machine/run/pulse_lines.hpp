#pragma once

#include <array>
#include <vector>

#include "drive/arm_axis.hpp"
#include "drive/pulse_sink.hpp"

namespace kerf::machine {

/// The lines in time that the pulses of one record follow: pulse k is where the line passes k -
/// 1/2, and it begins and ends at whole counts. Keeps the pulses of that record, at most 65535 of
/// an axis.
///
///   count │          ,── end          o pulses, the staircase of the counter
///         │      ,o'                  the line is within half a pulse of it
///         │   ,o'
///         └──'──────────── time
class PulseLines : public drive::PulseSink {
 public:
  /// A new record begins at `time_ns`, with these counters.
  void begin(std::int64_t time_ns, const drive::ArmCounts& counts);
  void take(const drive::Pulse& pulse) override;
  /// All pulses of the record are taken.
  void end();

  /// Counts at a time behind begin() and not before that of the last call.
  [[nodiscard]] std::array<double, drive::kArmAxes> at(double time_ns);

 private:
  struct Knot {
    double time_ns = 0;
    double count = 0;
  };
  struct Line {
    std::vector<Knot> knots;
    std::size_t next = 0;  // the first knot that is not before the time of the last call
    std::int64_t count = 0;
    double end_ns = 0;  // of its last pulse
  };

  [[nodiscard]] static double at(Line& line, double time_ns);

  std::array<Line, drive::kArmAxes> lines_;
  double begin_ns_ = 0;
};

}  // namespace kerf::machine
