#include "stock/sheet/beam_energy.hpp"

namespace kerf::stock::sheet {
namespace {

constexpr double kPercent = 100;

}  // namespace

Vec2 BeamEnergy::place_of(const motion::AxisPoint& point) const {
  const Vec3 place = frame_.pose(point.tip.tip).tip;
  return {place.x, place.y};
}

void BeamEnergy::start(const motion::AxisPoint& at) {
  at_ = place_of(at);
  time_s_ = at.tip.time_s;
}

void BeamEnergy::take(const motion::AxisPoint& point) {
  const Vec2 to = place_of(point);
  const double watts = full_power_w_ * static_cast<double>(point.power_percent) / kPercent;
  const double energy = watts * (point.tip.time_s - time_s_);
  time_s_ = point.tip.time_s;
  if (energy > 0) {
    energy_j_ += energy;
    take_({at_, to, energy});
  }
  at_ = to;
}

}  // namespace kerf::stock::sheet
