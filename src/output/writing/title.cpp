#include "output/writing/title.hpp"

#include <filesystem>

#include "base/program_name.hpp"

namespace kerf::output {

std::string file_title(const std::string& path) {
  return path == "-" ? "standard input" : std::filesystem::path(path).filename().string();
}

std::string program_title(const std::string& name, const std::string& file) {
  return name != base::kUnnumberedProgram ? name : file_title(file);
}

}  // namespace kerf::output
