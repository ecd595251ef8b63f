#include "stock/turned/met.hpp"

#include <algorithm>
#include <cmath>

#include "stock/turned/revolved.hpp"

namespace kerf::stock::turned {
namespace {

using contour::Contour;

// What rounding leaves along a border: less area, or thinner.
constexpr double kDust_mm2 = 1e-7;
constexpr double kDust_mm = 1e-6;

double depth_of(const Contour& loop) {
  const contour::Box box = contour::extents(loop);
  return std::min(box.high.u - box.low.u, box.high.v - box.low.v);
}

bool is_dust(const Contour& loop) {
  const double area = contour::area(loop);
  return area < kDust_mm2 || area < kDust_mm * contour::length(loop);
}

}  // namespace

bool counts(const contour::Region& met, double touch_mm) {
  return std::any_of(met.loops.begin(), met.loops.end(), [&](const Contour& loop) {
    return !is_dust(loop) && depth_of(loop) > touch_mm;
  });
}

Contact contact_of(const contour::Region& met) {
  Contact sum;
  for (const Contour& loop : met.loops) {
    if (is_dust(loop)) continue;
    const contour::Vec2 middle = contour::extents(loop).middle();
    sum.add({depth_of(loop), {middle.v, 0, middle.u}, {}});
  }
  sum.volume = Exact(volume(met));
  return sum;
}

}  // namespace kerf::stock::turned
