#include "base/source_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace kerf::base {
namespace {

tl::unexpected<Failure> input_failure(const std::string& path, const std::string& what) {
  return tl::unexpected(Failure{Failure::Kind::input, path + ": " + what});
}

bool write_all(int descriptor, std::span<const char> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

int open_unnamed_file() {
  const char* const folder = std::getenv("TMPDIR");
  std::string pattern = std::string(folder != nullptr ? folder : "/tmp") + "/kerf-input-XXXXXX";
  const int descriptor = ::mkstemp(pattern.data());
  if (descriptor >= 0) ::unlink(pattern.c_str());
  return descriptor;
}

// Reads `from` to its end into an unnamed file. Returns its descriptor and size, or what went
// wrong.
tl::expected<std::pair<int, std::uint64_t>, std::string> spool(int from) {
  const int to = open_unnamed_file();
  if (to < 0) return tl::unexpected(std::string("no temporary file: ") + std::strerror(errno));
  std::array<char, 1 << 16> buffer;
  std::uint64_t size = 0;
  for (;;) {
    const ssize_t count = ::read(from, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count == 0) return std::pair(to, size);
    if (count < 0 || !write_all(to, {buffer.data(), static_cast<std::size_t>(count)})) {
      std::string message = std::strerror(errno);
      ::close(to);
      return tl::unexpected(std::move(message));
    }
    size += static_cast<std::uint64_t>(count);
  }
}

}  // namespace

SourceFile::SourceFile(std::string name, int descriptor, std::uint64_t size)
    : name_(std::move(name)), descriptor_(descriptor), size_(size) {}

SourceFile::SourceFile(std::string name, std::shared_ptr<const std::string> text)
    : name_(std::move(name)), text_(std::move(text)), size_(text_->size()) {}

SourceFile::~SourceFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Outcome<std::unique_ptr<SourceFile>> SourceFile::open(const std::string& path) {
  const bool standard_input = path == "-";
  const int descriptor =
      standard_input ? ::dup(STDIN_FILENO) : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return input_failure(path, std::strerror(errno));
  struct stat status {};
  if (::fstat(descriptor, &status) != 0 || S_ISDIR(status.st_mode)) {
    ::close(descriptor);
    return input_failure(path, S_ISDIR(status.st_mode) ? "is a folder" : "cannot be read");
  }
  if (S_ISREG(status.st_mode) && !standard_input) {
    const auto size = static_cast<std::uint64_t>(status.st_size);
    return std::unique_ptr<SourceFile>(new SourceFile(path, descriptor, size));
  }
  auto spooled = spool(descriptor);
  ::close(descriptor);
  if (!spooled) return input_failure(path, spooled.error());
  return std::unique_ptr<SourceFile>(new SourceFile(path, spooled->first, spooled->second));
}

std::unique_ptr<SourceFile> SourceFile::from_text(std::string name, std::string text) {
  return from_shared(std::move(name), std::make_shared<const std::string>(std::move(text)));
}

std::unique_ptr<SourceFile> SourceFile::from_shared(std::string name,
                                                    std::shared_ptr<const std::string> text) {
  return std::unique_ptr<SourceFile>(new SourceFile(std::move(name), std::move(text)));
}

std::size_t SourceFile::read(std::uint64_t offset, std::span<char> into) const {
  if (offset >= size_) return 0;
  if (descriptor_ < 0) {
    const std::size_t count = std::min<std::size_t>(into.size(), size_ - offset);
    std::memcpy(into.data(), text_->data() + offset, count);
    return count;
  }
  std::size_t done = 0;
  while (done < into.size()) {
    const ssize_t count = ::pread(descriptor_, into.data() + done, into.size() - done,
                                  static_cast<off_t>(offset + done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    done += static_cast<std::size_t>(count);
  }
  return done;
}

std::string SourceFile::line_at(std::uint64_t offset, std::size_t limit) const {
  std::string line(limit, '\0');
  line.resize(read(offset, line));
  return line.substr(0, line.find_first_of("\r\n"));
}

FileId SourceSet::add(std::unique_ptr<SourceFile> file) {
  files_.push_back(std::move(file));
  return FileId{static_cast<std::uint32_t>(files_.size() - 1)};
}

const SourceFile& SourceSet::operator[](FileId id) const {
  return *files_[static_cast<std::size_t>(id)];
}

bool SourceSet::contains(FileId id) const { return static_cast<std::size_t>(id) < files_.size(); }

}  // namespace kerf::base
