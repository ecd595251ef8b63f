#include "face/server/store/chunk_store.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace kerf::server {
namespace {

tl::unexpected<base::Failure> not_kept(const std::string& message) {
  return tl::unexpected(base::Failure{base::Failure::Kind::output, message});
}

bool write_all(int descriptor, const std::string& bytes, std::uint64_t offset) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = ::pwrite(descriptor, bytes.data() + done, bytes.size() - done,
                                   static_cast<off_t>(offset + done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    done += static_cast<std::size_t>(count);
  }
  return true;
}

}  // namespace

ChunkStore::~ChunkStore() {
  budget_->bytes -= end_;
  if (descriptor_ >= 0) ::close(descriptor_);
}

base::Outcome<void> ChunkStore::open() {
  std::string name = folder_ + "/.preview.XXXXXX";
  descriptor_ = ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0)
    return not_kept(std::string("the picture cannot be kept: ") + std::strerror(errno));
  ::unlink(name.c_str());
  return {};
}

// Written outside of the lock: there is one who adds.
base::Outcome<void> ChunkStore::add(const std::string& chunk) {
  if (end_ + chunk.size() > kMostBytes)
    return not_kept("the picture of this program is larger than 1 GiB; the rest is left out");
  if (budget_->bytes + chunk.size() > ChunkBudget::kMostBytes)
    return not_kept("the pictures of this server are larger than 8 GiB; the rest is left out");
  if (descriptor_ < 0) {
    if (auto opened = open(); !opened) return opened;
  }
  if (!write_all(descriptor_, chunk, end_))
    return not_kept(std::string("the picture cannot be kept: ") + std::strerror(errno));
  const std::lock_guard lock(guard_);
  extents_.push_back({end_, chunk.size()});
  end_ += chunk.size();
  budget_->bytes += chunk.size();
  return {};
}

std::size_t ChunkStore::count() const {
  const std::lock_guard lock(guard_);
  return extents_.size();
}

std::optional<std::string> ChunkStore::read(std::size_t number) const {
  Extent extent;
  {
    const std::lock_guard lock(guard_);
    if (number >= extents_.size()) return std::nullopt;
    extent = extents_[number];
  }
  std::string bytes(extent.bytes, '\0');
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = ::pread(descriptor_, bytes.data() + done, bytes.size() - done,
                                  static_cast<off_t>(extent.offset + done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return std::nullopt;
    done += static_cast<std::size_t>(count);
  }
  return bytes;
}

}  // namespace kerf::server
