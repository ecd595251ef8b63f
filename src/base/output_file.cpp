#include "base/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <random>

namespace kerf::base {
namespace {

constexpr std::size_t kBufferBytes = 1 << 18;

// Names of unfinished files, where a signal handler can reach them. The one mutable global of Kerf:
// signals belong to the process, not to a machine.
constexpr std::size_t kMostUnfinished = 64;
constexpr std::size_t kLongestName = 4096;
struct Unfinished {
  enum class State : std::uint8_t { free, being_written, names_a_file };
  std::atomic<State> state{State::free};  // whoever writes the name owns the slot
  std::array<char, kLongestName> name{};
};
std::array<Unfinished, kMostUnfinished> unfinished;

// The slot of the name; kMostUnfinished where there is none for it.
std::size_t remember(const std::string& name) {
  if (name.size() + 1 > kLongestName) return kMostUnfinished;
  for (std::size_t i = 0; i < kMostUnfinished; ++i) {
    Unfinished& slot = unfinished[i];
    auto expected = Unfinished::State::free;
    if (!slot.state.compare_exchange_strong(expected, Unfinished::State::being_written)) continue;
    std::memcpy(slot.name.data(), name.c_str(), name.size() + 1);
    slot.state = Unfinished::State::names_a_file;
    return i;
  }
  return kMostUnfinished;
}

void forget(std::size_t slot) {
  if (slot < kMostUnfinished) unfinished[slot].state = Unfinished::State::free;
}

// A name that nobody has: ".NAME.XXXXXX".
std::string temporary_beside(const std::string& path) {
  constexpr std::string_view kLetters =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
  const std::filesystem::path target(path);
  std::string name(".");
  name += target.filename().string();
  name += '.';
  std::random_device random;
  for (int i = 0; i < 6; ++i) name += kLetters[random() % kLetters.size()];
  return (target.parent_path() / name).string();
}

// With the access that the account gives to its new files.
int create_temporary(const std::string& path, std::string& temporary) {
  for (int tries = 0; tries < 100; ++tries) {
    temporary = temporary_beside(path);
    const int descriptor =
        ::open(temporary.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
  return -1;
}

tl::unexpected<Failure> output_failure(const std::string& path, int error) {
  return tl::unexpected(Failure{Failure::Kind::output, path + ": " + std::strerror(error)});
}

bool is_renamable(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) != 0 || S_ISREG(status.st_mode) || S_ISDIR(status.st_mode);
}

std::string folder_of(const std::string& path) {
  std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

}  // namespace

OutputFile::OutputFile(std::string path, std::string temporary, int descriptor)
    : path_(std::move(path)), temporary_(std::move(temporary)), descriptor_(descriptor) {
  if (!temporary_.empty()) slot_ = remember(temporary_);
}

OutputFile::~OutputFile() {
  if (temporary_.empty()) flush();
  if (descriptor_ >= 0) ::close(descriptor_);
  if (temporary_.empty()) return;
  ::unlink(temporary_.c_str());
  forget(slot_);
}

Outcome<std::unique_ptr<OutputFile>> OutputFile::create(const std::string& path) {
  if (path == "-" || !is_renamable(path)) {
    const int descriptor =
        path == "-" ? ::dup(STDOUT_FILENO) : ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) return output_failure(path, errno);
    return std::unique_ptr<OutputFile>(new OutputFile(path, {}, descriptor));
  }
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode))
    return output_failure(path, EISDIR);
  std::string temporary;
  const int descriptor = create_temporary(path, temporary);
  if (descriptor < 0) return output_failure(path, errno);
  return std::unique_ptr<OutputFile>(new OutputFile(path, std::move(temporary), descriptor));
}

void OutputFile::write(std::string_view bytes) {
  if (error_ != 0) return;
  buffer_.append(bytes);
  if (buffer_.size() >= kBufferBytes) flush();
}

void OutputFile::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty() && error_ == 0) {
    const ssize_t count = ::write(descriptor_, rest.data(), rest.size());
    if (count > 0) rest.remove_prefix(static_cast<std::size_t>(count));
    if (count < 0 && errno != EINTR) error_ = errno;
  }
  buffer_.clear();
}

Outcome<void> OutputFile::prepare(Durability durability) {
  flush();
  const bool durable = durability == Durability::survives_power_loss;
  if (error_ == 0 && durable && !temporary_.empty() && ::fsync(descriptor_) != 0) error_ = errno;
  if (error_ != 0) return output_failure(path_, error_);
  return {};
}

Outcome<void> OutputFile::commit(Durability durability) {
  static_cast<void>(prepare(durability));
  const bool durable = durability == Durability::survives_power_loss;
  if (::close(descriptor_) != 0 && error_ == 0) error_ = errno;
  descriptor_ = -1;
  if (error_ != 0) return output_failure(path_, error_);
  if (temporary_.empty()) return {};
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) return output_failure(path_, errno);
  forget(slot_);
  temporary_.clear();
  if (durable) return sync_folder(folder_of(path_));
  return {};
}

Outcome<void> sync_folder(const std::string& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return output_failure(folder, errno);
  const int error = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  if (error != 0) return output_failure(folder, error);
  return {};
}

void remove_unfinished_outputs() noexcept {
  for (const Unfinished& slot : unfinished) {
    if (slot.state == Unfinished::State::names_a_file) ::unlink(slot.name.data());
  }
}

}  // namespace kerf::base
