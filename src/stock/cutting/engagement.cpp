#include "stock/cutting/engagement.hpp"

#include <algorithm>

#include "math/math.hpp"

namespace kerf::stock {
namespace {

/// What places that are rounded to floats may lack, of the radius.
constexpr double kSame = 1e-5;

/// The bins as the sides of the way see them.
class Bins {
 public:
  Bins(const Outcome& outcome, const EngagementSetting& setting)
      : across_(outcome.across),
        radius_mm_(setting.radius_mm),
        grain_mm_(setting.grain_mm),
        low_(-towards_rim(-outcome.aside.low)),
        high_(towards_rim(outcome.aside.high)) {}

  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double high() const { return high_; }

  /// act(from, to) for each stretch without a gap.
  template <class Act>
  void each_stretch(const Act& act) const {
    double from = low_;
    double behind = low_;  // the last bin that something was removed in
    for (std::size_t i = 0; i < Outcome::kBins; ++i) {
      if (across_[i].value() <= 0) continue;
      const double begin = std::max(edge(i), low_);
      if (begin - behind > 2 * grain_mm_) {
        act(from, behind);
        from = begin;
      }
      behind = edge(i + 1);
    }
    act(from, high_);
  }

  /// Share of what was removed that lies to the left of the way.
  [[nodiscard]] double left_mm3() const { return sum(Outcome::kBins / 2, Outcome::kBins); }
  [[nodiscard]] double right_mm3() const { return sum(0, Outcome::kBins / 2); }

 private:
  /// Half a cell on from the outermost place; what is almost at the rim is there.
  [[nodiscard]] double towards_rim(double s) const {
    const double edge = s + grain_mm_ / 2;
    return edge > radius_mm_ * (1 - kSame) ? radius_mm_ : edge;
  }
  [[nodiscard]] double edge(std::size_t i) const {
    return radius_mm_ * (2 * static_cast<double>(i) / static_cast<double>(Outcome::kBins) - 1);
  }
  [[nodiscard]] double sum(std::size_t from, std::size_t to) const {
    Exact all;
    for (std::size_t i = from; i < to; ++i) all += across_[i];
    return all.value();
  }

  const std::array<Exact, Outcome::kBins>& across_;
  double radius_mm_;
  double grain_mm_;
  double low_;
  double high_;
};

// Under M03 a mill that has the material on its right climbs.
CuttingSide side_of(const Bins& bins, const EngagementSetting& setting) {
  const double rim = setting.radius_mm - setting.grain_mm / 2;
  const double left = bins.left_mm3();
  const double right = bins.right_mm3();
  if ((bins.low() <= -rim && bins.high() >= rim) || left == right) return CuttingSide::slot;
  return (right > left) != setting.turns_left ? CuttingSide::climb : CuttingSide::conventional;
}

}  // namespace

Engagement engagement_of(const Outcome& outcome, const EngagementSetting& setting) {
  Engagement engagement;
  if (outcome.aside.is_empty() || !(setting.radius_mm > 0) || !(setting.length_mm > 0))
    return engagement;
  const Bins bins(outcome, setting);
  const auto at = [&](double s) {
    return math::asin(std::clamp(s / setting.radius_mm, -1.0, 1.0));
  };
  bins.each_stretch([&](double from, double to) {
    engagement.ae_mm += to - from;
    engagement.phi_rad += at(to) - at(from);
  });
  engagement.ap_mm = std::min(outcome.removed.value() / (engagement.ae_mm * setting.length_mm),
                              outcome.heights.length());
  engagement.side = side_of(bins, setting);
  return engagement;
}

}  // namespace kerf::stock
