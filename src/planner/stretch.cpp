#include "planner/stretch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf::planner {
namespace {

using base::AxisVector;
using base::JointJet;
using base::JointPoint;
using base::TipJet;

// What rounding makes of a joint, mm or degrees, where the last digit of the tip is one of its own.
constexpr double kRounding = 1e-12;

double largest(const AxisVector& v) {
  double most = 0;
  for (const double value : v.values) most = std::max(most, std::fabs(value));
  return most;
}

/// A function and its first two derivatives at both ends of an interval.
struct Ends {
  double value[2], first[2], second[2];
};

bool agree(const Ends& f, double width, double hidden) {
  const double change = f.value[1] - f.value[0];
  const double promised =
      width / 2 * (f.first[0] + f.first[1]) + width * width / 12 * (f.second[0] - f.second[1]);
  const double most = width * std::max(std::fabs(f.first[0]), std::fabs(f.first[1]));
  return std::fabs(change - promised) <= Stretch::kAgreement * most + hidden;
}

bool half_agrees(const JointJet& a, const JointJet& b, double width, std::size_t m, double hidden) {
  const auto ends = [&](auto value, auto first, auto second) {
    return Ends{{(a.*value).values[m], (b.*value).values[m]},
                {(a.*first).values[m], (b.*first).values[m]},
                {(a.*second).values[m], (b.*second).values[m]}};
  };
  return agree(ends(&JointJet::value, &JointJet::first, &JointJet::second), width, hidden) &&
         agree(ends(&JointJet::first, &JointJet::second, &JointJet::third), width, hidden / width);
}

bool thirds_agree(const JointJet& a, const JointJet& b, const JointJet& c, double width,
                  std::size_t m, double hidden) {
  const double p = a.third.values[m];
  const double q = b.third.values[m];
  const double r = c.third.values[m];
  const double change = c.second.values[m] - a.second.values[m];
  const double most = width * std::max({std::fabs(p), std::fabs(q), std::fabs(r)});
  return std::fabs(change - width / 6 * (p + 4 * q + r)) <=
         Stretch::kAgreement * most + hidden / (width * width);
}

}  // namespace

JointSample Stretch::look_at(double at, const JointPoint& previous) const {
  const TipJet tip = curve_.jet(at);
  JointSample sample{tip.value, linkage_.joints(tip.value, previous), {}};
  sample.rates = linkage_.along(tip, sample.joints);
  return sample;
}

void Stretch::look(double begin, const JointSample& first, double end) {
  length_ = end - begin;
  samples_[0] = first;
  samples_[1] = look_at(begin + length_ / 2, first.joints);
  samples_[2] = look_at(end, samples_[1].joints);
}

bool Stretch::agrees() const {
  if (!samples_[0].rates || !samples_[1].rates || !samples_[2].rates) return false;
  AxisVector least;
  least.values.fill(kRounding);
  return agrees_within(least) || agrees_within(least + rounding());
}

bool Stretch::agrees_within(const AxisVector& hidden) const {
  const JointJet& a = *samples_[0].rates;
  const JointJet& b = *samples_[1].rates;
  const JointJet& c = *samples_[2].rates;
  for (std::size_t m = 0; m < linkage_.size(); ++m) {
    const double most = hidden.values[m];
    if (!half_agrees(a, b, length_ / 2, m, most) || !half_agrees(b, c, length_ / 2, m, most) ||
        !thirds_agree(a, b, c, length_, m, most))
      return false;
  }
  return true;
}

// Of the joints and of the tip, which the joints show enlarged near a singular place.
AxisVector Stretch::rounding() const {
  constexpr double kLastDigits = 16 * std::numeric_limits<double>::epsilon();
  const double rounding = kLastDigits * (curve_.magnitude() + largest(curve_.end()));
  AxisVector result;
  for (std::size_t m = 0; m < linkage_.size(); ++m)
    result.values[m] = kLastDigits * std::fabs(samples_[1].joints.values[m]);
  for (std::size_t axis = 0; axis < base::kMaxAxes; ++axis) {
    TipJet tip;
    tip.value = samples_[1].tip;
    tip.first.values[axis] = rounding;
    const auto joints = linkage_.along(tip, samples_[1].joints);
    if (!joints) continue;
    for (std::size_t m = 0; m < base::kMaxAxes; ++m)
      result.values[m] += std::fabs(joints->first.values[m]);
  }
  return result;
}

}  // namespace kerf::planner
