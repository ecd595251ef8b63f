#include "face/cli/same_file.hpp"

#include <filesystem>

namespace kerf::cli {
namespace {

namespace fs = std::filesystem;

// One that is to be made is one as well.
bool is_ordinary(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return path != "-" && !path.empty() && (fs::is_regular_file(status) || !fs::exists(status));
}

}  // namespace

bool is_same_file(const std::string& a, const std::string& b) {
  if (!is_ordinary(a) || !is_ordinary(b)) return false;
  std::error_code error;
  if (fs::equivalent(a, b, error) && !error) return true;
  const fs::path first = fs::weakly_canonical(fs::absolute(a), error);
  return !error && first == fs::weakly_canonical(fs::absolute(b), error) && !error;
}

}  // namespace kerf::cli
