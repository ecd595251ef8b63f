#include "training/part_trial.hpp"

#include "job/facts_of_stock.hpp"
#include "machine/definition/stock_words.hpp"
#include "machine/definition/tools/tool_import.hpp"
#include "training/trial.hpp"

namespace kerf::training {
namespace {

using base::Outcome;

// Cutting takes longer than running.
constexpr double kMostSeconds = 10;

/// Keeps the line of each motion.
class LineBook final : public stock::TimedCutSink {
 public:
  void take(const stock::TimedCut& timed) override {
    const auto number = static_cast<std::size_t>(timed.cut.motion);
    if (number >= lines.size()) lines.resize(number + 1);
    lines[number] = timed.cut.block.line;
  }

  std::vector<std::uint32_t> lines;
};

Outcome<void> take_fixtures(const PartWork& part, job::StockJob& job) {
  for (const std::string& words : part.fixtures) {
    auto fixture = machine::stock_word(words, "a fixture");
    if (!fixture) return tl::unexpected(fixture.error());
    const auto* const piece = std::get_if<stock::Workpiece>(&*fixture);
    if (piece == nullptr) return base::usage(words + " is no fixture");
    job.fixtures.push_back({words, *piece});
  }
  return {};
}

Outcome<job::StockJob> stock_job(const Exercise& exercise, job::Job run) {
  const PartWork& part = *exercise.part;
  auto shape = machine::stock_word(part.stock, "the stock");
  if (!shape) return tl::unexpected(shape.error());
  auto library = machine::read_tools(part.tools, exercise.name, machine::ToolsUnit::mm);
  if (!library) return tl::unexpected(library.error());
  job::StockJob job{.job = std::move(run), .shape = std::move(*shape)};
  if (auto taken = take_fixtures(part, job); !taken) return tl::unexpected(taken.error());
  job.zero = {.kind = machine::StockZero::Kind::system};
  job.cell_mm = part.cell_mm;
  job.tools = machine::ToolChoice(std::move(library->tools));
  job.jobs = 1;
  job.rows = [](const job::Run&) { return std::make_unique<LineBook>(); };
  return job;
}

}  // namespace

Outcome<PartTrial> part_trial(const Exercise& exercise,
                              const machine::MachineDefinition& definition,
                              const std::string& program, std::uint64_t most_motions,
                              const std::stop_token& unwanted) {
  auto job = stock_job(exercise, job_of(exercise, definition, program, unwanted));
  if (!job) return tl::unexpected(job.error());
  job->job.budget.seconds = kMostSeconds;
  if (most_motions > 0) job->job.budget.motions = most_motions;
  auto cut = job::cut_stock(*job);
  if (!cut) return tl::unexpected(cut.error());
  PartTrial trial{std::move(*cut), {}, {}};
  trial.facts = job::facts_of(trial.cut);
  if (auto* const book = dynamic_cast<LineBook*>(trial.cut.rows.get()))
    trial.lines = std::move(book->lines);
  return trial;
}

}  // namespace kerf::training
