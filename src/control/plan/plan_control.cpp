#include "control/plan/plan_control.hpp"

namespace kerf::control {

PlanControl::PlanControl(const motion::AxisSetup& axes, bool checks_strokes,
                         const MotionMaker& maker, Surroundings& surroundings,
                         motion::MotionSink& sink)
    : maker_(maker),
      sink_(sink),
      strokes_(axes, checks_strokes, nullptr),
      outlet_(alarms_, surroundings,
              axes.linked ? Outlet::Machine::is_asked : Outlet::Machine::makes_all, &strokes_,
              sink),
      start_(axes.start),
      tip_(axes.start) {}

void PlanControl::start() {
  stream_ = maker_.stream();
  waiting_.clear();
  next_ = 0;
  halt_ = Halt::none;
}

void PlanControl::reset() {
  alarms_.clear();
  outlet_.reset();
  halt_ = Halt::none;
}

std::vector<OpenCall> PlanControl::open_calls() {
  if (!stream_) return {};
  return {{maker_.name(), block_}};
}

const motion::Motion* PlanControl::upcoming() {
  while (next_ >= waiting_.size()) {
    waiting_.clear();
    next_ = 0;
    if (!stream_ || !stream_->next(waiting_)) return nullptr;
  }
  return &waiting_[next_];
}

bool PlanControl::make(const motion::Motion& motion) {
  block_ = motion.block;
  ++blocks_;
  if (!outlet_.let_out(motion, tip_)) return false;
  if (const base::TipPoint* const to = motion::target_of(motion)) tip_ = *to;
  return true;
}

Halt PlanControl::run(std::uint64_t instructions) {
  halt_ = Halt::none;
  for (std::uint64_t i = 0; i < instructions && sink_.ready(); ++i) {
    const motion::Motion* const motion = upcoming();
    if (motion == nullptr) return halt_ = Halt::end;
    const bool is_end = std::holds_alternative<motion::End>(motion->action);
    if (!make(*motion)) return halt_ = Halt::alarm;
    ++next_;
    if (is_end) return halt_ = Halt::end;
    if (single_block_) return halt_ = Halt::single_block;
  }
  return halt_;
}

vm::Verdict PlanControl::execute(const vm::CodePage&, std::uint32_t, const double*) {
  return vm::Verdict::stop;
}

}  // namespace kerf::control
