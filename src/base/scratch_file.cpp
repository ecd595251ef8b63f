#include "base/scratch_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>

namespace kerf::base {
namespace {

constexpr std::size_t kInMemory = 1 << 18;

// Of the output; of standard output and devices the usual one.
std::filesystem::path folder_for(const OutputFile& output) {
  std::error_code error;
  const std::filesystem::path path(output.path());
  const bool regular = output.path() != "-" && (std::filesystem::is_regular_file(path, error) ||
                                                !std::filesystem::exists(path, error));
  if (!regular) return std::filesystem::temp_directory_path(error);
  return path.has_parent_path() ? path.parent_path() : ".";
}

}  // namespace

ScratchFile::~ScratchFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void ScratchFile::write(std::string_view bytes) {
  if (!output_.good()) return;
  waiting_.append(bytes);
  if (waiting_.size() >= kInMemory) spill();
}

void ScratchFile::open() {
  std::string name = (folder_for(output_) / ".kerf.XXXXXX").string();
  descriptor_ = ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0) return output_.fail(errno);
  ::unlink(name.c_str());
}

void ScratchFile::spill() {
  if (descriptor_ < 0) open();
  std::string_view rest = waiting_;
  while (!rest.empty() && output_.good()) {
    const ssize_t count = ::write(descriptor_, rest.data(), rest.size());
    if (count > 0) rest.remove_prefix(static_cast<std::size_t>(count));
    if (count < 0 && errno != EINTR) output_.fail(errno);
  }
  on_disk_ += waiting_.size();
  waiting_.clear();
}

void ScratchFile::copy_to_output(std::uint64_t begin, std::uint64_t end) {
  std::string block;
  while (begin < std::min(end, on_disk_) && output_.good()) {
    block.resize(std::min<std::uint64_t>(kInMemory, std::min(end, on_disk_) - begin));
    const ssize_t count =
        ::pread(descriptor_, block.data(), block.size(), static_cast<off_t>(begin));
    if (count == 0) return output_.fail(EIO);
    if (count < 0 && errno != EINTR) output_.fail(errno);
    if (count < 0) continue;
    output_.write(std::string_view(block).substr(0, static_cast<std::size_t>(count)));
    begin += static_cast<std::uint64_t>(count);
  }
  if (begin < end && output_.good())
    output_.write(std::string_view(waiting_).substr(begin - on_disk_, end - begin));
}

}  // namespace kerf::base
