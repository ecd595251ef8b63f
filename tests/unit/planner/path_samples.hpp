#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "motion_axes.hpp"
#include "planner/path_sampler.hpp"

// What the tests of the PathSampler's modes share.
namespace kerf::planner::samples {

using base::AxisVector;
using base::TipPoint;
using motion::Motion;
using motion::Rapid;
using test::axes_named;
using Points = std::vector<motion::Setpoint>;

inline constexpr double kPrinted = 5.001e-7;  // six decimals
inline constexpr double kPeriod_s = 0.008;

inline Settings settings_of(Sampling sampling, double step_mm = 1) {
  Settings settings;
  settings.sampling = sampling;
  settings.period_s = kPeriod_s;
  settings.step_mm = step_mm;
  return settings;
}

inline Points sample(const std::vector<Motion::Action>& actions, const Settings& settings,
                     const char* letters = "XYZAC", double rapid_per_min = 10'000) {
  PathSampler sampler(axes_named(letters, rapid_per_min), settings);
  return test::points_of(sampler, test::motions_of(actions));
}

// A rapid to `from`, and what comes behind it.
inline Points sample_from(const TipPoint& from, const Motion::Action& action,
                          const Settings& settings) {
  Points points = sample({Rapid{from}, action}, settings);
  std::erase_if(points, [](const motion::Setpoint& point) { return point.mark.block.line == 1; });
  return points;
}

inline void expect_near(const AxisVector& got, const AxisVector& wanted, const std::string& what) {
  for (std::size_t m = 0; m < base::kMaxAxes; ++m)
    EXPECT_NEAR(got.values[m], wanted.values[m], kPrinted) << what << ", axis " << m;
}

inline void expect_rows(const Points& points, const std::vector<TipPoint>& rows) {
  ASSERT_EQ(points.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    expect_near(points[i].tip, rows[i], "point " + std::to_string(i + 1));
}

}  // namespace kerf::planner::samples
