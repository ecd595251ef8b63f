#include "output/picture/internal/cut_measure.hpp"

#include <algorithm>

#include "base/decimal.hpp"
#include "motion/feed.hpp"
#include "output/picture/drawing/text.hpp"

namespace kerf::output::plot {

bool SpeedOfCut::is_drawn(const motion::Mark& mark) const {
  const bool beam_off = beam_was_on_ && !(mark.power_percent > 0);
  return mark.kind == motion::MoveKind::cut && !beam_off;
}

double SpeedOfCut::take(const CutPeriod& period) {
  beam_was_on_ = beam_was_on_ || period.mark.power_percent > 0;
  const double speed =
      period.time_s > 0 ? period.way_mm / period.time_s * motion::kSecondsPerMinute : 0;
  if (is_drawn(period.mark)) fastest_ = std::max(fastest_, speed);
  return speed;
}

std::string SpeedOfCut::caption() const {
  const std::string fastest =
      fastest_ < 10 ? significant(fastest_) : base::rounded_text(fastest_, 0);
  return "fastest cut " + fastest + " \u00b7 dots: short slow places";
}

}  // namespace kerf::output::plot
