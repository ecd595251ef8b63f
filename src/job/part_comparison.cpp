#include "job/part_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "job/internal/blame.hpp"
#include "job/internal/left_solid.hpp"
#include "job/internal/places_apart.hpp"
#include "machine/definition/mesh_file.hpp"
#include "stock/compare/deviation.hpp"
#include "stock/cutting/findings.hpp"

namespace kerf::job {
namespace {

using base::BlockId;
using base::Outcome;
using stock::Bounds;
using stock::Vec3;
using stock::compare::Comparison;
using stock::compare::Region;
using stock::compare::Side;

/// Too little is there because the stock ends, not because a line has cut it.
bool lacks_stock(const Region& region, const std::vector<Blame>& lines) {
  double cut = 0;
  for (const Blame& one : lines) cut += one.share;
  return region.side == Side::gouge && 1 - cut > (lines.empty() ? 0 : lines.front().share);
}

stock::Finding finding_of(const Region& region, const std::vector<Blame>& lines,
                          const StockResult& result) {
  const bool is_gouge = region.side == Side::gouge;
  const bool is_nobodys = lines.empty() || lacks_stock(region, lines);
  stock::Finding finding;
  finding.code = is_gouge ? base::Code::gouge : base::Code::excess;
  finding.detail =
      fmt::format("{:.4g} mm at most, {:.4g} mm³ over {:.4g} mm²{}", region.max_mm,
                  region.volume_mm3, region.area_mm2, is_nobodys ? ", where nothing was cut" : "");
  finding.at = region.at;
  finding.depth_mm = region.max_mm;
  finding.volume_mm3 = region.volume_mm3;
  if (is_nobodys) return finding;
  finding.block = lines.front().block;
  finding.motion = lines.front().motion;
  finding.tool = tool_at(result.tool_spans, lines.front().motion).value_or(0);
  return finding;
}

/// The regions' lines, and a finding each.
void take_regions(Comparison comparison, const StockJob& job, StockResult& result) {
  const base::SourceSet& sources = result.run->machine().sources();
  output::StockFacts::Compared compared;
  std::vector<stock::Finding> findings;
  for (Region& region : comparison.regions) {
    const std::vector<Blame> lines = blame(region.motions, result.lines);
    compared.lines.push_back(told(lines, sources));
    region.motions = {};  // the lines say it
    stock::Finding finding = finding_of(region, lines, result);
    const bool counts =
        std::find(job.left_out.begin(), job.left_out.end(), finding.code) == job.left_out.end();
    if (counts) findings.push_back(std::move(finding));
  }
  std::vector<BlockId> blocks;
  for (const stock::Finding& finding : findings) blocks.push_back(finding.block);
  find_line_starts(sources, blocks);
  for (std::size_t i = 0; i < findings.size(); ++i) {
    findings[i].block = blocks[i];
    result.findings.push_back(std::move(findings[i]));
  }
  stock::put_in_order(result.findings);
  compared.found = std::move(comparison);
  result.compare = std::move(compared);
}

/// A file whose numbers are no millimetres is larger or smaller than what it is cut from.
bool is_odd(Vec3 design, Vec3 stock) {
  constexpr double kLarger = 2;
  constexpr double kSmaller = 10;
  const double largest = std::max({stock.x, stock.y, stock.z});
  const double of_design = std::max({design.x, design.y, design.z});
  return of_design > kLarger * largest || of_design * kSmaller < largest;
}

std::string size_text(Vec3 size) {
  return fmt::format("{:.4g} × {:.4g} × {:.4g} mm", size.x, size.y, size.z);
}

}  // namespace

Outcome<void> read_design(const machine::SetUp::Design& design, StockJob& job) {
  auto read = machine::read_mesh(design.file.path, design.file.unit, job.memory_for_model());
  if (!read) return tl::unexpected(read.error());
  const stock::Placement place = design.place.value_or(stock::Placement{});
  if (place != stock::Placement{}) {
    const stock::Placing placing(place);
    for (Vec3& point : read->mesh.points) point = placing(point);
  }
  job.design = std::make_shared<const Design>(std::move(*read), design.file.unit);
  job.mesh_bytes += job.design->solid.bytes();
  return {};
}

Outcome<void> take_design(const std::optional<machine::SetUp::Design>& design, StockJob& job) {
  if (!design) return {};
  const double tolerance_mm = design->tolerance_mm.value_or(job.tolerance.larger());
  job.tolerance = {tolerance_mm, tolerance_mm};
  return read_design(*design, job);
}

Outcome<void> show_design(const std::optional<machine::SetUp::Design>& design, StockJob& job) {
  if (auto taken = take_design(design, job); !taken || !design) return taken;
  job.design_in_sight =
      DesignInSight{design->file.path, job.tolerance.larger(),
                    [of = job.design, jobs = threads_for(job)](std::span<const Vec3> places) {
                      return stock::compare::deviations_mm(of->solid, places, jobs);
                    }};
  return {};
}

Outcome<void> compare_with_design(const StockJob& job, StockResult& result) {
  if (!job.design) return {};
  const stock::compare::MeshSolid& design = job.design->solid;
  const Bounds stock = stock::bounds(result.shape);
  const Bounds wanted = design.bounds();
  if (are_apart(stock, wanted)) {
    return tl::unexpected(base::Failure{
        base::Failure::Kind::input,
        fmt::format("--design: it lies at {}, and the stock at {}: they have no place in common",
                    ranges(wanted), ranges(stock))});
  }
  for (const std::string& change : job.design->changes)
    result.assumed.push_back({0, "the design: " + change});
  if (is_odd(wanted.high - wanted.low, stock.high - stock.low)) {
    result.assumed.push_back(
        {0, fmt::format("the design is in {}: {}, the stock {}",
                        job.design->unit == machine::MeshUnit::inch ? "inches" : "millimetres",
                        size_text(wanted.high - wanted.low), size_text(stock.high - stock.low))});
  }
  take_regions(compared(job, result, *solid_of(result, design), design), job, result);
  return {};
}

std::vector<float> deviations_mm(const StockJob& job, const OtherPart* other,
                                 std::span<const Vec3> places) {
  if (!job.design) return stock::compare::deviations_mm(*other->solid, places, threads_for(job));
  return stock::compare::deviations_mm(job.design->solid, places, threads_for(job));
}

}  // namespace kerf::job
