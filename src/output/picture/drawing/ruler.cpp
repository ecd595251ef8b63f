#include "output/picture/drawing/ruler.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "output/picture/drawing/text.hpp"

namespace kerf::output::plot {
namespace {

// mantissa * 10^exponent, with its division into minor steps.
struct RoundStep {
  int mantissa;
  int exponent;
  int divisions;
  // Multiples from integers, so that 3 steps of 0.1 are 0.3.
  [[nodiscard]] double times(double count) const {
    double power = 1;
    for (int i = 0; i < std::abs(exponent); ++i) power *= 10;
    return exponent < 0 ? count * mantissa / power : count * mantissa * power;
  }
};

RoundStep round_step(double at_least) {
  int exponent = -12;
  for (; exponent < 15; ++exponent) {
    for (const RoundStep step :
         {RoundStep{1, exponent, 5}, RoundStep{2, exponent, 4}, RoundStep{5, exponent, 5}}) {
      if (step.times(1) >= at_least * (1 - 1e-9)) return step;
    }
  }
  return {1, exponent, 5};
}

}  // namespace

std::vector<Tick> ruler(double low, double high, double min_step, double label_factor) {
  const RoundStep step = round_step(min_step * label_factor);
  const double minor = step.times(1) / step.divisions;
  const double slack = 1e-6;  // of a minor step: an end that is a round value belongs to the ruler
  const auto first = static_cast<std::int64_t>(std::ceil(low * label_factor / minor - slack));
  const auto last = static_cast<std::int64_t>(std::floor(high * label_factor / minor + slack));
  std::vector<Tick> ticks;
  for (std::int64_t i = first; i <= last; ++i) {
    const double shown = step.times(static_cast<double>(i) / step.divisions);
    const bool major = i % step.divisions == 0;
    ticks.push_back(
        {shown / label_factor, major,
         major ? base::rounded_text(shown, std::max(0, -step.exponent)) : std::string()});
  }
  return ticks;
}

}  // namespace kerf::output::plot
