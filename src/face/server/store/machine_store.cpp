#include "face/server/store/machine_store.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "base/output_file.hpp"
#include "base/source_file.hpp"
#include "face/server/protocol/json.hpp"
#include "face/server/store/private_files.hpp"
#include "face/server/store/program_name.hpp"
#include "machine/definition/state_file.hpp"

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
// What the names of folders begin with that are no machine, or none any more.
constexpr std::string_view kIncomplete = ".incomplete-";

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

// Machines that were not complete yet, or were being removed, have names that no machine has; an
// empty folder is none either.
void sweep(const std::string& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.is_symlink(error) || !entry.is_directory(error)) continue;
    if (entry.path().filename().string().starts_with(kIncomplete)) {
      fs::remove_all(entry.path(), error);
    } else if (fs::is_empty(entry.path(), error)) {
      fs::remove(entry.path(), error);
    } else {
      remove_unfinished(entry.path().string());
    }
  }
}

}  // namespace

Outcome<MachineStore> MachineStore::open(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return failure(Failure::Kind::output, folder + ": " + error.message());
  sweep(folder);
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

// A folder of another name becomes that of the machine when it is complete.
Outcome<void> MachineStore::add(const StoredMachine& machine) const {
  std::error_code error;
  const std::string whole = folder_ + "/" + machine.name;
  if (fs::exists(whole, error) && !fs::is_empty(whole, error))
    return failure(
        Failure::Kind::output,
        whole + ": there is a machine that could not be read; mend or remove its folder");
  const std::string name = std::string(kIncomplete) + machine.name;
  const std::string folder = folder_ + "/" + name;
  fs::remove_all(folder, error);
  if (!fs::create_directory(folder, error))
    return failure(Failure::Kind::output, whole + ": " + error.message());
  Outcome<void> done = write_all(name, machine);
  if (done) done = take_name(folder, whole);
  if (!done) fs::remove_all(folder, error);
  return done;
}

Outcome<void> MachineStore::write_all(const std::string& name, const StoredMachine& machine) const {
  if (auto done = write_memory(name, machine.memory); !done) return done;
  if (machine.program) {
    if (auto done = write_program(name, *machine.program); !done) return done;
  }
  return write_definition(name, machine.kind, machine.toml);
}

// What is left of the folder when the server is killed, or the disk fails, is swept at a start.
Outcome<void> MachineStore::remove(const std::string& name) const {
  std::error_code error;
  const std::string folder = folder_ + "/" + std::string(kIncomplete) + name;
  fs::remove_all(folder, error);
  if (auto done = take_name(folder_ + "/" + name, folder); !done) return done;
  fs::remove_all(folder, error);
  return {};
}

Outcome<void> MachineStore::take_name(const std::string& from, const std::string& to) const {
  std::error_code error;
  fs::rename(from, to, error);
  if (!error) return base::sync_folder(folder_);
  return failure(Failure::Kind::output, to + ": " + error.message());
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
