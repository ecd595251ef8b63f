#pragma once

#include <atomic>
#include <cstddef>
#include <memory>

namespace kerf::server {

/// So many things, and so many bytes of them, may be under way at once. They are counted on one
/// thread; whoever holds a ticket may let go of it on any.
class Quota {
 public:
  /// What one thing takes of the quota, for as long as it lives.
  using Ticket = std::shared_ptr<const void>;

  Quota(std::size_t most, std::size_t most_bytes) : most_(most), most_bytes_(most_bytes) {}

  /// Null: there is no room.
  [[nodiscard]] Ticket take(std::size_t bytes) {
    if (held_->count >= most_ || held_->bytes + bytes > most_bytes_) return nullptr;
    ++held_->count;
    held_->bytes += bytes;
    return {held_.get(), [held = held_, bytes](const void*) {
              --held->count;
              held->bytes -= bytes;
            }};
  }

 private:
  struct Held {
    std::atomic<std::size_t> count{0};
    std::atomic<std::size_t> bytes{0};
  };

  std::size_t most_;
  std::size_t most_bytes_;
  std::shared_ptr<Held> held_ = std::make_shared<Held>();
};

}  // namespace kerf::server
