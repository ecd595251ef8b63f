#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace kerf::mesh {

/// Values that each belong to a corner, in rows by corner: two passes over whatever has them.
class ByCorner {
 public:
  explicit ByCorner(std::size_t corners) : ends_(corners + 1) {}

  /// First pass: a value belongs to this corner.
  void count(std::uint32_t corner) { ++ends_[corner]; }
  /// Between the passes.
  void begin() {
    std::uint32_t sum = 0;
    for (std::uint32_t& end : ends_) {
      sum += end;
      end = sum;
    }
    values_.resize(sum);
  }
  /// Second pass, the same corners.
  void put(std::uint32_t corner, std::uint32_t value) { values_[--ends_[corner]] = value; }

  /// Behind both passes.
  [[nodiscard]] std::span<std::uint32_t> row(std::size_t corner) {
    return {values_.data() + ends_[corner], ends_[corner + 1] - ends_[corner]};
  }
  [[nodiscard]] std::size_t corners() const { return ends_.size() - 1; }

 private:
  std::vector<std::uint32_t> ends_;  // of the rows; behind put(), where they begin
  std::vector<std::uint32_t> values_;
};

}  // namespace kerf::mesh
