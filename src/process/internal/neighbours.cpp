#include "process/internal/neighbours.hpp"

#include <algorithm>

#include "process/internal/near_tree.hpp"

namespace kerf::process::ordering {
namespace {

constexpr std::uint32_t kMostPorts = 4;  // of an item
constexpr std::size_t kMostAsked = 20;   // ports near a port, of which some are of the same item

/// Places of an item's entries that stand for all of them.
std::vector<Vec2> ports_of(std::span<const Entry> entries) {
  std::vector<Vec2> ports;
  const auto add = [&](Vec2 at) {
    if (std::find(ports.begin(), ports.end(), at) == ports.end()) ports.push_back(at);
  };
  const std::size_t step = std::max<std::size_t>(1, entries.size() / kMostPorts);
  for (std::size_t i = 0; i < entries.size() && ports.size() < kMostPorts; i += step) {
    add(entries[i].begin);
    add(entries[i].end);
  }
  return ports;
}

std::uint32_t nearest_of(std::span<const Vec2> ports, Vec2 at) {
  const auto nearest = std::min_element(
      ports.begin(), ports.end(), [&](Vec2 a, Vec2 b) { return apart(a, at) < apart(b, at); });
  return static_cast<std::uint32_t>(nearest - ports.begin());
}

}  // namespace

Neighbours::Neighbours(const FlatItems& items)
    : port_of_begin_(items.entries().size()), port_of_end_(items.entries().size()) {
  for (std::uint32_t item = 0; item < items.size(); ++item) add_ports(items, item);
  find_near();
}

void Neighbours::add_ports(const FlatItems& items, std::uint32_t item) {
  const std::uint32_t begin = items.first_entry(item);
  const std::uint32_t end = items.end_entry(item);
  const std::vector<Vec2> ports = ports_of({items.entries().data() + begin, end - begin});
  const auto first = static_cast<std::uint32_t>(ports_.size());
  for (std::uint32_t entry = begin; entry < end; ++entry) {
    port_of_begin_[entry] = first + nearest_of(ports, items.entries()[entry].begin);
    port_of_end_[entry] = first + nearest_of(ports, items.entries()[entry].end);
  }
  ports_.insert(ports_.end(), ports.begin(), ports.end());
  owner_.resize(ports_.size(), item);
}

void Neighbours::find_near() {
  const NearTree tree{ports_};
  near_.resize(ports_.size() * kMostNear);
  counts_.resize(ports_.size());
  std::vector<std::uint32_t> found;
  for (std::uint32_t port = 0; port < ports_.size(); ++port) {
    tree.nearest(ports_[port], kMostAsked, found);
    std::uint32_t* const list = near_.data() + std::size_t{port} * kMostNear;
    std::uint32_t* end = list;
    for (const std::uint32_t other : found) {
      const std::uint32_t item = owner_[other];
      if (item == owner_[port] || std::find(list, end, item) != end) continue;
      if (end < list + kMostNear) *end++ = item;
    }
    counts_[port] = static_cast<std::uint32_t>(end - list);
  }
}

}  // namespace kerf::process::ordering
