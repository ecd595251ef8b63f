#pragma once

#include <span>
#include <vector>

#include "job/motion_lines.hpp"
#include "output/reports/stock_facts.hpp"

namespace kerf::job {

/// A line with its share of a region, and which of its motions has most of that.
struct Blame {
  base::BlockId block;
  std::uint32_t motion = 0;
  double share = 0;
  double of_motion = 0;
};

/// The lines of these motions, the largest share first.
[[nodiscard]] std::vector<Blame> blame(std::span<const stock::compare::MotionShare> motions,
                                       const MotionLines& lines);
/// As reports have them.
[[nodiscard]] std::vector<output::StockFacts::LineShare> told(const std::vector<Blame>& lines,
                                                              const base::SourceSet& sources);

}  // namespace kerf::job
