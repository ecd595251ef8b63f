#pragma once

#include <string>
#include <vector>

#include "base/output_file.hpp"
#include "drive/pulse_sink.hpp"

namespace kerf::drive {

/// Writes pulses as a value change dump (IEEE 1364), as logic analysers and GTKWave read it:
/// timescale 1 ns, wires NAME_step (low at first) and NAME_dir (1 is positive, at first) per axis.
///
/// A direction changes `direction_setup_ns` before the pulse that needs it, but not while the
/// axis's last pulse is high and not before 0. What is not yet certain to be next is held back:
/// memory grows with the pulses of one set-up time, not with the file.
class PulseVcd : public PulseSink {
 public:
  /// One name per axis, in the machine's order. The file must outlive the writer.
  PulseVcd(const std::vector<std::string>& axis_names, std::int64_t direction_setup_ns,
           base::OutputFile& file);

  /// Pulses in the order of their times, from 0; those of one axis do not overlap.
  void take(const Pulse& pulse) override;

  /// Writes what was held back. The last call.
  void finish();

 private:
  struct Change {
    std::int64_t time_ns;
    std::uint64_t number;  // changes at the same time keep their order
    std::uint32_t wire;
    bool high;
  };
  struct AxisState {
    Direction direction = Direction::positive;
    std::int64_t last_fall_ns = 0;
  };
  static bool later(const Change& a, const Change& b);

  void header(const std::vector<std::string>& axis_names);
  void add(std::int64_t time_ns, std::size_t wire, bool high);
  void write_until(std::int64_t time_ns);
  void write(const Change& change);

  std::int64_t setup_ns_;
  base::OutputFile& file_;
  std::vector<AxisState> axes_;
  std::vector<std::string> codes_;  // of the wires: step and direction of each axis
  std::vector<Change> held_;        // a heap, earliest on top
  std::uint64_t changes_ = 0;
  std::int64_t written_ns_ = 0;
  std::string line_;
};

}  // namespace kerf::drive
