#pragma once

#include <map>
#include <optional>
#include <vector>

#include "motion/axis_setup.hpp"
#include "motion/motion.hpp"
#include "motion/move_curves.hpp"
#include "stock/cutting/sweep_maker.hpp"

namespace kerf::stock {

/// What a run will cut, before anything is cut: a sink for a first pass. Places are those of the
/// work with its rotary axes at 0, machine coordinates.
class Survey final : public motion::MotionSink {
 public:
  /// Of the tips of one tool's moves at feed. low > high: it has none.
  struct Extents {
    Vec3 low;
    Vec3 high;
    bool turned = false;           ///< some of them with the tool tilted against Z
    bool axial = true;             ///< all of them along Z
    std::optional<double> across;  ///< highest Z of the end of one that goes across Z
  };

  /// Both must outlive the survey.
  Survey(const motion::AxisSetup& axes, const WorkFrame& frame)
      : frame_(frame), maker_(frame, kTolerance_mm), curves_(axes), at_(axes.start) {}

  void take(const motion::Motion& motion) override;

  /// By tool number. Before the first tool change there is none, but where there is no change at
  /// all: then it is 0.
  [[nodiscard]] const std::map<std::uint32_t, Extents>& tools() const { return tools_; }
  [[nodiscard]] bool changes_tool() const { return changes_tool_; }
  /// There was a move at feed.
  [[nodiscard]] bool has_begun() const { return !tools_.empty(); }

 private:
  static constexpr double kTolerance_mm = 0.01;  // of what turns

  void cut(const motion::Motion& motion);

  const WorkFrame& frame_;
  SweepMaker maker_;
  motion::MoveCurves curves_;
  base::TipPoint at_;
  std::uint32_t tool_ = 0;
  bool changes_tool_ = false;
  std::map<std::uint32_t, Extents> tools_;
  std::vector<Sweep> sweeps_;
};

}  // namespace kerf::stock
