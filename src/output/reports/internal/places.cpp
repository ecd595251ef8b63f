#include "output/reports/internal/places.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "geometry/angle.hpp"
#include "math/math.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::output {

using base::number_text;
using base::tidy;
using stock::Vec3;

namespace {

/// Half of the width of a box about the axis of a lathe.
double farthest(const stock::Bounds& box) {
  return std::max({std::fabs(box.low.x), box.high.x, std::fabs(box.low.y), box.high.y});
}

}  // namespace

// The part of a lathe has no Y: X is a diameter, and where it is not round C says the angle.
std::string point_json(Vec3 at, bool turns) {
  const bool is_turned = turns && at.y != 0;
  const double x = is_turned ? math::hypot(at.x, at.y) : at.x;
  JsonObject object;
  object.number("X", tidy(turns ? 2 * x : x));
  if (!turns) object.number("Y", tidy(at.y));
  object.number("Z", tidy(at.z));
  if (is_turned) object.number("C", tidy(geometry::degrees(math::atan2(at.y, at.x))));
  return object.done();
}

std::string bounds_json(const stock::Bounds& box, bool turns) {
  if (box.low.x > box.high.x) return "{}";
  const auto range = [](double low, double high) {
    return "[" + number_text(tidy(low)) + "," + number_text(tidy(high)) + "]";
  };
  JsonObject object;
  object.raw("X", turns ? range(0, 2 * farthest(box)) : range(box.low.x, box.high.x));
  if (!turns) object.raw("Y", range(box.low.y, box.high.y));
  return object.raw("Z", range(box.low.z, box.high.z)).done();
}

std::string numbers_json(const std::vector<double>& values) {
  std::vector<std::string> items;
  for (const double value : values) items.push_back(number_text(tidy(value)));
  return json_array(items);
}

}  // namespace kerf::output
