#include "server/machine_store.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "base/output_file.hpp"
#include "base/source_file.hpp"
#include "machine/state_file.hpp"
#include "server/argument.hpp"
#include "server/program_name.hpp"

namespace kerf::server {
namespace {

using base::Failure;
using base::Outcome;
namespace fs = std::filesystem;

constexpr const char* kMemory = "memory.json";
constexpr const char* kDefinition = "machine.toml";
constexpr const char* kProgram = "program.json";
constexpr std::uint64_t kMostFileBytes = 4U << 20U;
// The first line of a machine file says what it was made from.
constexpr std::string_view kKindLine = "# kind: ";

tl::unexpected<Failure> failure(Failure::Kind kind, const std::string& message) {
  return tl::unexpected(Failure{kind, message});
}

Outcome<void> write_file(const std::string& path, const std::string& text) {
  auto file = base::OutputFile::create(path);
  if (!file) return tl::unexpected(file.error());
  (*file)->write(text);
  return (*file)->commit(base::OutputFile::Durability::survives_power_loss);
}

Outcome<std::string> read_file(const std::string& path) {
  auto file = base::SourceFile::open(path);
  if (!file) return tl::unexpected(file.error());
  if ((*file)->size() > kMostFileBytes) return failure(Failure::Kind::input, path + ": too large");
  std::string text((*file)->size(), '\0');
  text.resize((*file)->read(0, text));
  return text;
}

Json program_json(const LoadedProgram& program) {
  Json json = {{"name", program.name}, {"dialect", program.dialect}};
  if (program.text) json["text"] = *program.text;
  return json;
}

std::optional<LoadedProgram> program_of(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("name") || !json["name"].is_string()) return std::nullopt;
  LoadedProgram program{json["name"].get<std::string>()};
  if (json.contains("text") && json["text"].is_string())
    program.text = json["text"].get<std::string>();
  if (json.contains("dialect") && json["dialect"].is_string())
    program.dialect = json["dialect"].get<std::string>();
  return program;
}

}  // namespace

Outcome<MachineStore> MachineStore::open(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return failure(Failure::Kind::output, folder + ": " + error.message());
  return MachineStore(folder);
}

Outcome<StoredMachine> MachineStore::read(const std::string& name) const {
  StoredMachine machine;
  machine.name = name;
  auto text = read_file(file(name, kDefinition));
  if (!text) return tl::unexpected(text.error());
  if (text->starts_with(kKindLine)) {
    const std::size_t end = text->find('\n');
    machine.kind = text->substr(kKindLine.size(), end - kKindLine.size());
    text->erase(0, end == std::string::npos ? text->size() : end + 1);
  }
  machine.toml = std::move(*text);
  auto definition = machine::MachineDefinition::parse(machine.toml, file(name, kDefinition));
  if (!definition) return tl::unexpected(definition.error());
  machine.definition = std::move(*definition);
  machine.memory = control::Memory(machine.definition.parameters.n_offsets);
  if (auto read = machine::read_state(file(name, kMemory), machine.memory); !read)
    return tl::unexpected(read.error());
  if (const auto program = read_file(file(name, kProgram))) machine.program = program_of(*program);
  return machine;
}

std::vector<StoredMachine> MachineStore::read_all(std::vector<std::string>& troubles) const {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_, error)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory(error) && check_machine_name(name)) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  std::vector<StoredMachine> machines;
  for (const std::string& name : names) {
    auto machine = read(name);
    if (machine)
      machines.push_back(std::move(*machine));
    else
      troubles.push_back("the machine " + name + " is left out: " + machine.error().message);
  }
  return machines;
}

Outcome<void> MachineStore::add(const StoredMachine& machine) const {
  std::error_code error;
  fs::create_directories(folder_ + "/" + machine.name, error);
  if (error) return failure(Failure::Kind::output, machine.name + ": " + error.message());
  if (auto done = write_memory(machine.name, machine.memory); !done) return done;
  if (machine.program) {
    if (auto done = write_program(machine.name, *machine.program); !done) return done;
  }
  // Last: without it there is no machine.
  return write_definition(machine.name, machine.kind, machine.toml);
}

Outcome<void> MachineStore::remove(const std::string& name) const {
  std::error_code error;
  fs::remove(file(name, kDefinition), error);
  fs::remove_all(folder_ + "/" + name, error);
  if (error) return failure(Failure::Kind::output, name + ": " + error.message());
  return {};
}

Outcome<void> MachineStore::write_memory(const std::string& name,
                                         const control::Memory& memory) const {
  return machine::write_state(file(name, kMemory), memory);
}

Outcome<void> MachineStore::write_definition(const std::string& name, const std::string& kind,
                                             const std::string& toml) const {
  return write_file(file(name, kDefinition), std::string(kKindLine) + kind + "\n" + toml);
}

Outcome<void> MachineStore::write_program(const std::string& name,
                                          const LoadedProgram& program) const {
  return write_file(file(name, kProgram),
                    program_json(program).dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace kerf::server
