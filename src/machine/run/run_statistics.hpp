#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"
#include "motion/motion_extent.hpp"
#include "motion/move_curves.hpp"
#include "motion/space_arc_path.hpp"
#include "motion/spindle_set.hpp"

namespace kerf::machine {

/// Lengths, times and extents of a run, added up motion by motion.
///
/// The time here is that of the programmed feed and the machine's rapid rates, without
/// acceleration: a rapid takes as long as its slowest axis, a cut its length (of an arc: in its
/// plane) divided by its feed, with constant surface speed the integral of that, a thread its
/// revolutions. What the axes really take, and how long a thread waits for the spindle's mark, is
/// Servo's.
class RunStatistics : public motion::MotionSink {
 public:
  explicit RunStatistics(const motion::AxisSetup& axes);

  void take(const motion::Motion& motion) override;

  [[nodiscard]] double feed_seconds() const { return seconds_; }
  [[nodiscard]] double dwell_seconds() const { return dwell_seconds_; }
  [[nodiscard]] double rapid_mm() const { return rapid_mm_; }
  [[nodiscard]] double cut_mm() const { return cut_mm_; }
  [[nodiscard]] std::uint64_t motions() const { return motions_; }
  /// Smallest and largest target per axis; both the start before the first motion.
  [[nodiscard]] const base::TipPoint& low() const { return low_; }
  [[nodiscard]] const base::TipPoint& high() const { return high_; }
  /// Where the last motion ended: tool tip, machine coordinates.
  [[nodiscard]] const base::TipPoint& at() const { return at_; }
  /// Tools in the order of their first use.
  [[nodiscard]] const std::vector<std::uint32_t>& tools() const { return tools_; }
  [[nodiscard]] const std::vector<std::string>& messages() const { return messages_; }
  /// A feed per revolution was used while no speed was known: its time is not counted.
  [[nodiscard]] std::uint32_t untimed_line() const { return untimed_line_; }

 private:
  void reach(const motion::MotionExtent& extent);
  void rapid(const base::TipPoint& to);
  void rapid_over_turning_work(const base::TipPoint& to);
  void cut(double length, double feed_length, const motion::Feed& feed, std::uint32_t line);
  void arc(const motion::Arc& arc, std::uint32_t line);
  void space_arc(const motion::SpaceArc& arc, std::uint32_t line);
  void surface_move(const motion::SurfaceMove& move, std::uint32_t line);
  void thread(const motion::Thread& thread, std::uint32_t line);
  void find_speed(const motion::Motion& motion);
  [[nodiscard]] double distance(const base::TipPoint& to, bool& rotary_only) const;

  const motion::AxisSetup& axes_;
  base::TipPoint at_;
  base::TipPoint low_;
  base::TipPoint high_;
  std::array<double, base::kMaxAxes> rapid_s_per_unit_{};
  std::array<bool, base::kMaxAxes> linear_{};
  motion::MoveCurves curves_;
  motion::SpindleSet spindles_;
  double speed_rpm_;        // of the move under way, where it changes its mean
  double thread_rpm_ = 0;   // of threads in a row: of where the first one begins
  bool in_thread_ = false;  // the last move was a thread
  double seconds_ = 0;
  double dwell_seconds_ = 0;
  double rapid_mm_ = 0;
  double cut_mm_ = 0;
  std::uint64_t motions_ = 0;
  std::vector<std::uint32_t> tools_;
  std::vector<std::string> messages_;
  std::uint32_t untimed_line_ = 0;
};

}  // namespace kerf::machine
