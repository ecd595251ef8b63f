#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "base/source_file.hpp"
#include "control/gcode/macro/program_calls.hpp"
#include "lang/gcode/code_library.hpp"

namespace kerf::machine {

/// Finds called programs: in the files that are loaded, then in the library folders (`O9401`,
/// `O9401.nc`, `9401.nc`, …, then any file there that holds that O number).
class ProgramShelf : public control::ProgramFinder {
 public:
  ProgramShelf(base::SourceSet& sources, gcode::CodeLibrary& library)
      : sources_(sources), library_(library) {}

  /// Folders are searched in the order in which they are added.
  void add_folder(const std::string& folder) { folders_.push_back(folder); }
  /// A file that is loaded already and must not be read again.
  void know(const std::string& path);

  std::optional<vm::CodeId> find_program(std::uint32_t number) override;
  std::optional<vm::CodeId> find_program(const std::string& name) override;
  std::optional<vm::CodeId> find_external(std::uint32_t number) override;

 private:
  using Search = std::function<std::optional<vm::CodeId>()>;
  std::optional<vm::CodeId> search_folders(std::uint32_t number, const Search& search);
  void load_by_name(const std::string& folder, std::uint32_t number);
  void load_all();
  void load_folder(const std::string& folder);
  void load(const std::string& path, std::uint32_t number_from_name);

  base::SourceSet& sources_;
  gcode::CodeLibrary& library_;
  std::vector<std::string> folders_;
  std::set<std::string> known_files_;
  std::set<std::uint32_t> missing_;          // numbers that are nowhere
  std::set<std::uint32_t> missing_outside_;  // … nowhere but perhaps in the main file
  bool all_loaded_ = false;
};

}  // namespace kerf::machine
