#include "face/cli/internal/draw_order.hpp"

#include <algorithm>

#include "base/decimal.hpp"
#include "face/cli/failure.hpp"
#include "face/cli/setting.hpp"
#include "process/materials.hpp"
#include "process/recipe_file.hpp"
#include "process/settled.hpp"

namespace kerf::cli {
namespace {

using base::Outcome;

using RecipeOutcome = tl::expected<process::Recipe, JobFault>;

constexpr const char* kUsualMachine = "laser3";
constexpr std::uint64_t kLargestJob = std::uint64_t{1} << 20U;

Outcome<void> take_length(const std::string& text, const char* option, double& length) {
  if (text.empty()) return {};
  const auto value = base::read_number(text);
  if (!value || !(*value > 0))
    return usage(std::string(option) + " " + text + ": a length above 0 mm is expected");
  length = *value;
  return {};
}

process::Process process_of(const std::string& word) {
  using process::Process;
  for (const Process each : {Process::engrave, Process::mark, Process::cut, Process::fill,
                             Process::raster, Process::weld, Process::heat, Process::drill}) {
    if (word == word_of(each)) return each;
  }
  return Process::engrave;
}

process::Recipe recipe_without_job(const DrawOptions& options) {
  process::Recipe recipe;
  process::Operation operation;
  operation.name = options.process;
  operation.layers = {"*"};
  operation.process = process_of(options.process);
  recipe.operations.push_back(std::move(operation));
  return recipe;
}

/// The text of a file of settings, which is among the sources then.
Outcome<std::string> text_of_file(const std::string& path, base::SourceSet& sources,
                                  base::FileId& id) {
  auto file = base::SourceFile::open(path, {.most_bytes = kLargestJob});
  if (!file) return tl::unexpected(file.error());
  std::string text(std::min((*file)->size(), kLargestJob), '\0');
  text.resize((*file)->read(0, text));
  id = sources.add(std::move(*file));
  return text;
}

/// The job, or what is wrong in it.
RecipeOutcome recipe_of(const DrawOptions& options, base::SourceSet& sources) {
  process::Recipe recipe = recipe_without_job(options);
  if (!options.job.empty()) {
    base::FileId id{};
    auto text = text_of_file(options.job, sources, id);
    if (!text) return tl::unexpected(JobFault{text.error(), {}});
    auto read = process::read_recipe(*text, options.job, id);
    if (!read) return tl::unexpected(JobFault{std::nullopt, read.error()});
    recipe = std::move(*read);
  }
  for (const std::string& text : options.job_keys) {
    auto setting = split_setting(text, "--job-set");
    if (!setting) return tl::unexpected(JobFault{setting.error(), {}});
    const process::Diagnostics wrong = process::set(recipe, setting->key, setting->value);
    if (!wrong.empty()) return tl::unexpected(JobFault{std::nullopt, wrong});
  }
  const process::Diagnostics wrong = process::contradictions(recipe);
  if (!wrong.empty()) return tl::unexpected(JobFault{std::nullopt, wrong});
  return recipe;
}

Outcome<void> take_variables(const DrawOptions& options, job::DrawOrder& order) {
  for (const std::string& text : options.variables) {
    auto setting = split_setting(text, "--set");
    if (!setting) return tl::unexpected(setting.error());
    order.variables[setting->key] = setting->value;
  }
  return {};
}

Outcome<void> take_tolerances(const DrawOptions& options, process::Recipe& recipe) {
  auto taken = take_length(options.tolerance, "--tolerance", recipe.tolerance);
  if (taken) taken = take_length(options.join, "--join", recipe.join);
  return taken ? take_length(options.same, "--same", recipe.same) : taken;
}

}  // namespace

namespace {

Outcome<void> take_machine(const DrawOptions& options, Ordered& ordered) {
  const std::string& by_job = ordered.order.recipe.machine;
  std::string machine = options.run.machine.empty() ? by_job : options.run.machine;
  if (machine.empty()) {
    machine = kUsualMachine;
    ordered.assumed.push_back("no --machine and none in the job: laser3");
  }
  auto definition = machine::find_machine(machine);
  if (!definition) return tl::unexpected(definition.error());
  ordered.order.definition = std::move(*definition);
  return set_machine_keys(options.run.machine_keys, ordered.order.definition);
}

tl::expected<void, JobFault> take_materials(const DrawOptions& options, base::SourceSet& sources,
                                            job::DrawOrder& order) {
  for (const std::string& path : options.material_files) {
    base::FileId id{};
    auto text = text_of_file(path, sources, id);
    if (!text) return tl::unexpected(JobFault{text.error(), {}});
    auto read = process::read_materials(*text, path, id);
    if (!read) return tl::unexpected(JobFault{std::nullopt, read.error()});
    order.materials.insert(order.materials.end(), read->begin(), read->end());
  }
  return {};
}

void take_reading(const DrawOptions& options, job::DrawOrder& order) {
  order.drawings = options.drawings;
  order.reading.unit = options.unit;
  order.reading.dpi = options.dpi;
  order.reading.layers = options.layers;
  order.reading.max_entities = options.max_entities;
  order.max_seconds = options.run.max_seconds;
  order.reading.limit = base::WorkLimit(options.run.max_seconds);
}

}  // namespace

tl::expected<Ordered, JobFault> draw_order_of(const DrawOptions& options,
                                              base::SourceSet& sources) {
  Ordered ordered;
  auto recipe = recipe_of(options, sources);
  if (!recipe) return tl::unexpected(recipe.error());
  if (auto taken = take_tolerances(options, *recipe); !taken)
    return tl::unexpected(JobFault{taken.error(), {}});
  ordered.order.recipe = std::move(*recipe);
  take_reading(options, ordered.order);
  if (auto taken = take_machine(options, ordered); !taken)
    return tl::unexpected(JobFault{taken.error(), {}});
  if (auto taken = take_materials(options, sources, ordered.order); !taken)
    return tl::unexpected(taken.error());
  if (auto taken = take_variables(options, ordered.order); !taken)
    return tl::unexpected(JobFault{taken.error(), {}});
  return ordered;
}

}  // namespace kerf::cli
