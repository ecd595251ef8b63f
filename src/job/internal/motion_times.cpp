#include "job/internal/motion_times.hpp"

#include <algorithm>

#include "job/run.hpp"
#include "motion/axis_point.hpp"

namespace kerf::job {
namespace {

/// Notes when each of some motions is last under way.
class Clock final : public motion::AxisPointSink {
 public:
  explicit Clock(std::vector<std::uint64_t> motions)
      : motions_(std::move(motions)), times_s_(motions_.size()) {}

  void take(const motion::AxisPoint& point) override {
    while (next_ < motions_.size() && motions_[next_] < point.tip.mark.motion) {
      times_s_[next_] = last_s_;
      ++next_;
    }
    last_s_ = point.tip.time_s;
  }
  [[nodiscard]] bool is_done() const { return next_ == motions_.size(); }
  /// What is still under way ends with the run.
  [[nodiscard]] double of(std::uint64_t motion) const {
    const auto place = std::lower_bound(motions_.begin(), motions_.end(), motion);
    const auto i = static_cast<std::size_t>(place - motions_.begin());
    return i < next_ ? times_s_[i] : last_s_;
  }

 private:
  std::vector<std::uint64_t> motions_;  // rising
  std::vector<double> times_s_;
  std::size_t next_ = 0;
  double last_s_ = 0;
};

}  // namespace

std::vector<double> times_of(const Job& job, const std::vector<stock::Finding>& findings) {
  std::vector<std::uint64_t> motions;
  for (const stock::Finding& finding : findings) {
    if (finding.motion > 0) motions.push_back(finding.motion);
  }
  std::vector<double> times(findings.size());
  if (motions.empty()) return times;
  std::sort(motions.begin(), motions.end());
  motions.erase(std::unique(motions.begin(), motions.end()), motions.end());
  auto run = Run::of(job);
  if (!run) return times;
  Clock clock(std::move(motions));
  (*run)->machine().add_point_sink(clock);
  (*run)->go();
  for (std::size_t i = 0; i < findings.size(); ++i) {
    if (findings[i].motion > 0) times[i] = clock.of(findings[i].motion);
  }
  return times;
}

}  // namespace kerf::job
