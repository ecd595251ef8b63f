#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>

#include "base/place.hpp"

namespace kerf::output {

/// How often each source line has run, of as many lines as its owner has it keep.
class LineRuns {
 public:
  /// So many lines are kept in any case: what they command may still have to be made.
  static constexpr std::uint64_t kAhead = 100'000;

  void count(base::FileId file, std::uint32_t line);
  /// 0 of a line that never ran or has been forgotten.
  [[nodiscard]] std::uint64_t of(base::FileId file, std::uint32_t line) const;
  [[nodiscard]] std::size_t size() const { return lines_.size(); }

  /// Forgets the lines that `is_idle(file, line)` says have done nothing, but for the last kAhead
  /// that ran.
  template <typename IsIdle>
  void forget(IsIdle&& is_idle) {
    std::erase_if(lines_, [&](const auto& item) {
      const auto& [key, runs] = item;
      return counted_ - runs.last >= kAhead &&
             is_idle(base::FileId(static_cast<std::uint32_t>(key >> 32)),
                     static_cast<std::uint32_t>(key));
    });
  }

 private:
  struct Runs {
    std::uint64_t count = 0;
    std::uint64_t last = 0;  ///< counted_ when it began
  };
  [[nodiscard]] static std::uint64_t key_of(base::FileId file, std::uint32_t line) {
    return static_cast<std::uint64_t>(file) << 32 | line;
  }

  std::unordered_map<std::uint64_t, Runs> lines_;
  std::uint64_t counted_ = 0;
};

}  // namespace kerf::output
