#include "face/cli/ready_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "face/cli/failure.hpp"
#include "face/cli/setting.hpp"
#include "job/facts_of_run.hpp"
#include "machine/definition/offset_file.hpp"
#include "machine/definition/state_file.hpp"
#include "machine/definition/tools/tool_import.hpp"
#include "machine/dialect/program_look.hpp"
#include "machine/run/batch_run.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::cli {
namespace {

using base::Failure;
using base::Outcome;

constexpr std::size_t kLargestOffsetFile = 16 << 20;
constexpr double kMostOffsetSeconds = 10;
constexpr base::FileId kMainFile{0};

// The control's own punch-out is a program of G10 blocks: a machine of its own runs it, and its
// offsets are all that is taken over.
Outcome<void> run_punch_out(const std::string& text, const std::string& path,
                            const machine::MachineDefinition& definition, control::Memory& memory) {
  machine::BatchRun reader(definition, memory);
  reader.load(base::SourceFile::from_text(path, text + "\nM30\n"));
  const auto status = reader.run_to_end({.seconds = kMostOffsetSeconds});
  const bool closed =
      status == machine::RunStatus::alarm && reader.alarm()->code == base::Code::end_of_record;
  if (status != machine::RunStatus::end && !closed) {
    const std::string message = reader.alarm()
                                    ? output::diagnostic_text(*reader.alarm(), reader.sources())
                                    : path + ": does not end\n";
    return tl::unexpected(Failure{Failure::Kind::input, message.substr(0, message.find('\n'))});
  }
  const control::Memory& read = reader.memory();
  memory.external = read.external;
  memory.work = read.work;
  memory.extended = read.extended;
  memory.tools = read.tools;
  memory.turning = read.turning;
  return {};
}

// Tools of another program: what they say of the offsets. One that the table lacks has none.
Outcome<void> take_library(const std::string& text, const std::string& path, bool in_inches,
                           const machine::MachineDefinition& definition, control::Memory& memory) {
  const auto unit = in_inches ? machine::ToolsUnit::inch : machine::ToolsUnit::mm;
  const auto library = machine::read_tools(text, path, unit);
  if (!library) return tl::unexpected(library.error());
  for (const stock::Tool& tool : library->tools)
    static_cast<void>(machine::set_offsets(tool, definition.parameters, memory));
  return {};
}

bool is_library(const std::string& text) {
  const machine::ToolFormat format = machine::tool_format_of(text);
  return format != machine::ToolFormat::toml && format != machine::ToolFormat::other;
}

Outcome<void> read_offset_file(const std::string& path, bool in_inches,
                               const machine::MachineDefinition& definition,
                               control::Memory& memory) {
  if (path.empty()) return {};
  auto text = base::read_whole(path, kLargestOffsetFile, "a file of offsets");
  if (!text) return tl::unexpected(text.error());
  if (is_library(*text)) return take_library(*text, path, in_inches, definition, memory);
  if (machine::looks_like_toml(*text)) {
    return machine::read_offsets(*text, path, definition.axes, definition.parameters, memory);
  }
  return run_punch_out(*text, path, definition, memory);
}

Outcome<void> apply_settings(const RunOptions& options, machine::MachineDefinition& definition) {
  for (const std::string& text : options.parameters) {
    auto setting = split_setting(text, "--param");
    if (!setting) return tl::unexpected(setting.error());
    if (auto set = definition.set_parameter(setting->key, setting->value); !set) return set;
  }
  if (auto set = set_machine_keys(options.machine_keys, definition); !set) return set;
  if (options.decimal_point.empty()) return {};
  return definition.parameters.set("DPI", options.decimal_point == "calculator" ? "1" : "0");
}

// Of a program for a lathe that runs on a machine which is none, or lacks the axis C.
std::optional<base::Diagnostic> lathe_hint(const base::SourceFile& program,
                                           const DialectChoice& choice,
                                           const machine::MachineDefinition& definition) {
  if (choice.dialect != definition.dialect) return std::nullopt;  // who names it knows
  if (definition.axes.find('U') || definition.axes.find('W')) return std::nullopt;
  const machine::ProgramLook look = machine::look_of(program);
  if (!machine::is_lathes(look.kind) || machine::suits(definition, look.kind)) return std::nullopt;
  base::Diagnostic hint = base::make_error(
      base::Code::lathe_program, {.file = kMainFile, .line = look.line, .column = 1},
      fmt::format("{} looks like {}, and the program runs on {}", look.word,
                  look.kind == machine::ProgramKind::lathe ? "a lathe's" : "that of a lathe with C",
                  definition.name),
      fmt::format("a program for a lathe: --machine {}", machine::usual_machine(look.kind)));
  hint.severity = base::Severity::warning;
  return hint;
}

Outcome<std::uint32_t> parse_block_skip(const std::string& list) {
  std::uint32_t levels = 0;
  if (list == "all") return 0x3feU;
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t comma = std::min(list.find(',', at), list.size());
    const std::string item = list.substr(at, comma - at);
    if (item.size() != 1 || item[0] < '1' || item[0] > '9')
      return usage("--block-skip " + list + ": a list of 1 to 9, or all");
    levels |= 1U << (item[0] - '0');
    at = comma + 1;
  }
  return levels;
}

Outcome<std::vector<job::InitialVariable>> variables_of(const RunOptions& options) {
  std::vector<job::InitialVariable> variables;
  for (const std::string& text : options.variables) {
    auto setting = split_setting(text, "--set");
    if (!setting) return tl::unexpected(setting.error());
    const auto value = base::read_number(setting->value);
    if (!value) return usage("--set " + text + ": a number is expected behind '='");
    variables.push_back({setting->key, *value, "--set " + text});
  }
  return variables;
}

Outcome<std::vector<machine::SkipContact>> contacts_of(const RunOptions& options,
                                                       const motion::AxisSetup& axes) {
  std::vector<machine::SkipContact> contacts;
  for (const std::string& text : options.skip_at) {
    auto setting = split_setting(text, "--skip-at");
    if (!setting) return tl::unexpected(setting.error());
    const auto value = base::read_number(setting->value);
    const auto axis = setting->key.size() == 1 ? axes.find(setting->key[0]) : std::nullopt;
    if (!axis || !value)
      return usage("--skip-at " + text + ": AXIS=VALUE with an axis of the machine is expected");
    contacts.push_back({*axis, *value / axes[*axis].count_per_mm()});
  }
  return contacts;
}

Outcome<control::Memory> memory_of(const RunOptions& options,
                                   const machine::MachineDefinition& definition) {
  control::Memory memory(definition.parameters.n_offsets);
  // The machine's tools are where its table of offsets begins; one beyond it has no offset.
  for (const stock::Tool& tool : definition.tools)
    static_cast<void>(machine::set_offsets(tool, definition.parameters, memory));
  if (!options.state.empty()) {
    if (auto read = machine::read_state(options.state, memory); !read)
      return tl::unexpected(read.error());
  }
  for (const std::string& path : {options.tools, options.offsets}) {
    if (auto read = read_offset_file(path, options.tools_unit == "inch", definition, memory); !read)
      return tl::unexpected(read.error());
  }
  return memory;
}

Outcome<OrderedJob> on_machine(const RunOptions& options, const DialectChoice& choice,
                               machine::MachineDefinition definition) {
  if (auto applied = apply_settings(options, definition); !applied)
    return tl::unexpected(applied.error());
  auto memory = memory_of(options, definition);
  if (!memory) return tl::unexpected(memory.error());
  auto levels = parse_block_skip(options.block_skip);
  if (!levels) return tl::unexpected(levels.error());
  auto variables = variables_of(options);
  if (!variables) return tl::unexpected(variables.error());
  auto contacts = contacts_of(options, definition.axes);
  if (!contacts) return tl::unexpected(contacts.error());
  if (options.program == "-" && !options.interrupt_at.empty())
    return usage("--interrupt-at runs the program more than once: it cannot be standard input");
  return OrderedJob{.job = {.definition = std::move(definition),
                            .memory = std::move(*memory),
                            .settings = {.dialect = choice.dialect,
                                         .library_folders = options.libraries,
                                         .block_skip = *levels,
                                         .optional_stop = options.optional_stop},
                            .program = base::ProgramText::at_path(options.program),
                            .variables = std::move(*variables),
                            .contacts = std::move(*contacts),
                            .interrupt_at_s = options.interrupt_at,
                            .budget = {options.max_seconds, options.max_motions}},
                    .choice = choice};
}

}  // namespace

Outcome<OrderedJob> job_of(const RunOptions& options, const base::SourceFile& program) {
  auto choice = choose_dialect(options.machine, options.dialect, program);
  if (!choice) return tl::unexpected(choice.error());
  auto definition = machine::find_machine(choice->machine);
  if (!definition) return tl::unexpected(definition.error());
  auto hint = lathe_hint(program, *choice, *definition);
  auto ordered = on_machine(options, *choice, std::move(*definition));
  if (ordered) ordered->hint = std::move(hint);
  return ordered;
}

namespace {

Outcome<ReadyRun> make_ready(const RunOptions& options, bool behind_alarms) {
  auto program = base::SourceFile::open(options.program, {.seconds = options.max_seconds});
  if (!program) return tl::unexpected(program.error());
  auto ordered = job_of(options, **program);
  if (!ordered) return tl::unexpected(ordered.error());
  ordered->job.behind_alarms = behind_alarms;
  auto run = job::Run::of(ordered->job, std::move(*program));
  if (!run) return tl::unexpected(run.error());
  return ReadyRun{std::move(*run), std::move(ordered->choice), std::move(ordered->hint)};
}

}  // namespace

Outcome<ReadyRun> make_ready(const RunOptions& options) { return make_ready(options, false); }

RunOptions options_of(const std::string& path, const CheckOptions& options) {
  RunOptions of_file;
  of_file.program = path;
  of_file.machine = options.machine;
  of_file.dialect = options.dialect;
  of_file.parameters = options.parameters;
  of_file.libraries = options.libraries;
  of_file.max_seconds = options.max_seconds;
  of_file.max_motions = options.max_motions;
  of_file.tools = options.tools;
  of_file.tools_unit = options.tools_unit;
  of_file.table = options.table;
  return of_file;
}

Outcome<ReadyRun> make_ready(const std::string& path, const CheckOptions& options) {
  return make_ready(options_of(path, options), true);
}

std::optional<base::Diagnostic> ReadyRun::alarm() const {
  std::optional<base::Diagnostic> told = machine().alarm();
  if (!told || !hint) return told;
  told->hint += (told->hint.empty() ? "" : "; ") + hint->hint;
  return told;
}

output::RunFacts facts_of(const ReadyRun& ready) {
  output::RunFacts facts = job::facts_of(ready.machine());
  facts.chosen = ready.choice.chosen;
  facts.assumed.insert(facts.assumed.begin(), ready.choice.assumed.begin(),
                       ready.choice.assumed.end());
  return facts;
}

ExitStatus exit_status_of(machine::RunStatus status) {
  using Status = machine::RunStatus;
  switch (status) {
    case Status::alarm: return ExitStatus::findings;
    case Status::budget: return ExitStatus::budget;
    default: return ExitStatus::well;
  }
}

}  // namespace kerf::cli
