#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"

namespace kerf::test {

/// A motion record in the notation of the text tests.
struct Observed {
  std::uint32_t line = 0;
  bool moves = false;
  std::string text;
  motion::Motion motion;
};

/// Collects what a machine does.
class Recorder : public motion::MotionSink {
 public:
  explicit Recorder(const motion::AxisSetup& axes) : axes_(axes) {}
  void take(const motion::Motion& motion) override;
  [[nodiscard]] const std::vector<Observed>& observed() const { return observed_; }

 private:
  const motion::AxisSetup& axes_;
  std::vector<Observed> observed_;
};

/// What is wrong with `observed` when `wanted` ("line X1 F100 stop", "cw X20 Y10 @15,10 XY") is
/// expected; empty: nothing.
[[nodiscard]] std::string difference(const std::string& wanted, const Observed& observed,
                                     const motion::AxisSetup& axes);

}  // namespace kerf::test
