#include "job/drawing/draw_run.hpp"

#include <fmt/format.h>

#include "base/decimal.hpp"
#include "job/drawing/made_meter.hpp"
#include "motion/motion_extent.hpp"
#include "process/plan_reader.hpp"

namespace kerf::job {
namespace {

using motion::Motion;

/// Where the plan leaves the travel of an axis, each axis told once, with its largest excess.
class TravelCheck {
 public:
  TravelCheck(const DrawnPlan& plan, const motion::AxisSetup& axes)
      : plan_(plan), axes_(axes), at_(axes.start), worst_(axes.count()) {}

  void look() {
    process::PlanReader reader(plan_.plan(), plan_.drawing());
    std::vector<process::Step> steps;
    while (reader.next(steps)) {
      for (const process::Step& step : steps)
        if (const auto* motion = std::get_if<Motion>(&step)) look_at(*motion);
      steps.clear();
    }
  }

  [[nodiscard]] std::vector<drawing::Finding> findings() const {
    std::vector<drawing::Finding> found;
    for (std::size_t i = 0; i < worst_.size(); ++i)
      if (worst_[i].excess > 0) found.push_back(finding_of(i));
    return found;
  }

 private:
  struct Worst {
    double excess = 0;
    double at = 0;
    base::BlockId block;
  };

  void look_at(const Motion& motion) {
    const base::TipPoint* const to = motion::target_of(motion);
    if (to == nullptr) return;
    const motion::MotionExtent extent = motion::extent_of(axes_, at_, motion);
    for (std::size_t i = 0; i < axes_.count(); ++i) {
      const base::Axis axis{static_cast<std::uint8_t>(i)};
      const motion::AxisConfig& config = axes_[axis];
      if (!(config.travel_min < config.travel_max)) continue;
      note(i, config.travel_min - extent.low[axis], extent.low[axis], motion.block);
      note(i, extent.high[axis] - config.travel_max, extent.high[axis], motion.block);
    }
    at_ = *to;
  }

  void note(std::size_t axis, double excess, double at, const base::BlockId& block) {
    constexpr double kSame_mm = 1e-6;
    if (excess <= kSame_mm || excess <= worst_[axis].excess) return;
    worst_[axis] = {excess, at, block};
  }

  [[nodiscard]] drawing::Finding finding_of(std::size_t index) const {
    const Worst& worst = worst_[index];
    const motion::AxisConfig& config = axes_[base::Axis{static_cast<std::uint8_t>(index)}];
    drawing::Finding finding;
    finding.diagnostic = base::make_error(
        base::Code::draw_outside, base::place_of(worst.block),
        fmt::format("{} would be {}, {} mm beyond its travel from {} to {}", config.letter,
                    base::number_text(base::tidy(worst.at)),
                    base::number_text(base::tidy(worst.excess)),
                    base::number_text(config.travel_min), base::number_text(config.travel_max)));
    return finding;
  }

  const DrawnPlan& plan_;
  const motion::AxisSetup& axes_;
  base::TipPoint at_;
  std::vector<Worst> worst_;
};

std::unique_ptr<base::SourceFile> named_like(const DrawnPlan& plan) {
  return base::SourceFile::from_text(plan.name(), "");
}

}  // namespace

DrawResult make_drawing(const DrawOrder& order, const std::shared_ptr<const DrawnPlan>& plan,
                        const machine::Budget& budget, const DrawWatchers& watchers) {
  DrawResult result;
  TravelCheck travel(*plan, order.definition.axes);
  travel.look();
  result.findings = travel.findings();
  machine::Machine::Settings settings;
  settings.plan = plan;
  machine::BatchRun run(order.definition, control::Memory(order.definition.parameters.n_offsets),
                        settings);
  MadeMeter meter(plan->plan(), plan->drawing());
  run.add_sink(meter);
  run.tell_ends(meter);
  for (motion::MotionSink* const sink : watchers.motions) run.add_sink(*sink);
  for (motion::AxisPointSink* const sink : watchers.points) run.add_point_sink(*sink);
  run.load(named_like(*plan));
  if (watchers.prepare) watchers.prepare(run);
  result.status = run.run_to_end(budget);
  if (watchers.finish) watchers.finish();
  if (run.alarm()) result.findings.push_back({*run.alarm(), {}, {}});
  if (run.notice()) result.findings.push_back({*run.notice(), {}, {}});
  result.made = meter.all();
  result.by_operation = meter.by_operation();
  return result;
}

}  // namespace kerf::job
