#include "face/server/hub/internal/part_export.hpp"

#include <algorithm>
#include <filesystem>

#include "face/server/hub/internal/part_job.hpp"
#include "job/facts_of_stock.hpp"
#include "job/part_file.hpp"
#include "job/stock_part.hpp"
#include "machine/definition/set_up.hpp"
#include "output/part/part_solids.hpp"
#include "output/solid/glb_writer.hpp"
#include "output/solid/stl_writer.hpp"
#include "output/solid/three_mf_writer.hpp"

namespace kerf::server {
namespace {

using base::Outcome;

/// A part must not take the place of what it is cut from.
Outcome<void> keep_apart(const PartExport& part) {
  const auto set_up = machine::read_set_up(part.set_up, "set-up");
  if (!set_up) return tl::unexpected(set_up.error());
  const std::string name = part_name(part.source.program, part.format);
  const std::vector<std::string> read = set_up->files();
  if (name != part.source.program && std::find(read.begin(), read.end(), name) == read.end())
    return {};
  return base::usage("stock_export: " + name +
                     " is what the part is cut from: give the program another name");
}

/// Of the whole program: who mounts it next would not know that something is missing.
Outcome<void> save(const job::StockJob& job, const job::StockResult& result,
                   const output::StockFacts& facts, base::OutputFile& into) {
  if (result.status == machine::RunStatus::end) return job::save_part(job, result, facts, into);
  return base::usage(
      "stock_export: the run did not reach its end, so there is no part for the next one");
}

Outcome<void> write_solid(const std::string& format, const job::StockResult& result,
                          const output::StockFacts& facts, base::OutputFile& into) {
  const stock::surface::Surface surface = job::surface_of(result, {});
  if (format == "stl") {
    output::write_stl(surface.mesh, [&](std::string_view bytes) { into.write(bytes); });
    return {};
  }
  const output::SolidFile file =
      output::solid_file(job::title_of(result), facts, result.tool_spans, surface);
  if (format == "glb") {
    into.write(output::glb_of(file));
    return {};
  }
  const auto archive = output::three_mf_of(file);
  if (!archive) return tl::unexpected(archive.error());
  into.write(*archive);
  return {};
}

}  // namespace

std::string part_name(const std::string& program, const std::string& format) {
  return std::filesystem::path(program).stem().string() + "." + format;
}

Outcome<void> export_part(const PartExport& part, base::OutputFile& into) {
  if (auto apart = keep_apart(part); !apart) return apart;
  auto job = part_job(part.source, part.set_up, part.folder, Sight::none);
  if (!job) return tl::unexpected(job.error());
  job->job.budget.seconds = job::LivePart::kSeconds;
  job->job.budget.unwanted = part.unwanted;
  job->job.budget.input_waits = false;
  job->memory_bytes = job::LivePart::Order{}.memory_bytes;
  job->keeps_ways = true;
  auto result = job::cut_stock(*job);
  if (!result) return tl::unexpected(result.error());
  output::StockFacts facts = job::facts_of(*result);
  facts.shape = job->said;
  return part.format == "kstock" ? save(*job, *result, facts, into)
                                 : write_solid(part.format, *result, facts, into);
}

}  // namespace kerf::server
