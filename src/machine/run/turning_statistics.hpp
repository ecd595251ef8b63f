#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"
#include "motion/spindle_set.hpp"

namespace kerf::machine {

/// How a run of a lathe has used its spindles, and which threads it has cut.
class TurningStatistics : public motion::MotionSink {
 public:
  explicit TurningStatistics(const motion::AxisSetup& axes);

  struct SpindleUse {
    bool turned = false;
    double most_rpm = 0;      ///< that it has had while the tool was on its way
    bool css = false;         ///< with constant surface speed, at least once
    bool is_clamped = false;  ///< more was asked for than it may or can
  };
  /// Passes one after the other with the same lead and the same end along Z, of one tool. A chain
  /// of threads without a stop is one pass.
  struct ThreadUse {
    double lead = 0;
    std::uint64_t passes = 0;
    double depth =
        0;  ///< mm of radius: of a cycle its height, else from the first pass to the last
  };

  void take(const motion::Motion& motion) override;

  [[nodiscard]] const SpindleUse& use_of(motion::SpindleName name) const {
    return uses_[index(name)];
  }
  [[nodiscard]] std::vector<ThreadUse> threads() const;

 private:
  struct Pass {
    double lead = 0;
    double end = 0;     // along Z
    double radius = 0;  // where its first thread ends
    double depth = 0;   // that its cycle says
    std::uint32_t tool = 0;
  };
  struct Group {
    ThreadUse use;
    Pass first;
  };
  void turn(const motion::Spindle& spindle);
  void move(const motion::Motion& motion);
  void follow_surface_speed(const motion::Spindle& spindle, const motion::Motion& motion);
  void thread(const motion::Thread& thread);
  void end_pass();
  static void count(std::vector<Group>& groups, const Pass& pass);
  [[nodiscard]] double along(char letter, const base::TipPoint& tip) const;

  const motion::AxisSetup& axes_;
  motion::SpindleSet spindles_;
  std::array<SpindleUse, motion::kSpindles> uses_{};
  base::TipPoint at_;
  std::uint32_t tool_ = 0;
  std::optional<Pass> pass_;  // under way
  std::vector<Group> groups_;
};

}  // namespace kerf::machine
