#include "stock/tool/measure.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"

namespace kerf::stock {
namespace {

using M = Measure;

constexpr double kMost_mm = 10000;
constexpr double kAnyLength_mm = 1e6;  // a gauge length is what the setter has measured

constexpr MeasureRow positive(M measure, std::string_view name, double most = kMost_mm) {
  return {measure, name, 0, most, false};
}
constexpr MeasureRow from_0(M measure, std::string_view name, double most = kMost_mm) {
  return {measure, name, 0, most};
}
constexpr MeasureRow whole(M measure, std::string_view name, double low, double high) {
  return {measure, name, low, high, true, true};
}

constexpr std::array<MeasureRow, kMeasures> kRows = {
    from_0(M::diameter, "diameter"),
    MeasureRow{M::length, "length", -kAnyLength_mm, kAnyLength_mm},
    positive(M::flute_length, "flute_length"),
    positive(M::stickout, "stickout"),
    whole(M::flutes, "flutes", 1, 1000),
    from_0(M::corner_radius, "corner_radius"),
    from_0(M::core_diameter, "core_diameter"),
    positive(M::angle, "angle", 180),
    from_0(M::tip_diameter, "tip_diameter"),
    from_0(M::tip_radius, "tip_radius"),
    positive(M::pilot_diameter, "pilot_diameter"),
    positive(M::pilot_length, "pilot_length"),
    from_0(M::lead, "lead"),
    positive(M::pitch, "pitch", 1000),
    positive(M::entering_angle, "entering_angle", 90),
    positive(M::ap_max, "ap_max"),
    positive(M::body_diameter, "body_diameter"),
    positive(M::width, "width"),
    positive(M::neck_diameter, "neck_diameter"),
    positive(M::height, "height"),
    positive(M::profile_angle, "profile_angle", 170),
    whole(M::teeth, "teeth", 1, 1000),
    from_0(M::nose_radius, "nose_radius", 1000),
    positive(M::tip_angle, "tip_angle", 175),
    positive(M::ic, "ic", 1000),
    positive(M::kapr, "kapr", 175),
    whole(M::tip, "tip", 0, 9),
    positive(M::minimum_bore, "minimum_bore"),
    positive(M::overhang, "overhang"),
    positive(M::holder_width, "holder_width"),
};

constexpr bool is_in_order() {
  for (std::size_t i = 0; i < kMeasures; ++i) {
    if (index(kRows[i].measure) != i) return false;
  }
  return true;
}
static_assert(is_in_order());

}  // namespace

bool MeasureRow::takes(double value) const {
  if (!(value >= low && value <= high) || (value == low && !low_too)) return false;
  return !whole || value == std::floor(value);
}

std::string MeasureRow::in_words() const {
  const std::string kind = whole ? "a whole number" : "a number";
  const std::string from = low_too ? " from " + base::number_text(low) + " to "
                                   : " above " + base::number_text(low) + " up to ";
  return kind + from + base::number_text(high);
}

const MeasureRow& row_of(Measure measure) { return kRows[index(measure)]; }

std::span<const MeasureRow> measure_rows() { return kRows; }

const MeasureRow* measure_named(std::string_view name) {
  const auto* const found = std::find_if(kRows.begin(), kRows.end(),
                                         [&](const MeasureRow& row) { return row.name == name; });
  return found == kRows.end() ? nullptr : found;
}

}  // namespace kerf::stock
