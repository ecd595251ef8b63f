#include "stock/sheet/beam_tracer.hpp"

#include <algorithm>

namespace kerf::stock::sheet {

BeamTracer::BeamTracer(const motion::AxisSetup& axes, const WorkFrame& frame, double tolerance_mm,
                       Take take)
    : frame_(frame),
      tolerance_mm_(tolerance_mm),
      take_(std::move(take)),
      curves_(axes),
      maker_(frame, tolerance_mm / 2),
      at_(axes.start) {
  for (const char letter : {'A', 'B'}) {
    if (const auto axis = axes.find(letter)) tilting_.push_back(*axis);
  }
}

void BeamTracer::take(const motion::Motion& motion) {
  if (const auto* const power = std::get_if<motion::Power>(&motion.action)) {
    power_ = *power;
  } else if (std::holds_alternative<motion::Dwell>(motion.action)) {
    rest(motion);
  } else if (motion::target_of(motion) != nullptr) {
    move(motion);
  }
}

void BeamTracer::move(const motion::Motion& motion) {
  const base::TipPoint to = *motion::target_of(motion);
  if (power_.beam_percent() > 0) {
    sweeps_.clear();
    base::TipPoint from = at_;
    for (const motion::Curve& curve : curves_.of(at_, motion)) {
      maker_.add(from, curve, {}, 0, sweeps_);
      from = curve.end();
    }
    is_tilted_ = is_tilted_ || tilts(at_) || tilts(to);
    traces_.clear();
    for (const Sweep& sweep : sweeps_) add_traces(sweep.way, tolerance_mm_ / 2, traces_);
    tell(motion);
  }
  at_ = to;
}

void BeamTracer::rest(const motion::Motion& motion) {
  if (!(power_.beam_percent() > 0) || power_.follows_speed) return;
  if (!(std::get<motion::Dwell>(motion.action).seconds > 0)) return;
  const Vec3 place = frame_.pose(at_).tip;
  traces_.assign(1, straight({place.x, place.y}, {place.x, place.y}));
  tell(motion);
}

void BeamTracer::tell(const motion::Motion& motion) {
  for (const Trace& trace : traces_) {
    has_cut_ = true;
    cut_mm_ += length(trace);
    take_(trace, motion);
  }
}

bool BeamTracer::tilts(const base::TipPoint& tip) const {
  return std::any_of(tilting_.begin(), tilting_.end(),
                     [&](base::Axis axis) { return tip[axis] != 0; });
}

}  // namespace kerf::stock::sheet
