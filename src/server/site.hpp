#pragma once

#include <cstddef>

#include "server/access.hpp"
#include "server/asset_table.hpp"
#include "server/hub.hpp"

namespace kerf::server {

/// What every connection needs of its server. Belongs to the thread of the sockets.
struct Site {
  Address address;
  AssetTable assets;
  Hub& hub;
  std::size_t connections = 0;  ///< that are open, of both protocols
  std::size_t uploads = 0;      ///< that are under way
};

/// Counts something for as long as it lives.
class Counted {
 public:
  explicit Counted(std::size_t& count) : count_(&count) { ++*count_; }
  ~Counted() {
    if (count_ != nullptr) --*count_;
  }
  Counted(Counted&& other) noexcept : count_(other.count_) { other.count_ = nullptr; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
  Counted& operator=(Counted&&) = delete;

 private:
  std::size_t* count_;
};

}  // namespace kerf::server
