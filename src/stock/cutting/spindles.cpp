#include "stock/cutting/spindles.hpp"

#include "motion/spindle_speed.hpp"

namespace kerf::stock {
namespace {

// Of a surface speed without a limit only the tool's place tells the rpm.
Turning turning_of(const motion::Spindle& spindle) {
  const double speed = spindle.follows_radius() ? spindle.speed : spindle.known_rpm();
  if (!spindle.turns() || !(speed > 0)) return Turning::stopped;
  return spindle.turning == motion::Spindle::Turning::clockwise ? Turning::right : Turning::left;
}

}  // namespace

void Spindles::take(const motion::Spindle& spindle) {
  if (spindle.name == motion::SpindleName::sub) return;
  const bool is_live = turns_work_ && spindle.name == motion::SpindleName::live;
  const Of of = is_live || !turns_work_ ? Of::tool : Of::work;
  told_[index(of)] = spindle;
  turning_[index(of)] = turning_of(spindle);
  if (turning(of) != Turning::stopped) last_ = of;
}

void Spindles::move(const base::TipPoint& from, const base::TipPoint& to) {
  if (!turns_work_) return;
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    const base::Axis axis{static_cast<std::uint8_t>(i)};
    if (axes_.axes[i].rotary && from[axis] != to[axis])
      turning_[index(Of::work)] = Turning::stopped;
  }
}

}  // namespace kerf::stock
