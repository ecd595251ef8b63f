#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "output/picture/drawing/space.hpp"

namespace kerf::output::plot {

/// Remembers segments by the cells of a grid that their ends lie in, without regard to direction.
/// Two segments with the same 64-bit mark count as the same one. Remembers up to kCapacity
/// segments; when it is full, every other one counts as new.
class SegmentSet {
 public:
  static constexpr std::size_t kCapacity = 100'000;

  /// Forgets all segments. `cell` > 0 mm; coordinates divided by it stay below 2^51.
  void clear(double cell) {
    per_mm_ = 1 / cell;
    slots_.assign(kSlots, 0);
    count_ = 0;
  }

  /// False when a segment between these cells, with the same `label`, is known already.
  bool insert(const Point3& a, const Point3& b, std::uint32_t label) {
    const std::uint64_t mark_a = cell_mark(a), mark_b = cell_mark(b);
    const std::uint64_t mark = mixed((mark_a + mark_b) ^ mixed(mark_a ^ mark_b) ^ label) | 1;
    std::size_t at = mark >> kShift;
    for (; slots_[at] != 0; at = (at + 1) % kSlots) {
      if (slots_[at] == mark) return false;
    }
    if (count_ == kCapacity) return true;
    slots_[at] = mark;
    ++count_;
    return true;
  }

 private:
  static constexpr std::size_t kSlots = std::size_t{1} << 17;
  static constexpr int kShift = 64 - 17;

  static std::uint64_t mixed(std::uint64_t value) {
    value = (value ^ (value >> 32)) * 0xd6e8feb86659fd93ULL;
    return value ^ (value >> 32);
  }

  [[nodiscard]] std::uint64_t cell_mark(const Point3& p) const {
    constexpr double kToWhole = 6755399441055744;  // 1.5 * 2^52: the sum has no room for a fraction
    std::uint64_t mark = 0;
    for (const double coordinate : p) {
      const auto cell = static_cast<std::uint64_t>(coordinate * per_mm_ + kToWhole);
      mark = mixed((mark ^ cell) * 0x9e3779b97f4a7c15ULL);
    }
    return mark;
  }

  double per_mm_ = 1;
  std::vector<std::uint64_t> slots_;  // 0: free
  std::size_t count_ = 0;
};

}  // namespace kerf::output::plot
