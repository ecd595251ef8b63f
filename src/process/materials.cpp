#include "process/materials.hpp"

#include <toml++/toml.h>

#include <algorithm>

#include "base/decimal.hpp"
#include "base/text_window.hpp"
#include "process/internal/nearest_name.hpp"
#include "process/internal/recipe_reader.hpp"

namespace kerf::process {
namespace {

constexpr std::size_t kMostFindings = 100;
constexpr double kAll_percent = 100;

template <typename T>
void fill_empty(std::optional<T>& said, const std::optional<T>& otherwise) {
  if (!said) said = otherwise;
}

const Material* find_in(std::span<const Material> materials, std::string_view name) {
  const auto found = std::find_if(materials.rbegin(), materials.rend(),
                                  [&](const Material& each) { return each.name == name; });
  return found == materials.rend() ? nullptr : &*found;
}

const Preset* find_preset(const Material& material, Process process) {
  const auto found = std::find_if(material.presets.begin(), material.presets.end(),
                                  [&](const Preset& each) { return each.process == process; });
  return found == material.presets.end() ? nullptr : &*found;
}

bool says_power(const Operation& operation) {
  return operation.power_percent || (operation.ton_ms && operation.toff_ms);
}

base::Diagnostic scaled(const Operation& operation, double power_w, const MachineFacts& machine,
                        const std::string& feed) {
  base::Diagnostic told =
      make_error(base::Code::preset_scaled, operation.place,
                 "operation " + operation.name + ": the material asks for " +
                     base::number_text(power_w) + " W, and " + machine.name + " has " +
                     base::number_text(machine.max_power_w) + "; " + feed);
  told.severity = base::Severity::warning;
  return told;
}

/// Power and feed belong together: less power than asked for wants as much more time.
void fill_power(Operation& operation, const Preset& preset, const MachineFacts& machine,
                Diagnostics& found) {
  const bool takes_power = !says_power(operation) && preset.power_w && machine.max_power_w > 0;
  const bool takes_feed = !operation.feed && !operation.ms_per_mm && preset.feed;
  const double percent =
      takes_power ? kAll_percent * *preset.power_w / machine.max_power_w : kAll_percent;
  const double share = std::min(1.0, kAll_percent / percent);
  if (takes_power) operation.power_percent = std::min(percent, kAll_percent);
  if (takes_feed) operation.feed = base::tidy(*preset.feed * share);
  if (share == 1) return;
  found.push_back(scaled(operation, *preset.power_w, machine,
                         takes_feed ? "its feed is " + base::number_text(*operation.feed) +
                                          " instead of " + base::number_text(*preset.feed)
                                    : "the feed stays as the job says it"));
}

void fill_rest(Operation& operation, const Preset& preset) {
  fill_empty(operation.kerf, preset.kerf);
  if (!operation.ton_ms) fill_empty(operation.frequency_hz, preset.frequency_hz);
  fill_empty(operation.z, preset.focus);
  fill_empty(operation.spacing, preset.spacing);
  fill_empty(operation.interval, preset.spacing);
  fill_empty(operation.track_width, preset.track_width);
  fill_empty(operation.depth, preset.depth);
  if (operation.gas.empty()) operation.gas = preset.gas;
  if (!operation.has_passes && preset.passes) operation.passes = *preset.passes;
  if (!operation.has_pierce && preset.pierce_s) operation.pierce_s = *preset.pierce_s;
}

Diagnostics first_findings(Diagnostics found) {
  if (found.size() > kMostFindings) found.resize(kMostFindings);
  return found;
}

std::vector<Material> read_builtin() {
  std::vector<Material> all;
  for (const BuiltinMaterials& file : builtin_material_files()) {
    auto read = read_materials(std::string(file.toml), std::string(file.name), base::kNoFile);
    if (read) std::move(read->begin(), read->end(), std::back_inserter(all));
  }
  return all;
}

bool is_engraving(Process process) {
  return process == Process::mark || process == Process::fill || process == Process::raster;
}

}  // namespace

const std::vector<Material>& builtin_materials() {
  static const std::vector<Material> all = read_builtin();
  return all;
}

tl::expected<std::vector<Material>, Diagnostics> read_materials(const std::string& text,
                                                                const std::string& source,
                                                                base::FileId file) {
  RecipeReader reader{text, file};
  std::vector<Material> materials;
  try {
    reader.read_materials(toml::parse(base::without_byte_order_mark(text), source), materials);
  } catch (const toml::parse_error& error) {
    reader.tell(make_error(base::Code::job_value, reader.place_of(error.source()),
                           std::string(error.description())));
  }
  Diagnostics found = reader.findings();
  if (!found.empty()) return tl::unexpected(first_findings(std::move(found)));
  return materials;
}

tl::expected<const Material*, base::Diagnostic> find_material(std::string_view name,
                                                              std::span<const Material> more,
                                                              const base::Place& place) {
  if (const Material* const found = find_in(more, name)) return found;
  if (const Material* const found = find_in(builtin_materials(), name)) return found;
  std::vector<std::string_view> names;
  for (const Material& each : builtin_materials()) names.push_back(each.name);
  for (const Material& each : more) names.push_back(each.name);
  return tl::unexpected(
      make_error(base::Code::material_unknown, place, shown(name), nearest_hint(name, names)));
}

const Preset* preset_of(const Material& material, Process process) {
  const Preset* const own = find_preset(material, process);
  return own == nullptr && is_engraving(process) ? find_preset(material, Process::engrave) : own;
}

Diagnostics fill_in(Operation& operation, const Material* material, const MachineFacts& machine) {
  Diagnostics found;
  const Preset* const preset =
      material == nullptr ? nullptr : preset_of(*material, operation.process);
  if (preset != nullptr) {
    fill_power(operation, *preset, machine, found);
    fill_rest(operation, *preset);
  }
  if (operation.gas.empty()) operation.gas = machine.gas;
  if (operation.process == Process::heat && !operation.track_width) {
    found.push_back(make_error(
        base::Code::job_value, operation.place,
        "operation " + operation.name + " needs track_width; neither it nor a material says it"));
  }
  return found;
}

Diagnostics fill_in(Recipe& recipe, std::span<const Material> more, const MachineFacts& machine) {
  const Material* material = nullptr;
  Diagnostics found;
  if (!recipe.material.empty()) {
    const auto named = find_material(recipe.material, more, recipe.material_place);
    if (named) material = *named;
    if (!named) found.push_back(named.error());
  }
  for (Operation& each : recipe.operations) {
    for (base::Diagnostic& told : fill_in(each, material, machine))
      found.push_back(std::move(told));
  }
  return found;
}

}  // namespace kerf::process
