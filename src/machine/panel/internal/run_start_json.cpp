#include "machine/panel/internal/run_start_json.hpp"

#include <filesystem>

#include "machine/dialect/dialect.hpp"
#include "machine/panel/operation_table.hpp"

namespace kerf::machine {
namespace {

constexpr std::size_t kMostPrintedBytes = 1U << 20U;
constexpr std::uint32_t kDateVariable = 3011;
constexpr std::uint32_t kTimeVariable = 3012;

// The calendar is said by its values at power-on.
Json signals_json(const Signals& signals) {
  return {
      {"inputs", signals.inputs()}, {"date", signals.date(0)}, {"time", signals.time_of_day(0)}};
}

Signals signals_of(const Json& json) {
  std::array<std::uint32_t, 4> words{};
  const Json& inputs = list_in(json, "inputs", words.size());
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!inputs[i].is_number_unsigned() || inputs[i].get<std::uint64_t>() > 0xffffffffU)
      throw NoJournal{"inputs is no list of words"};
    words[i] = inputs[i].get<std::uint32_t>();
  }
  Signals signals;
  signals.set_inputs(words);
  const auto date = signals.set(kDateVariable, number_in(json, "date"));
  const auto time = signals.set(kTimeVariable, number_in(json, "time"));
  if (!*date || !*time) throw NoJournal{"signals has no date or time"};
  return signals;
}

std::vector<Argument> panel_arguments() {
  using namespace argument;
  Argument switches = texts("switches", {});
  switches.need = Need::required;
  return {choice("mode", mode_names()),
          switches,
          integers("skip", SetBlockSkip::kLevels),
          integer("feed", SetDials::kFeed),
          integer("rapid", SetDials::kRapid),
          integer("spindle", SetDials::kSpindle)};
}

Json panel_json(const PanelSettings& panel) {
  Json switches = Json::array();
  for (const std::string_view name : switch_names()) {
    if (panel[*switch_named(name)]) switches.push_back(std::string(name));
  }
  return {{"mode", std::string(name_of(panel.mode))},
          {"switches", std::move(switches)},
          {"skip", levels_of(panel.skip_levels)},
          {"feed", panel.dials.feed},
          {"rapid", panel.dials.rapid},
          {"spindle", panel.dials.spindle}};
}

void check(const Json& object, const std::vector<Argument>& arguments, const char* where) {
  if (!object.is_object()) throw NoJournal{std::string(where) + " is no object"};
  if (auto checked = check_arguments(object, arguments); !checked)
    throw NoJournal{std::string(where) + ": " + checked.error().message};
}

PanelSettings panel_of(const Json& json) {
  check(json, panel_arguments(), "panel");
  const Arguments a(json);
  PanelSettings panel;
  panel.mode = *mode_named(a.text("mode"));
  for (const std::string& name : a.texts("switches")) {
    const auto which = switch_named(name);
    if (!which) throw NoJournal{"panel: there is no switch " + name};
    panel.switches[static_cast<std::size_t>(*which)] = true;
  }
  panel.skip_levels = bits_of(a.integers("skip"));
  panel.dials = {static_cast<int>(a.integer("feed")), static_cast<int>(a.integer("rapid")),
                 static_cast<int>(a.integer("spindle"))};
  return panel;
}

Json breakpoints_json(const std::vector<Breakpoint>& breakpoints) {
  Json list = Json::array();
  for (const Breakpoint& each : breakpoints) list.push_back(entry_of(each));
  return list;
}

std::vector<Breakpoint> breakpoints_of(const Json& object) {
  std::vector<Breakpoint> all;
  for (const Json& entry : list_in(object, "breakpoints", kMostEntries)) {
    check(entry, breakpoint_list().fields, "breakpoints");
    all.push_back(breakpoint_of(Arguments(entry)));
  }
  return all;
}

std::vector<Argument> settings_arguments() {
  using namespace argument;
  constexpr Range kSpeeds{0, Jog::kSpeeds_per_min.most};
  return {name_of("dialect"), number("jog_mm_min", kSpeeds), number("jog_deg_min", kSpeeds),
          integer("printed_bytes", {0, kMostPrintedBytes})};
}

Json settings_json(const LiveMachine::Settings& settings) {
  return {{"dialect", settings.dialect},
          {"jog_mm_min", settings.jog_mm_min},
          {"jog_deg_min", settings.jog_deg_min},
          {"printed_bytes", settings.printed_bytes}};
}

LiveMachine::Settings settings_of(const Json& json) {
  check(json, settings_arguments(), "settings");
  const Arguments a(json);
  LiveMachine::Settings settings;
  settings.dialect = a.text("dialect");
  settings.jog_mm_min = a.number("jog_mm_min");
  settings.jog_deg_min = a.number("jog_deg_min");
  settings.printed_bytes = static_cast<std::size_t>(a.integer("printed_bytes"));
  return settings;
}

MachineDefinition definition_of(const std::string& file, const Json& json) {
  auto definition = MachineDefinition::parse(file, "machine");
  if (!definition) throw NoJournal{definition.error().message};
  definition->start = base::JointPoint(axes_in(json, "joints"));
  definition->axes.start = base::TipPoint(axes_in(json, "tip"));
  return std::move(*definition);
}

std::string dialect_in(const Json& json, const MachineDefinition& definition) {
  const std::string dialect = text_in(json, "dialect");
  if (auto known = check_dialect(definition, dialect); !known)
    throw NoJournal{known.error().message};
  return dialect;
}

}  // namespace

Json program_json(const base::ProgramText& program) {
  constexpr std::size_t kMost = LiveMachine::kMostJournalProgramBytes;
  const auto file = program.open();
  if (!file) throw NoJournal{file.error().message};
  if ((*file)->size() > kMost)
    throw NoJournal{"its program has more than " + std::to_string(kMost >> 20U) + " MiB"};
  std::string text((*file)->size(), '\0');
  text.resize((*file)->read(0, text));
  return {{"name", text_json(std::filesystem::path(program.name).filename().string())},
          {"text", text_json(text)}};
}

base::ProgramText program_in(const Json& object, const char* key) {
  const Json& json = field(object, key);
  return base::ProgramText::of(text_in(json, "name"), text_in(json, "text"));
}

Json run_start_json(const RunStart& start) {
  if (start.settings.machine_file.empty()) throw NoJournal{"its machine has no file"};
  return {{"machine", text_json(start.settings.machine_file)},
          {"joints", axes_json(start.definition.start)},
          {"tip", axes_json(start.definition.axes.start)},
          {"memory", memory_json(start.memory)},
          {"settings", settings_json(start.settings)},
          {"dialect", start.dialect},
          {"panel", panel_json(start.panel)},
          {"program", start.program ? program_json(*start.program) : Json(nullptr)},
          {"breakpoints", breakpoints_json(start.breakpoints)},
          {"shift", axes_json(start.shift)},
          {"signals", signals_json(start.signals)},
          {"printed", text_json(start.printed)},
          {"printed_bytes", start.printed_bytes}};
}

RunStart run_start_of(const Json& json, std::vector<std::string> library_folders) {
  const std::string file = text_in(json, "machine");
  MachineDefinition definition = definition_of(file, json);
  control::Memory memory =
      memory_in(json, "memory", control::Memory(definition.parameters.n_offsets));
  RunStart start{
      std::move(definition), std::move(memory), settings_of(field(json, "settings")), {}};
  start.settings.library_folders = std::move(library_folders);
  start.settings.machine_file = file;
  start.dialect = dialect_in(json, start.definition);
  start.panel = panel_of(field(json, "panel"));
  if (!field(json, "program").is_null()) start.program = program_in(json, "program");
  start.breakpoints = breakpoints_of(json);
  start.shift = axes_in(json, "shift");
  start.signals = signals_of(field(json, "signals"));
  start.printed = text_in(json, "printed");
  start.printed_bytes = count_in(json, "printed_bytes");
  return start;
}

}  // namespace kerf::machine
