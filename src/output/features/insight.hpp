#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "motion/axis_setup.hpp"
#include "output/features/feature_facts.hpp"
#include "output/reports/time_report.hpp"

namespace kerf::output {

/// What one wants to know of a program that one opens. What it points to outlives it.
struct InsightFacts {
  FeatureFacts features;  ///< its tree may be null
  std::uint64_t lines = 0;
  std::uint64_t bytes = 0;
  std::vector<TimeReport::ToolTime> tools;  ///< by number
  const motion::AxisSetup* axes = nullptr;
};

/// Members of a JSON object, apart by commas: `size`, `time_s`, `tools`, `travel`, `status`,
/// `alarm`.
[[nodiscard]] std::string run_insight_members(const InsightFacts& facts);
/// How often which type was found, and what was not recognised: `features`, `unrecognised`; without
/// a tree null and nothing.
[[nodiscard]] std::string feature_insight_members(const FeatureFacts& facts);

}  // namespace kerf::output
