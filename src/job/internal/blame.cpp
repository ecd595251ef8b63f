#include "job/internal/blame.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace kerf::job {

using base::BlockId;

std::vector<Blame> blame(std::span<const stock::compare::MotionShare> motions,
                         const MotionLines& lines) {
  std::map<std::pair<base::FileId, std::uint32_t>, Blame> by_line;
  for (const stock::compare::MotionShare& one : motions) {
    const BlockId block = lines.block(one.motion);
    Blame& of = by_line[{block.file, block.line}];
    of.share += one.share;
    if (one.share > of.of_motion) {
      of.of_motion = one.share;
      of.motion = one.motion;
      of.block = block;
    }
  }
  std::vector<Blame> sorted;
  for (const auto& [line, of] : by_line) sorted.push_back(of);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Blame& a, const Blame& b) { return a.share > b.share; });
  return sorted;
}

std::vector<output::StockFacts::LineShare> told(const std::vector<Blame>& lines,
                                                const base::SourceSet& sources) {
  std::vector<output::StockFacts::LineShare> out;
  for (const Blame& one : lines) {
    const bool is_known = sources.contains(one.block.file);
    out.push_back(
        {is_known ? sources[one.block.file].name() : std::string{}, one.block.line, one.share});
  }
  return out;
}

}  // namespace kerf::job
