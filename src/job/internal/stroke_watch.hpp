#pragma once

#include "control/core/stroke_limits.hpp"
#include "machine/run/batch_run.hpp"
#include "stock/cutting/findings.hpp"
#include "stock/cutting/judge.hpp"
#include "stock/cutting/motion_cut.hpp"

namespace kerf::job {

/// Whether the axes of a run leave their travel (stock.md §5, OT0500 and OT0501), the tool's length
/// included; nothing stops. Along an axis that no work offset, on a lathe no geometry of a tool
/// either, has a value for, the program runs in machine coordinates for want of data: there nothing
/// is known. The length of a tool alone does not say where the work stands.
class StrokeWatch final : public stock::TimedCutSink {
 public:
  /// The run must outlive the watch.
  explicit StrokeWatch(const machine::BatchRun& run);

  void look(const motion::Motion& motion, std::uint64_t number);
  /// When the motion ends.
  void take(const stock::TimedCut& cut) override {
    if (!findings_.is_empty()) findings_.set_time(cut.cut.block, cut.cut.motion, cut.end_s);
  }
  [[nodiscard]] bool is_known() const { return known_ != 0; }
  /// Tells what was found, once; nothing while it is not known.
  void tell(stock::Judge& judge);

 private:
  [[nodiscard]] base::AxisSet with_offsets() const;
  void know(base::AxisSet axes);

  const machine::BatchRun& run_;
  motion::AxisSetup axes_;  // without the limits of those that nothing is known of
  base::AxisVector length_;
  control::StrokeLimits limits_;
  base::TipPoint at_;
  std::uint32_t tool_ = 0;
  base::AxisSet known_;
  std::uint64_t revision_;
  bool has_told_ = false;
  stock::Findings findings_;
};

}  // namespace kerf::job
