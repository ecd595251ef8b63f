#include "face/server/hub/internal/part_job.hpp"

#include <fmt/format.h>

#include <utility>

#include "face/server/store/program_name.hpp"
#include "job/part_comparison.hpp"
#include "job/stock_table.hpp"
#include "machine/definition/set_up.hpp"
#include "machine/definition/tools/tool_comment.hpp"
#include "motion/feed.hpp"

namespace kerf::server {
namespace {

using base::Outcome;
using machine::SetUp;

/// A file that a set-up names is one of the library: a client sees nothing else of this computer.
Outcome<void> keep_to(const std::string& folder, machine::StockFile& file) {
  if (auto checked = check_program_name(file.path); !checked) return checked;
  file.path = folder + "/" + file.path;
  return {};
}

Outcome<void> keep_to(const std::string& folder, SetUp& set_up) {
  std::vector<machine::StockFile*> files;
  const auto add = [&](SetUp::Piece& piece) {
    if (auto* const file = std::get_if<machine::StockFile>(&piece.word)) files.push_back(file);
  };
  if (set_up.stock) add(*set_up.stock);
  for (SetUp::Piece& fixture : set_up.fixtures) add(fixture);
  if (set_up.design) files.push_back(&set_up.design->file);
  for (machine::StockFile* const file : files) {
    if (auto kept = keep_to(folder, *file); !kept) return kept;
  }
  return {};
}

Outcome<SetUp> set_up_in(const std::string& toml, const std::string& folder) {
  auto set_up = machine::read_set_up(toml, "set-up");
  if (!set_up) return set_up;
  if (auto kept = keep_to(folder, *set_up); !kept) return tl::unexpected(kept.error());
  return set_up;
}

/// As `kerf stock` looks for them: the set-up's, the machine's, those of comments.
std::vector<stock::Tool> tools_of(const SetUp& set_up, const machine::MachineDefinition& definition,
                                  const base::SourceFile& program) {
  std::vector<stock::Tool> tools = set_up.tools;
  tools.insert(tools.end(), definition.tools.begin(), definition.tools.end());
  const machine::CommentStyle style{
      definition.parameters.power_on_inch ? motion::kMillimetresPerInch : 1, definition.turns()};
  for (stock::Tool& tool : machine::tools_in_comments(program, style)) tools.push_back(tool);
  return tools;
}

/// The design gets at most half of the memory of the part.
Outcome<void> see_design(const std::optional<SetUp::Design>& design, job::StockJob& job) {
  if (!design) return {};
  job.memory_bytes = job::LivePart::Order{}.memory_bytes;
  const std::size_t before = job.mesh_bytes;
  if (auto shown = job::show_design(design, job); !shown) return shown;
  const std::size_t most = job.memory_bytes / 2;
  if (job.mesh_bytes - before > most) {
    return base::usage(fmt::format(
        "{}: the design needs {} MiB, and a panel gives it {}: it has too many triangles",
        design->file.path, (job.mesh_bytes - before) >> 20U, most >> 20U));
  }
  return {};
}

}  // namespace

Outcome<void> check_set_up(const std::string& toml) {
  const auto set_up = set_up_in(toml, ".");
  return set_up ? Outcome<void>{} : tl::unexpected(set_up.error());
}

Outcome<job::StockJob> part_job(const PartSource& source, const std::string& set_up,
                                const std::string& folder, Sight sight) {
  auto laid_out = set_up_in(set_up, folder);
  if (!laid_out) return tl::unexpected(laid_out.error());
  auto text = source.text();
  if (!text) return tl::unexpected(text.error());
  const auto program = text->open();
  if (!program) return tl::unexpected(program.error());
  job::StockJob job{.job = source.job};
  job.job.program = *text;
  const auto design = std::exchange(laid_out->design, std::nullopt);
  if (auto laid = job::lay(*laid_out, **program, job); !laid) return tl::unexpected(laid.error());
  job.tools = machine::ToolChoice(tools_of(*laid_out, source.job.definition, **program));
  if (sight == Sight::none) return job;
  if (auto shown = see_design(design, job); !shown) return tl::unexpected(shown.error());
  return job;
}

}  // namespace kerf::server
