#include "stock/field/contact_rule.hpp"

#include <algorithm>

namespace kerf::stock::field {
namespace {

/// What rounding to float leaves of heights that are the same.
constexpr double kRounding_mm = 1e-4;

Meeting outside_of(Span edges, Span met) {
  if (met.low >= met.high) return {};
  if (edges.low > edges.high) return {met.high - met.low, met.low};
  const double below = std::max(0.0, std::min(met.high, edges.low) - met.low);
  const double above = std::max(0.0, met.high - std::max(met.low, edges.high));
  return {below + above, below > 0 ? met.low : std::max(met.low, edges.high)};
}

}  // namespace

Meeting meet(Span material, Span edges, const PartSpan& part, double touch_mm) {
  const double high = std::min(part.whole.high, material.high);
  const Meeting shrunk = outside_of(edges, {std::max(part.shrunk_low, material.low), high});
  if (shrunk.depth_mm <= std::max(touch_mm, kRounding_mm)) return {};
  return outside_of(edges, {std::max(part.whole.low, material.low), high});
}

}  // namespace kerf::stock::field
