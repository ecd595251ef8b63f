#include "output/picture/internal/cut_recorder.hpp"

#include "math/math.hpp"

namespace kerf::output::plot {
namespace {

constexpr Pen kCut{Trace::cut, 0};

double distance(const Point3& a, const Point3& b) {
  const Point3 way = b - a;
  return math::hypot(way[kX], way[kY], way[kZ]);
}

}  // namespace

void CutRecorder::start(const motion::Setpoint& at) {
  close(0);
  const Point3 place = space_.point_of(at.tip, last_.to);
  from_ = knot(place, 0);
  last_ = {place, 0, false};
  time_s_ = at.time_s;
}

void CutRecorder::take(const motion::Setpoint& point, float power_percent) {
  const Point3 to = space_.point_of(point.tip, last_.to);
  const double value =
      measure_->take({distance(last_.to, to), point.time_s - time_s_, point.mark, power_percent});
  close(value);
  last_ = {to, value, measure_->is_drawn(point.mark)};
  time_s_ = point.time_s;
}

Path CutRecorder::path() const {
  PathStore whole = store_;
  if (last_.drawn) whole.line(kCut, from_, last_knot(0));
  return whole.path();
}

void CutRecorder::close(double value_behind) {
  const Knot to = last_knot(value_behind);
  if (last_.drawn) {
    store_.line(kCut, from_, to);
  } else {
    store_.lift();
  }
  from_ = to;
}

Knot CutRecorder::last_knot(double value_behind) const {
  return knot(last_.to, measure_->between(last_.value, value_behind));
}

}  // namespace kerf::output::plot
