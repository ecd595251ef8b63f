#include "output/reports/line_runs.hpp"

namespace kerf::output {

void LineRuns::count(base::FileId file, std::uint32_t line) {
  Runs& runs = lines_[key_of(file, line)];
  ++runs.count;
  runs.last = ++counted_;
}

std::uint64_t LineRuns::of(base::FileId file, std::uint32_t line) const {
  const auto found = lines_.find(key_of(file, line));
  return found == lines_.end() ? 0 : found->second.count;
}

}  // namespace kerf::output
