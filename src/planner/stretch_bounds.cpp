#include "planner/stretch_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf::planner {
namespace {

using base::AxisVector;
using base::JointJet;

/// The largest absolute value of what was seen.
class Most {
 public:
  void see(double value) { value_ = std::max(value_, std::fabs(value)); }
  /// Of the polynomial of degree 3 with these values and derivatives at both ends of an interval,
  /// from its coefficients in Bernstein's form.
  void see(double begin, double begin_rate, double end, double end_rate, double width) {
    see(begin);
    see(begin + width / 3 * begin_rate);
    see(end - width / 3 * end_rate);
    see(end);
  }
  [[nodiscard]] double value() const { return value_; }

 private:
  double value_ = 0;
};

/// The least and the most of what was seen.
class Range {
 public:
  void see(double value) {
    low_ = std::min(low_, value);
    high_ = std::max(high_, value);
  }
  [[nodiscard]] double high() const { return high_; }
  [[nodiscard]] double width() const { return std::max(0.0, high_ - low_); }

 private:
  double low_ = std::numeric_limits<double>::infinity();
  double high_ = -std::numeric_limits<double>::infinity();
};

// Between two samples that agree a function is nearly the polynomial with its values and
// derivatives there; this much more is left to it.
constexpr double kALittle = 1.02;

double bound(const Stretch& stretch, AxisVector JointJet::*value, AxisVector JointJet::*rate,
             std::size_t m) {
  Most most;
  for (const JointSample& sample : stretch.samples()) {
    if (sample.rates) most.see(((*sample.rates).*value).values[m]);
  }
  for (std::size_t i = 1; i < stretch.samples().size(); ++i) {
    const auto& a = stretch.samples()[i - 1].rates;
    const auto& b = stretch.samples()[i].rates;
    if (!a || !b) continue;
    most.see(((*a).*value).values[m], ((*a).*rate).values[m], ((*b).*value).values[m],
             ((*b).*rate).values[m], stretch.length() / 2);
  }
  return kALittle * most.value();
}

// Of the highest derivative less is known. Between two samples it is nearly the parabola with its
// values there and the mean that the derivative below tells; half of what is seen differs by is
// added.
double bound_of_third(const Stretch& stretch, std::size_t m) {
  Most most;
  Range range;
  const auto see = [&](double value) {
    most.see(value);
    range.see(value);
  };
  for (const JointSample& sample : stretch.samples()) {
    if (sample.rates) see(sample.rates->third.values[m]);
  }
  for (std::size_t i = 1; i < stretch.samples().size(); ++i) {
    const auto& a = stretch.samples()[i - 1].rates;
    const auto& b = stretch.samples()[i].rates;
    if (!a || !b) continue;
    const double way = b->second.values[m] - a->second.values[m];
    see(3 * way / (stretch.length() / 2) - a->third.values[m] - b->third.values[m]);
  }
  return kALittle * (most.value() + range.width() / 2);
}

LinkageBend bend_at(const JointSample& sample, const Linkage& linkage,
                    const AxisVector& acceleration) {
  return {linkage.tip_way_mm(sample.joints, sample.rates->second),
          linkage.swing_mm(sample.joints, sample.rates->first),
          linkage.swing_mm(sample.joints, acceleration)};
}

// Half of what the samples differ by may lie between them.
LinkageBend most_bend(const Stretch& stretch, const StretchBends& bends) {
  Range bend;
  Range swing;
  Range gain;
  for (std::size_t i = 0; i < bends.size(); ++i) {
    if (!stretch.samples()[i].rates) continue;
    bend.see(bends[i].bend);
    swing.see(bends[i].swing);
    gain.see(bends[i].gain);
  }
  const auto most = [](const Range& range) {
    return std::max(0.0, kALittle * (range.high() + range.width() / 2));
  };
  return {most(bend), most(swing), most(gain)};
}

}  // namespace

StretchBends bends_of(const Stretch& stretch, const Linkage& linkage,
                      const AxisVector& acceleration) {
  StretchBends bends;
  for (std::size_t i = 0; i < bends.size(); ++i) {
    const JointSample& sample = stretch.samples()[i];
    if (sample.rates) bends[i] = bend_at(sample, linkage, acceleration);
  }
  return bends;
}

// From the samples whose rates are determined; from how far the axes go, where none are.
CellBounds bounds_of(const Stretch& stretch, const StretchBends& bends, double curvature,
                     std::size_t axes) {
  CellBounds bounds;
  const auto& samples = stretch.samples();
  const AxisVector way = samples[2].joints - samples[0].joints;
  const bool blind = !samples[0].rates && !samples[1].rates && !samples[2].rates;
  for (std::size_t m = 0; m < axes; ++m) {
    bounds.driven.first.values[m] = blind ? std::fabs(way.values[m]) / stretch.length()
                                          : bound(stretch, &JointJet::first, &JointJet::second, m);
    bounds.driven.second.values[m] = bound(stretch, &JointJet::second, &JointJet::third, m);
    bounds.driven.third.values[m] = bound_of_third(stretch, m);
  }
  bounds.curvature = curvature;
  bounds.linkage = most_bend(stretch, bends);
  return bounds;
}

CellBounds bounds_at(const JointJet& rates, const LinkageBend& bend, const CellBounds& stretch) {
  CellBounds bounds = stretch;
  bounds.linkage = bend;
  for (std::size_t m = 0; m < base::kMaxAxes; ++m) {
    bounds.driven.first.values[m] = std::fabs(rates.first.values[m]);
    bounds.driven.second.values[m] = std::fabs(rates.second.values[m]);
    bounds.driven.third.values[m] = std::fabs(rates.third.values[m]);
  }
  return bounds;
}

}  // namespace kerf::planner
