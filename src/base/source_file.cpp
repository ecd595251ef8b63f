#include "base/source_file.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "base/decimal.hpp"

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

using Clock = std::chrono::steady_clock;

// Copies what is read until it ends or is too much.
class Spool {
 public:
  Spool(int from, const SourceFile::Intake& intake) : from_(from), intake_(intake) {}

  /// The copy's descriptor, or what went wrong.
  tl::expected<int, std::string> copy() {
    const int to = open_unnamed_file();
    if (to < 0) return tl::unexpected(std::string("no temporary file: ") + std::strerror(errno));
    if (auto wrong = copy_to(to); !wrong.empty()) {
      ::close(to);
      return tl::unexpected(std::move(wrong));
    }
    return to;
  }
  [[nodiscard]] std::uint64_t size() const { return size_; }

 private:
  // Empty: all of it.
  std::string copy_to(int to) {
    std::array<char, 1 << 16> buffer;
    for (;;) {
      if (!wait_for_more()) return "does not end within " + number_text(intake_.seconds) + " s";
      const ssize_t count = ::read(from_, buffer.data(), buffer.size());
      if (count < 0 && errno == EINTR) continue;
      if (count == 0) return {};
      if (count < 0) return std::strerror(errno);
      size_ += static_cast<std::uint64_t>(count);
      if (size_ > intake_.most_bytes)
        return "does not end within " + std::to_string(intake_.most_bytes >> 20U) +
               " MiB; what is longer is to be a file";
      if (!write_all(to, {buffer.data(), static_cast<std::size_t>(count)}))
        return std::strerror(errno);
    }
  }

  // False: the time is over. It begins with the first byte: who types may think before.
  bool wait_for_more() {
    if (intake_.seconds <= 0 || size_ == 0) return true;
    if (!begin_) begin_ = Clock::now();
    for (;;) {
      const std::chrono::duration<double> passed = Clock::now() - *begin_;
      if (passed.count() > intake_.seconds) return false;
      constexpr int kWait_ms = 50;
      pollfd question{from_, POLLIN, 0};
      if (::poll(&question, 1, kWait_ms) != 0) return true;
    }
  }

  int from_;
  SourceFile::Intake intake_;
  std::uint64_t size_ = 0;
  std::optional<Clock::time_point> begin_;
};

}  // namespace

SourceFile::SourceFile(std::string name, int descriptor, std::uint64_t size)
    : name_(std::move(name)), descriptor_(descriptor), size_(size) {}

SourceFile::SourceFile(std::string name, std::shared_ptr<const std::string> text)
    : name_(std::move(name)), text_(std::move(text)), size_(text_->size()) {}

SourceFile::~SourceFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Outcome<std::unique_ptr<SourceFile>> SourceFile::open(const std::string& path,
                                                      const Intake& intake) {
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
  Spool spool(descriptor, intake);
  const auto copy = spool.copy();
  ::close(descriptor);
  if (!copy) return input_failure(path, copy.error());
  return std::unique_ptr<SourceFile>(new SourceFile(path, *copy, spool.size()));
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

Outcome<std::string> read_whole(const std::string& path, std::uint64_t most_bytes,
                                const std::string& what) {
  const auto file = SourceFile::open(path, {.most_bytes = most_bytes, .seconds = 10});
  if (!file) return tl::unexpected(file.error());
  if ((*file)->size() > most_bytes) return input_failure(path, "too large for " + what);
  std::string text((*file)->size(), '\0');
  text.resize((*file)->read(0, text));
  return text;
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
