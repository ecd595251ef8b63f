#pragma once

#include <optional>

#include "job/internal/stock_pass.hpp"
#include "job/run.hpp"
#include "job/stock_job.hpp"
#include "machine/definition/work_turns.hpp"
#include "motion/skip_signal.hpp"
#include "stock/cutting/survey.hpp"
#include "stock/cutting/work_frame.hpp"

namespace kerf::job {

/// Looks over the program without cutting anything.
class SurveyPass final : public motion::MotionSink, private motion::SkipSignal {
 public:
  SurveyPass(const StockJob& job, Run& run)
      : frame_(run.machine().definition().axes, turns_of(run.machine().definition())),
        survey_(run.machine().definition().axes, frame_),
        zero_(run.machine(), job.zero) {
    run.machine().add_sink(*this);
    if (job.job.skips.empty()) run.machine().set_skip_signal(*this);
  }

  void take(const motion::Motion& motion) override {
    if (motion::is_cut(motion)) zero_.look(motion.block);
    survey_.take(motion);
  }

  [[nodiscard]] const stock::Survey& survey() const { return survey_; }
  [[nodiscard]] stock::Vec3 origin() const { return zero_.origin().value_or(zero_.at_start()); }
  [[nodiscard]] const machine::StockZero& zero() const { return zero_.zero(); }
  /// A probe may have missed the stock, which is not there.
  [[nodiscard]] bool has_probed() const { return has_probed_; }

 private:
  std::optional<double> comes_on(const motion::SkipMove&) override {
    has_probed_ = true;
    return std::nullopt;
  }

  /// How far a bar is cut is the same however it has turned.
  [[nodiscard]] static std::vector<stock::WorkTurn> turns_of(
      const machine::MachineDefinition& machine) {
    return machine.turns() ? std::vector<stock::WorkTurn>{} : machine::work_turns(machine);
  }

  stock::WorkFrame frame_;
  stock::Survey survey_;
  ZeroWatch zero_;
  bool has_probed_ = false;
};

}  // namespace kerf::job
