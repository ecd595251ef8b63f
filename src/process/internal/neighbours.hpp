#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "process/internal/flat_items.hpp"

namespace kerf::process::ordering {

/// Which items are near each end of an item. Of one that can be begun in many places a few stand
/// for all of them.
class Neighbours {
 public:
  explicit Neighbours(const FlatItems& items);

  /// By ascending distance, without the item itself.
  [[nodiscard]] std::span<const std::uint32_t> near_begin(std::uint32_t entry) const {
    return near(port_of_begin_[entry]);
  }
  [[nodiscard]] std::span<const std::uint32_t> near_end(std::uint32_t entry) const {
    return near(port_of_end_[entry]);
  }

 private:
  static constexpr std::size_t kMostNear = 8;

  [[nodiscard]] std::span<const std::uint32_t> near(std::uint32_t port) const {
    return {near_.data() + std::size_t{port} * kMostNear, counts_[port]};
  }
  void add_ports(const FlatItems& items, std::uint32_t item);
  void find_near();

  std::vector<Vec2> ports_;
  std::vector<std::uint32_t> owner_;  // of each port
  std::vector<std::uint32_t> port_of_begin_;
  std::vector<std::uint32_t> port_of_end_;
  std::vector<std::uint32_t> near_;
  std::vector<std::uint32_t> counts_;
};

}  // namespace kerf::process::ordering
