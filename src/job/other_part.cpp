#include "job/other_part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "job/facts_of_run.hpp"
#include "job/internal/blame.hpp"
#include "job/internal/left_solid.hpp"
#include "job/internal/places_apart.hpp"
#include "job/part_file.hpp"
#include "job/stock_part.hpp"
#include "stock/compare/dexel_solid.hpp"
#include "stock/cutting/findings.hpp"
#include "stock/cutting/saved_part.hpp"
#include "stock/saved/saved_sheet.hpp"

namespace kerf::job {
namespace {

using base::Outcome;
using stock::Bounds;
using stock::SavedPart;
using stock::compare::Comparison;
using stock::compare::Region;
using stock::compare::Side;
using SavedKind = SavedPart::Kind;

/// The piece that a run began with, in words.
machine::StockWord piece_word(const StockResult& cut) {
  if (!cut.sheet || std::holds_alternative<stock::SavedShape>(cut.shape)) return cut.shape;
  const Bounds box = stock::bounds(cut.shape);
  return machine::StockSheet{box.low.x, box.low.y, box.high.x, box.high.y, box.high.z - box.low.z};
}

bool has_dexels(const StockResult& cut) { return cut.model_facts.kind == "tridexel"; }

/// The second one is cut as the first was, as far as its program lets it.
void follow(const StockJob& job, const StockResult& cut, StockJob& other) {
  other.shape = piece_word(cut);
  other.knows_stock = job.knows_stock;
  other.mesh_bytes = job.mesh_bytes;
  other.is_compared = true;
  other.tolerance = job.tolerance;
  if (cut.model_facts.kind == "profile") return;
  other.cell_mm = cut.wanted_cell_mm;
  other.least_cell_mm = cut.cell_mm;
  if (has_dexels(cut)) other.model = StockModel::tridexel;
}

/// Whether the first has to be cut again, and how.
bool follows_back(const StockResult& cut, const StockResult& other, StockJob& job) {
  const bool needs_dexels = has_dexels(other) && !has_dexels(cut);
  if (!needs_dexels && !(other.cell_mm > cut.cell_mm)) return false;
  if (cut.model_facts.kind == "profile" && !needs_dexels) return false;
  if (needs_dexels) job.model = StockModel::tridexel;
  job.cell_mm = other.wanted_cell_mm;
  job.least_cell_mm = other.cell_mm;
  return true;
}

const char* part_name(SavedKind kind) {
  switch (kind) {
    case SavedKind::turned: return "a turned part";
    case SavedKind::sheet: return "a sheet";
    case SavedKind::field:
    case SavedKind::dexels: break;
  }
  return "a milled part";
}

/// Failure (input): the machine makes no such part. What driven tools have left of a turned part is
/// kept as dexels.
Outcome<void> suits_machine(const SavedPart& part, const std::string& name,
                            const machine::MachineDefinition& machine) {
  const bool is_sheet = part.kind() == SavedKind::sheet;
  const bool is_turned = part.kind() == SavedKind::turned;
  const bool fits = is_sheet == machine.axes.beam && (!is_turned || machine.turns()) &&
                    (part.kind() != SavedKind::field || !machine.turns());
  if (fits) return {};
  return tl::unexpected(base::Failure{base::Failure::Kind::input,
                                      fmt::format("--against {}: it is {}, and {} makes none", name,
                                                  part_name(part.kind()), machine.name)});
}

Outcome<contour::Region> pieces_left(const stock::saved::SavedSheet& sheet,
                                     const std::string& name) {
  const bool has_ways = !sheet.state().cuts.empty() || sheet.state().tiles.empty();
  if (has_ways) return sheet.left();
  return tl::unexpected(
      base::Failure{base::Failure::Kind::input,
                    "--against " + name + ": the ways of the beam that cut it were not kept"});
}

Outcome<void> make_solid(const SavedPart& part, unsigned jobs, OtherPart& other) {
  if (const auto* const sheet = dynamic_cast<const stock::saved::SavedSheet*>(&part)) {
    auto pieces = pieces_left(*sheet, other.name);
    if (!pieces) return tl::unexpected(pieces.error());
    other.solid = plate_of(*pieces, part.box());
    return {};
  }
  other.model = part.model(jobs);
  other.solid = solid_of(*other.model, part.box());
  return {};
}

std::size_t bytes_beside(const SavedPart& part) {
  const bool has_discs = part.kind() == SavedKind::dexels;
  const double discs =
      has_discs ? stock::compare::DexelSolid::bytes_for(part.box(), part.cell_mm()) : 0;
  return part.bytes() + static_cast<std::size_t>(discs);
}

/// What is held alike is compared to the last bit.
void take_cells(const SavedPart& part, StockJob& job) {
  if (!job.cell_mm && part.cell_mm() > 0 && part.kind() != SavedKind::sheet)
    job.cell_mm = part.cell_mm();
  if (part.kind() == SavedKind::dexels && job.model == StockModel::automatic)
    job.model = StockModel::tridexel;
}

bool is_same_box(const Bounds& a, const Bounds& b) {
  constexpr double kAsWide_mm = 1e-3;
  const auto near = [](stock::Vec3 p, stock::Vec3 q) { return length(p - q) <= kAsWide_mm; };
  return near(a.low, b.low) && near(a.high, b.high);
}

/// Failure (input): what is left of two different pieces is not compared.
Outcome<void> is_of_same_piece(const OtherPart& other, const StockResult& result) {
  const Bounds here = stock::bounds(result.shape);
  if (other.piece && !is_same_box(*other.piece, here)) {
    return tl::unexpected(base::Failure{
        base::Failure::Kind::input,
        fmt::format("--against {}: it was cut from a piece at {}, and the stock lies at {}",
                    other.name, ranges(*other.piece), ranges(here))});
  }
  if (!are_apart(other.box, here)) return {};
  return tl::unexpected(base::Failure{
      base::Failure::Kind::input,
      fmt::format("--against {}: it lies at {}, and the stock at {}: they have no place in common",
                  other.name, ranges(other.box), ranges(here))});
}

void warn_of_difference(const StockJob& job, const OtherPart& other, const Comparison& found,
                        StockResult& result) {
  const auto& none = job.left_out;
  const bool is_left_out = std::find(none.begin(), none.end(), base::Code::differs) != none.end();
  if (is_left_out || found.regions.empty()) return;
  const Region& largest = found.regions.front();
  stock::Finding finding;
  finding.code = base::Code::differs;
  finding.detail =
      fmt::format("{:.4g} mm at most, {:.4g} mm³ only here, {:.4g} mm³ only in {}",
                  std::max(found.of(Side::excess).max_mm, found.of(Side::gouge).max_mm),
                  found.of(Side::excess).all_mm3, found.of(Side::gouge).all_mm3, other.name);
  finding.at = largest.at;
  finding.depth_mm = largest.max_mm;
  finding.volume_mm3 = largest.volume_mm3;
  result.findings.push_back(std::move(finding));
  stock::put_in_order(result.findings);
}

/// What the other run has assumed, as far as this one has not said it.
void take_assumed(const OtherPart& other, StockResult& result) {
  if (!other.cut) return;
  for (const control::Assumption& one : other.cut->assumed) {
    const bool is_told =
        std::any_of(result.assumed.begin(), result.assumed.end(),
                    [&](const control::Assumption& told) { return told.what == one.what; });
    if (!is_told) result.assumed.push_back({0, other.name + ": " + one.what});
  }
}

output::StockFacts::Against against_of(const OtherPart& other, const StockResult& result,
                                       Comparison found) {
  output::StockFacts::Against against;
  against.file = other.name;
  if (other.cut) {
    against.status = facts_of(other.cut->run->machine()).status;
    if (other.cut->is_stopped) against.status = output::RunFacts::Status::stopped;
  }
  for (Region& region : found.regions) {
    const base::SourceSet& sources = result.run->machine().sources();
    against.lines.push_back(told(blame(region.motions, result.lines), sources));
    std::vector<output::StockFacts::LineShare> there;
    if (other.cut)
      there = told(blame(region.there, other.cut->lines), other.cut->run->machine().sources());
    against.there.push_back(std::move(there));
    region.motions = {};  // the lines say it
    region.there = {};
  }
  against.found = std::move(found);
  return against;
}

}  // namespace

void share_memory(StockJob& job) { job.mesh_bytes += job.memory_for_model() / 2; }

Outcome<OtherPart> cut_other(StockJob& job, StockResult& cut, StockJob other,
                             const std::string& name) {
  follow(job, cut, other);
  auto result = cut_stock(other);
  if (!result) return tl::unexpected(result.error());
  if (follows_back(cut, *result, job)) {
    auto again = cut_stock(job);
    if (!again) return tl::unexpected(again.error());
    again->model_facts.reason = "the other part is held so";
    cut = std::move(*again);
  }
  OtherPart part{.name = name};
  part.cut = std::move(*result);
  part.solid = solid_of(*part.cut);
  part.box = part.solid->bounds();
  return part;
}

Outcome<OtherPart> read_other(const base::SourceFile& file, StockJob& job) {
  auto read = part_in(file, job.memory_for_model() / 2);
  if (!read) return tl::unexpected(read.error());
  const SavedPart& saved = *read->part;
  OtherPart part{.name = file.name()};
  if (auto suited = suits_machine(saved, part.name, job.job.definition); !suited)
    return tl::unexpected(suited.error());
  part.box = saved.box();
  if (saved.kind() != SavedKind::turned)
    part.piece = saved.box();  // what is left of a bar may be short
  if (auto made = make_solid(saved, threads_for(job), part); !made)
    return tl::unexpected(made.error());
  job.mesh_bytes += bytes_beside(saved);
  take_cells(saved, job);
  return part;
}

Outcome<void> compare_with_other(const StockJob& job, const OtherPart& other, StockResult& result) {
  if (auto same = is_of_same_piece(other, result); !same) return same;
  Comparison found = compared(job, result, *solid_of(result), *other.solid);
  warn_of_difference(job, other, found, result);
  take_assumed(other, result);
  result.against = against_of(other, result, std::move(found));
  return {};
}

}  // namespace kerf::job
