#include "face/cli/machine_setup.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/decimal.hpp"
#include "face/cli/dialect_choice.hpp"
#include "face/cli/failure.hpp"
#include "machine/definition/offset_file.hpp"
#include "machine/definition/state_file.hpp"
#include "machine/dialect/program_look.hpp"
#include "machine/run/interrupt_plan.hpp"
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
  machine::VirtualMachine reader(definition, memory);
  reader.load(base::SourceFile::from_text(path, text + "\nM30\n"));
  const auto status = reader.run_to_end({.seconds = kMostOffsetSeconds});
  const bool closed = status == machine::VirtualMachine::Status::alarm &&
                      reader.alarm()->code == base::Code::end_of_record;
  if (status != machine::VirtualMachine::Status::end && !closed) {
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
  return {};
}

Outcome<void> read_offset_file(const std::string& path,
                               const machine::MachineDefinition& definition,
                               control::Memory& memory) {
  if (path.empty()) return {};
  auto text = base::read_whole(path, kLargestOffsetFile, "a file of offsets");
  if (!text) return tl::unexpected(text.error());
  if (machine::looks_like_toml(*text)) {
    return machine::read_offsets(*text, path, definition.axes, definition.parameters, memory);
  }
  return run_punch_out(*text, path, definition, memory);
}

Outcome<void> apply_settings(const MachineSetup& setup, machine::MachineDefinition& definition) {
  for (const std::string& text : setup.parameters) {
    auto setting = split_setting(text, "--param");
    if (!setting) return tl::unexpected(setting.error());
    if (auto set = definition.parameters.set(setting->key, setting->value); !set) return set;
  }
  for (const std::string& text : setup.machine_keys) {
    auto setting = split_setting(text, "--machine-set");
    if (!setting) return tl::unexpected(setting.error());
    if (auto set = definition.set(setting->key, setting->value); !set) return set;
  }
  if (setup.decimal_point.empty()) return {};
  return definition.parameters.set("DPI", setup.decimal_point == "calculator" ? "1" : "0");
}

// Of a program for a lathe that runs on `machine`.
std::optional<base::Diagnostic> lathe_hint(const base::SourceFile& program,
                                           const std::string& machine) {
  const machine::ProgramLook look = machine::look_of(program);
  if (look.kind != machine::ProgramKind::lathe) return std::nullopt;
  base::Diagnostic hint = base::make_error(
      base::Code::lathe_program, {.file = kMainFile, .line = look.line, .column = 1},
      look.word + " looks like a lathe's, and the program runs on " + machine);
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

Outcome<void> set_variables(const RunOptions& options, machine::VirtualMachine& machine) {
  for (const std::string& text : options.variables) {
    auto setting = split_setting(text, "--set");
    if (!setting) return tl::unexpected(setting.error());
    const auto value = base::read_number(setting->value);
    if (!value) return usage("--set " + text + ": a number is expected behind '='");
    if (auto set = machine.set_variable(setting->key, *value); !set)
      return usage("--set " + text + ": " + set.error().message);
  }
  return {};
}

Outcome<void> set_contacts(const RunOptions& options, machine::VirtualMachine& machine) {
  for (const std::string& text : options.skip_at) {
    auto setting = split_setting(text, "--skip-at");
    if (!setting) return tl::unexpected(setting.error());
    const auto value = base::read_number(setting->value);
    const auto axis =
        setting->key.size() == 1 ? machine.definition().axes.find(setting->key[0]) : std::nullopt;
    if (!axis || !value)
      return usage("--skip-at " + text + ": AXIS=VALUE with an axis of the machine is expected");
    machine.add_skip_contact({*axis, *value});
  }
  return {};
}

Outcome<void> prepare(const RunOptions& options, std::unique_ptr<base::SourceFile> program,
                      machine::VirtualMachine& machine) {
  if (auto added = add_libraries(options.libraries, machine); !added) return added;
  machine.load(std::move(program));
  auto levels = parse_block_skip(options.block_skip);
  if (!levels) return tl::unexpected(levels.error());
  machine.set_block_skip(*levels);
  machine.set_optional_stop(options.optional_stop);
  if (auto set = set_variables(options, machine); !set) return set;
  return set_contacts(options, machine);
}

}  // namespace

Outcome<void> add_libraries(const std::vector<std::string>& folders,
                            machine::VirtualMachine& machine) {
  for (const std::string& folder : folders) {
    std::error_code error;
    const std::filesystem::directory_iterator readable(folder, error);
    if (error)
      return tl::unexpected(Failure{Failure::Kind::input, folder + ": " + error.message()});
    machine.add_library_folder(folder);
  }
  return {};
}

Outcome<KeyValue> split_setting(const std::string& text, const std::string& option) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    return usage(option + " " + text + ": KEY=VALUE is expected");
  return KeyValue{text.substr(0, equals), text.substr(equals + 1)};
}

ExitStatus exit_status_of(machine::VirtualMachine::Status status) {
  using Status = machine::VirtualMachine::Status;
  switch (status) {
    case Status::alarm: return ExitStatus::findings;
    case Status::budget: return ExitStatus::budget;
    default: return ExitStatus::well;
  }
}

namespace {

Outcome<ReadyMachine> make_uninterrupted(const RunOptions& options) {
  auto program = base::SourceFile::open(options.program, {.seconds = options.max_seconds});
  if (!program) return tl::unexpected(program.error());
  auto ready = set_up({options.machine, options.dialect, options.parameters, options.machine_keys,
                       options.decimal_point, options.tools, options.offsets, options.state},
                      **program);
  if (!ready) return ready;
  if (auto prepared = prepare(options, std::move(*program), *ready->machine); !prepared)
    return tl::unexpected(prepared.error());
  return ready;
}

// When the axes are where is only known of a run by time: such ones are made before.
Outcome<void> plan_interrupts(const RunOptions& options, ReadyMachine& ready) {
  if (options.program == "-")
    return usage("--interrupt-at runs the program more than once: it cannot be standard input");
  std::vector<double> times_s = options.interrupt_at;
  std::sort(times_s.begin(), times_s.end());
  const auto make = [&options]() -> Outcome<std::unique_ptr<machine::VirtualMachine>> {
    auto made = make_uninterrupted(options);
    if (!made) return tl::unexpected(made.error());
    return std::move(made->machine);
  };
  const auto plan = machine::plan_interrupts(make, times_s, options.max_seconds);
  if (!plan) return tl::unexpected(plan.error());
  machine::VirtualMachine& machine = *ready.machine;
  ready.interrupts = std::make_unique<machine::Stepper>(machine.language());
  for (const std::uint64_t block : plan->blocks)
    ready.interrupts->before_block(block, [&machine] { machine.interrupt(); });
  for (std::size_t i = 0; i < plan->late; ++i) machine.control().miss_interrupt();
  return {};
}

}  // namespace

Outcome<ReadyMachine> make_ready(const RunOptions& options) {
  auto ready = make_uninterrupted(options);
  if (!ready || options.interrupt_at.empty()) return ready;
  if (auto planned = plan_interrupts(options, *ready); !planned)
    return tl::unexpected(planned.error());
  return ready;
}

Outcome<ReadyMachine> set_up(const MachineSetup& setup, const base::SourceFile& program) {
  auto choice = choose_dialect(setup.machine, setup.dialect, program);
  if (!choice) return tl::unexpected(choice.error());
  auto definition = machine::find_machine(choice->machine);
  if (!definition) return tl::unexpected(definition.error());
  if (auto applied = apply_settings(setup, *definition); !applied)
    return tl::unexpected(applied.error());
  control::Memory memory(definition->parameters.n_offsets);
  if (!setup.state.empty()) {
    if (auto read = machine::read_state(setup.state, memory); !read)
      return tl::unexpected(read.error());
  }
  for (const std::string& path : {setup.tools, setup.offsets}) {
    if (auto read = read_offset_file(path, *definition, memory); !read)
      return tl::unexpected(read.error());
  }
  ReadyMachine ready;
  ready.why = choice->why;
  if (setup.machine.empty() && setup.dialect.empty())
    ready.hint = lathe_hint(program, choice->machine);
  ready.machine = std::make_unique<machine::VirtualMachine>(
      *definition, std::move(memory), machine::VirtualMachine::Settings{{}, choice->dialect});
  return ready;
}

}  // namespace kerf::cli
