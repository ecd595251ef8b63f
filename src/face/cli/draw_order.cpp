#include "face/cli/draw_order.hpp"

#include "base/decimal.hpp"
#include "face/cli/failure.hpp"
#include "face/cli/setting.hpp"

namespace kerf::cli {
namespace {

using base::Outcome;

constexpr const char* kUsualMachine = "laser3";

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
    if (word == name_of(each)) return each;
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

Outcome<process::Recipe> recipe_of(const DrawOptions& options) {
  return recipe_without_job(options);
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
  if (auto taken = take_length(options.tolerance, "--tolerance", recipe.tolerance); !taken)
    return taken;
  if (auto taken = take_length(options.join, "--join", recipe.join); !taken) return taken;
  return take_length(options.same, "--same", recipe.same);
}

}  // namespace

Outcome<Ordered> draw_order_of(const DrawOptions& options) {
  Ordered ordered;
  auto recipe = recipe_of(options);
  if (!recipe) return tl::unexpected(recipe.error());
  if (auto taken = take_tolerances(options, *recipe); !taken) return tl::unexpected(taken.error());
  std::string machine = options.run.machine.empty() ? recipe->machine : options.run.machine;
  if (machine.empty()) {
    machine = kUsualMachine;
    ordered.assumed.push_back("no --machine and none in the job: laser3");
  }
  auto definition = machine::find_machine(machine);
  if (!definition) return tl::unexpected(definition.error());
  if (auto set = set_machine_keys(options.run.machine_keys, *definition); !set)
    return tl::unexpected(set.error());
  job::DrawOrder& order = ordered.order;
  order.definition = std::move(*definition);
  order.drawings = options.drawings;
  order.recipe = std::move(*recipe);
  order.reading.unit = options.unit;
  order.reading.dpi = options.dpi;
  order.reading.layers = options.layers;
  order.reading.max_entities = options.max_entities;
  order.max_seconds = options.run.max_seconds;
  order.reading.limit = base::WorkLimit(options.run.max_seconds);
  if (auto taken = take_variables(options, order); !taken) return tl::unexpected(taken.error());
  return ordered;
}

}  // namespace kerf::cli
