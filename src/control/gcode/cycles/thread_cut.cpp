#include "control/gcode/cycles/thread_cut.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "geometry/angle.hpp"

namespace kerf::control {
namespace {

using geometry::Vec2;
using Kind = TurningMove::Kind;

Vec2 tidied(Vec2 at) { return {base::tidy(at.u), base::tidy(at.v)}; }

double slope_of(double angle_deg) {
  const geometry::SineCosine angle = geometry::sine_cosine_deg(angle_deg);
  return angle.sine / angle.cosine;
}

// Where the run-out leaves the line of the thread.
Vec2 begin_of_run_out(Vec2 from, Vec2 to, double length) {
  const double way = to.u - from.u;
  const double share = std::min(length / std::fabs(way), 1.0);
  return tidied(to - share * (to - from));
}

// Along Z it goes on to the end, unless it comes to the radius of `home` before.
Vec2 end_of_run_out(Vec2 begin, Vec2 to, Vec2 home, double slope) {
  const double rise = home.v - begin.v;
  const double length = std::fabs(to.u - begin.u);
  const double reach = std::min(length * slope, std::fabs(rise));
  const double along = slope > 0 ? std::min(length, reach / slope) : length;
  return tidied(
      {begin.u + std::copysign(along, to.u - begin.u), begin.v + std::copysign(reach, rise)});
}

}  // namespace

RunOut run_out_of(const Parameters& parameters, double lead) {
  return {base::tidy(parameters.chamfer_thread / 10 * lead), parameters.chamfer_angle};
}

std::vector<TurningMove> thread_cut(Vec2 home, Vec2 from, Vec2 to, const RunOut& run_out) {
  std::vector<TurningMove> moves{{.kind = Kind::rapid, .to = from}};
  Vec2 end = to;
  if (run_out.length > 0 && from.u != to.u) {
    const Vec2 begin = begin_of_run_out(from, to, run_out.length);
    end = end_of_run_out(begin, to, home, slope_of(run_out.angle_deg));
    moves.push_back({.kind = Kind::thread, .to = begin});
  }
  moves.push_back({.kind = Kind::thread, .to = end});
  moves.push_back({.kind = Kind::rapid, .to = {end.u, home.v}});
  moves.push_back({.kind = Kind::rapid, .to = home});
  return moves;
}

}  // namespace kerf::control
