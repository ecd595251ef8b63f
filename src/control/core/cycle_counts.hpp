#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace kerf::control {

/// A cycle that a program has run: its code, the line of its block, and its passes; of a modal one
/// those of all blocks that repeat it.
struct CycleCount {
  std::string code;
  std::uint32_t line = 0;
  std::uint64_t passes = 0;
};

/// The cycles of a run in their order, the first ones of very many.
class CycleCounts {
 public:
  void begin(std::string code, std::uint32_t line) {
    is_full_ = list_.size() >= kMost;
    if (!is_full_) list_.push_back({std::move(code), line, 0});
  }
  /// To the one that began last.
  void add(std::uint64_t passes) {
    if (!is_full_ && !list_.empty()) list_.back().passes += passes;
  }
  [[nodiscard]] const std::vector<CycleCount>& list() const { return list_; }

 private:
  static constexpr std::size_t kMost = 10'000;
  std::vector<CycleCount> list_;
  bool is_full_ = false;
};

}  // namespace kerf::control
