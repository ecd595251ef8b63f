#include "job/other_part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "base/source_file.hpp"
#include "job/internal/blame.hpp"
#include "job/internal/left_solid.hpp"

namespace kerf::job {
namespace {

using base::Outcome;
using stock::compare::Comparison;
using stock::compare::Region;
using stock::compare::Side;

StockModel model_of(const StockResult& cut) {
  if (cut.model_facts.kind == "zmap") return StockModel::zmap;
  return cut.model_facts.kind == "tridexel" ? StockModel::tridexel : StockModel::automatic;
}

/// The piece that a run began with, in words.
machine::StockWord word_of(const StockResult& cut) {
  if (!cut.sheet) return cut.shape;
  const stock::Bounds box = stock::bounds(cut.shape);
  return machine::StockSheet{box.low.x, box.low.y, box.high.x, box.high.y,
                             box.high.z - box.low.z};
}

void warn(const StockJob& job, const std::string& name, const Comparison& found,
          StockResult& result) {
  const auto& none = job.left_out;
  const bool is_left_out = std::find(none.begin(), none.end(), base::Code::differs) != none.end();
  if (is_left_out || found.regions.empty()) return;
  stock::Finding finding;
  finding.code = base::Code::differs;
  finding.detail = fmt::format(
      "{:.4g} mm at most, {:.4g} mm³ only here, {:.4g} mm³ only in {}",
      std::max(found.of(Side::excess).max_mm, found.of(Side::gouge).max_mm),
      found.of(Side::excess).all_mm3, found.of(Side::gouge).all_mm3, name);
  finding.at = found.regions.front().at;
  finding.depth_mm = found.regions.front().max_mm;
  finding.volume_mm3 = found.regions.front().volume_mm3;
  result.findings.push_back(std::move(finding));
  stock::put_in_order(result.findings);
}

}  // namespace

void share_memory(StockJob& job) { job.mesh_bytes += job.memory_for_model() / 2; }

Outcome<StockResult> cut_other(StockJob& job, StockResult& cut, StockJob other) {
  other.shape = word_of(cut);
  other.cell_mm = cut.wanted_cell_mm;
  other.mesh_bytes = job.mesh_bytes;
  other.is_compared = true;
  if (model_of(cut) == StockModel::tridexel) other.model = StockModel::tridexel;
  auto result = cut_stock(other);
  if (!result) return result;
  if (model_of(cut) != StockModel::zmap || model_of(*result) != StockModel::tridexel) return result;
  job.model = StockModel::tridexel;
  auto again = cut_stock(job);
  if (!again) return again;
  cut = std::move(*again);
  return result;
}

bool is_saved_part(const std::string& path) {
  constexpr std::string_view kMagic = "KSTOCK";
  if (path == "-") return false;
  const auto file = base::SourceFile::open(path);
  if (!file) return false;
  std::string begin(kMagic.size(), '\0');
  return (*file)->read(0, begin) == begin.size() && begin == kMagic;
}

void compare_with_other(const StockJob& job, const std::string& name, const StockResult& other,
                        StockResult& result) {
  output::StockFacts::Against against;
  against.file = name;
  against.found = stock::compare::compare(*solid_of(result), *solid_of(other), job.tolerance,
                                          threads_for(job));
  for (Region& region : against.found.regions) {
    against.lines.push_back(
        told(blame(region.motions, result.lines), result.run->machine().sources()));
    against.there.push_back(told(blame(region.there, other.lines), other.run->machine().sources()));
    region.motions = {};
    region.there = {};
  }
  warn(job, name, against.found, result);
  result.against = std::move(against);
}

}  // namespace kerf::job
