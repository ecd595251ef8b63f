#include "job/internal/new_findings.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include "job/facts_of_stock.hpp"
#include "job/stock_run.hpp"

namespace kerf::job {
namespace {

// Cells along the longest side: a tool that runs into the part is seen, and it takes a moment.
constexpr int kMostAlong = 300;

/// What makes a finding the same one in two programs.
using Identity = std::tuple<base::Code, std::string, std::uint32_t>;

std::string file_of(const StockResult& result, const stock::Finding& finding) {
  const base::SourceSet& sources = result.run->machine().sources();
  return sources.contains(finding.block.file) ? sources[finding.block.file].name() : "";
}

/// The lines that a line of the original has become.
std::vector<std::uint32_t> lines_now(const std::vector<TextChange>& changes,
                                     const std::string& file, std::uint32_t line) {
  std::int64_t shift = 0;
  for (const TextChange& change : changes) {
    if (change.file != file || change.first > line) continue;
    const auto was = static_cast<std::uint32_t>(change.old_lines.size());
    const auto is = static_cast<std::uint32_t>(change.new_lines.size());
    if (line >= change.first + was) {
      shift += std::int64_t{is} - std::int64_t{was};
      continue;
    }
    const auto first = static_cast<std::uint32_t>(change.first + shift);
    if (was == is) return {first + (line - change.first)};
    std::vector<std::uint32_t> lines;
    for (std::uint32_t i = 0; i < is; ++i) lines.push_back(first + i);
    return lines;
  }
  return {static_cast<std::uint32_t>(line + shift)};
}

std::set<Identity> known_in(const StockResult& before, const std::vector<TextChange>& changes) {
  std::set<Identity> known;
  for (const stock::Finding& finding : before.findings) {
    const std::string file = file_of(before, finding);
    if (finding.block.line == 0) known.emplace(finding.code, file, 0);
    if (finding.block.line == 0) continue;
    for (const std::uint32_t line : lines_now(changes, file, finding.block.line))
      known.emplace(finding.code, file, line);
  }
  return known;
}

std::string sentence_of(const StockResult& result, const stock::Finding& finding) {
  const std::string code(base::text_of(finding.code).number);
  const std::string place =
      finding.block.line > 0 ? " LINE " + std::to_string(finding.block.line) : "";
  return code + place + ": " + told(finding, result.run->machine()).diagnostic.message;
}

base::Outcome<StockResult> cut_coarsely(StockJob job) {
  if (!job.cell_mm) job.most_along = kMostAlong;
  return cut_stock(job);
}

}  // namespace

NewFindings new_findings(const StockJob& before, const StockJob& after,
                         const std::vector<TextChange>& changes) {
  const auto was = cut_coarsely(before);
  if (!was) return {.skipped = was.error().message};
  const auto is = cut_coarsely(after);
  if (!is) return {.skipped = is.error().message};
  NewFindings added;
  if (was->findings_dropped > 0 || is->findings_dropped > 0)
    added.skipped = "more findings than are kept: the last ones were not compared";
  const std::set<Identity> known = known_in(*was, changes);
  for (const stock::Finding& finding : is->findings) {
    // Of a stock that nobody has described it is no news that a feature moved out of it.
    if (!after.knows_stock && finding.code == base::Code::stock_missed) continue;
    if (known.count({finding.code, file_of(*is, finding), finding.block.line}) == 0)
      added.found.push_back(sentence_of(*is, finding));
  }
  return added;
}

}  // namespace kerf::job
