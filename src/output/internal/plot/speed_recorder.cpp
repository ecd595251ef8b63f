#include "output/internal/plot/speed_recorder.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::output::plot {
namespace {

double distance(const Point3& a, const Point3& b) {
  const Point3 way = b - a;
  return std::hypot(way[kX], way[kY], way[kZ]);
}

}  // namespace

void SpeedRecorder::start(const motion::Setpoint& at) {
  close(0);
  const Point3 place = space_.point_of(at.tip, last_.to);
  from_ = knot(place, 0);
  last_ = {place, 0, false};
  time_s_ = at.time_s;
}

void SpeedRecorder::take(const motion::Setpoint& point) {
  constexpr double kSecondsPerMinute = 60;
  const Point3 to = space_.point_of(point.tip, last_.to);
  const double time_s = point.time_s - time_s_;
  const double speed = time_s > 0 ? distance(last_.to, to) / time_s * kSecondsPerMinute : 0;
  beam_was_on_ = beam_was_on_ || point.mark.power_percent > 0;
  close(speed);
  last_ = {to, speed, is_at_feed(point.mark)};
  time_s_ = point.time_s;
  if (last_.at_feed) fastest_ = std::max(fastest_, speed);
}

Path SpeedRecorder::path() const {
  SpeedRecorder copy = *this;
  copy.close(0);
  return copy.store_.path();
}

void SpeedRecorder::close(double speed_behind) {
  const Knot to = knot(last_.to, (last_.speed + speed_behind) / 2);
  if (last_.at_feed) {
    store_.line({Trace::cut, 0}, from_, to);
  } else {
    store_.lift();
  }
  from_ = to;
}

bool SpeedRecorder::is_at_feed(const motion::Mark& mark) const {
  const bool beam_off = beam_was_on_ && !(mark.power_percent > 0);
  return mark.kind == motion::MoveKind::cut && !beam_off;
}

}  // namespace kerf::output::plot
