#include "machine/dialect/program_shelf.hpp"

#include <algorithm>
#include <filesystem>

#include "lang/gcode/language.hpp"

namespace kerf::machine {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestLibraryFile = 64U << 20;
constexpr std::size_t kMostLibraryFiles = 10000;

// In the order in which they are tried.
std::vector<std::string_view> endings_of_programs() {
  const auto known = gcode::language().endings;
  std::vector<std::string_view> endings = {""};
  endings.insert(endings.end(), known.begin(), known.end());
  return endings;
}

std::string canonical(const std::string& path) {
  std::error_code error;
  const fs::path result = fs::weakly_canonical(path, error);
  return error ? path : result.string();
}

}  // namespace

void ProgramShelf::know(const std::string& path) { known_files_.insert(canonical(path)); }

void ProgramShelf::load(const std::string& path, std::uint32_t number_from_name) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return;  // a pipe may never begin, nor end
  if (!known_files_.insert(canonical(path)).second) return;
  auto file = base::SourceFile::open(path);
  if (file) library_.add_library_file(sources_.add(std::move(*file)), number_from_name);
}

// The files of a folder that are called like the program.
void ProgramShelf::load_by_name(const std::string& folder, std::uint32_t number) {
  const std::string digits = std::to_string(number);
  const std::string padded = std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') + digits;
  for (const std::string& stem : {"O" + padded, "O" + digits, "o" + padded, padded, digits}) {
    for (const std::string_view ending : endings_of_programs()) {
      const fs::path path = fs::path(folder) / (stem + std::string(ending));
      std::error_code error;
      if (fs::is_regular_file(path, error)) load(path.string(), number);
    }
  }
}

// Every program file of a folder, in the order of their names.
void ProgramShelf::load_folder(const std::string& folder) {
  const std::vector<std::string_view> endings = endings_of_programs();
  std::vector<std::string> paths;
  std::error_code error;
  for (fs::directory_iterator at(folder.empty() ? "." : folder, error), end; !error && at != end;
       at.increment(error)) {
    const std::string ending = at->path().extension().string();
    std::error_code ignored;
    if (std::find(endings.begin(), endings.end(), ending) == endings.end()) continue;
    if (!at->is_regular_file(ignored) || at->file_size(ignored) > kLargestLibraryFile) continue;
    paths.push_back(at->path().string());
    if (paths.size() >= kMostLibraryFiles) break;
  }
  std::sort(paths.begin(), paths.end());
  for (const std::string& path : paths) load(path, 0);
}

void ProgramShelf::load_all() {
  if (all_loaded_) return;
  all_loaded_ = true;
  for (const std::string& folder : folders_) load_folder(folder);
}

// By the names of the files, then by what is in them.
std::optional<vm::CodeId> ProgramShelf::search_folders(std::uint32_t number, const Search& search) {
  for (const std::string& folder : folders_) {
    load_by_name(folder, number);
    if (const auto found = search()) return found;
  }
  load_all();
  return search();
}

std::optional<vm::CodeId> ProgramShelf::find_program(std::uint32_t number) {
  if (const auto found = library_.find(number)) return found;
  if (number == 0 || missing_.contains(number)) return std::nullopt;
  const auto found = search_folders(number, [&] { return library_.find(number); });
  if (!found) missing_.insert(number);
  return found;
}

std::optional<vm::CodeId> ProgramShelf::find_program(const std::string& name) {
  if (const auto found = library_.find(name)) return found;
  load_all();
  return library_.find(name);
}

// Programs of the main file are not in the external folder.
std::optional<vm::CodeId> ProgramShelf::find_external(std::uint32_t number) {
  const auto search = [&] { return library_.find_outside(base::FileId{0}, number); };
  if (const auto found = search()) return found;
  if (number == 0 || missing_outside_.contains(number)) return std::nullopt;
  const auto found = search_folders(number, search);
  if (!found) missing_outside_.insert(number);
  return found;
}

}  // namespace kerf::machine
