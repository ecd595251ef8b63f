#pragma once

#include <cstdint>
#include <deque>
#include <mutex>
#include <vector>

#include "motion/motion.hpp"
#include "motion/motion_end_sink.hpp"
#include "output/drawings/draw_facts.hpp"
#include "process/plan_reader.hpp"

namespace kerf::job {

/// Measures what a machine makes of a plan, by operation: ways from the motions, times from the
/// interpolator. Energy is power over time; of a beam that follows the speed, power over the way at
/// the programmed feed.
class MadeMeter final : public motion::MotionSink, public motion::MotionEndSink {
 public:
  /// Both must outlive it. The motions that it is given are those of the plan.
  MadeMeter(const process::Plan& plan, const drawing::Drawing& drawing);

  void take(const motion::Motion& motion) override;
  void motion_ends(std::uint64_t motion, double time_s) override;

  /// When the run is over.
  [[nodiscard]] output::Made all() const;
  [[nodiscard]] const std::vector<output::Made>& by_operation() const { return by_operation_; }

 private:
  /// A motion whose end is awaited.
  struct Pending {
    std::uint64_t number = 0;
    std::size_t operation = 0;
    double power_w = 0;  ///< while it lasts
    bool has_beam = false;
  };

  void follow_plan();
  void measure_move(const motion::Motion& motion, output::Made& made);
  void burn(const motion::Dwell& dwell, output::Made& made) const;
  void reach(const motion::Motion& motion, output::Made& made) const;

  const process::Plan& plan_;
  process::PlanReader reader_;
  std::vector<process::Step> steps_;
  std::size_t next_step_ = 0;
  std::size_t operation_ = 0;
  std::uint64_t taken_ = 0;
  motion::Power power_{0};
  base::TipPoint at_;
  std::vector<output::Made> by_operation_;
  std::mutex lock_;  // of what is pending: ends are told by another thread
  std::deque<Pending> pending_;
  double last_s_ = 0;
};

}  // namespace kerf::job
