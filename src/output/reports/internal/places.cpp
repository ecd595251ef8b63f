#include "output/reports/internal/places.hpp"

#include "base/decimal.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::output {

using base::number_text;
using base::tidy;
using stock::Vec3;

// A turned part has no Y, and its X is a diameter.
std::string point_json(Vec3 at, bool turns) {
  JsonObject object;
  object.number("X", tidy(turns ? 2 * at.x : at.x));
  if (!turns) object.number("Y", tidy(at.y));
  return object.number("Z", tidy(at.z)).done();
}

std::string bounds_json(const stock::Bounds& box, bool turns) {
  if (box.low.x > box.high.x) return "{}";
  const auto range = [](double low, double high) {
    return "[" + number_text(tidy(low)) + "," + number_text(tidy(high)) + "]";
  };
  JsonObject object;
  object.raw("X", turns ? range(0, 2 * box.high.x) : range(box.low.x, box.high.x));
  if (!turns) object.raw("Y", range(box.low.y, box.high.y));
  return object.raw("Z", range(box.low.z, box.high.z)).done();
}

std::string numbers_json(const std::vector<double>& values) {
  std::vector<std::string> items;
  for (const double value : values) items.push_back(number_text(tidy(value)));
  return json_array(items);
}

}  // namespace kerf::output
