#include "face/server/store/private_files.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace kerf::server {
namespace {

namespace fs = std::filesystem;

tl::unexpected<base::Failure> failure(const std::string& folder, const std::string& why) {
  return tl::unexpected(base::Failure{base::Failure::Kind::output, folder + ": " + why});
}

}  // namespace

base::Outcome<bool> make_private_folder(const std::string& folder) {
  constexpr mode_t kOthers = 0077;
  constexpr mode_t kPrivate = 0700;
  std::error_code error;
  const bool made = fs::create_directories(folder, error);
  if (error) return failure(folder, error.message());
  struct stat status {};
  if (::stat(folder.c_str(), &status) != 0) return failure(folder, std::strerror(errno));
  if ((status.st_mode & kOthers) == 0) return false;
  if (::chmod(folder.c_str(), kPrivate) != 0)
    return failure(folder, std::string("other accounts can open it, and it cannot be closed: ") +
                               std::strerror(errno));
  return !made;
}

bool is_unfinished(const std::string& file_name) {
  constexpr std::size_t kRandom = 6;
  if (file_name.size() < kRandom + 3 || file_name[0] != '.') return false;
  const std::size_t point = file_name.size() - kRandom - 1;
  return file_name[point] == '.' &&
         std::all_of(file_name.begin() + static_cast<std::ptrdiff_t>(point) + 1, file_name.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0; });
}

void remove_unfinished(const std::string& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (is_unfinished(entry.path().filename().string()) && !entry.is_symlink(error) &&
        entry.is_regular_file(error))
      fs::remove(entry.path(), error);
  }
}

}  // namespace kerf::server
