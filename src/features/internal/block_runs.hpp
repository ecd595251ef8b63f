#pragma once

#include <cstdint>
#include <vector>

#include "features/path/recording.hpp"

namespace kerf::features {

/// How often and along which calls the blocks of a recording were executed. Places are those among
/// its blocks.
class BlockRuns {
 public:
  explicit BlockRuns(const Recording& recording);

  /// Along several ways of calls.
  [[nodiscard]] bool is_shared(std::uint32_t place) const { return has(place, kShared); }
  /// More than once along one way.
  [[nodiscard]] bool is_repeated(std::uint32_t place) const { return has(place, kRepeated); }
  /// Another block of its line has moved, too.
  [[nodiscard]] bool shares_line(std::uint32_t place) const { return has(place, kSharesLine); }

 private:
  static constexpr std::uint8_t kShared = 1;
  static constexpr std::uint8_t kRepeated = 2;
  static constexpr std::uint8_t kSharesLine = 4;

  [[nodiscard]] bool has(std::uint32_t place, std::uint8_t flag) const {
    return (flags_[place] & flag) != 0;
  }
  void tell(const Recording& recording, const std::vector<std::uint32_t>& order, std::size_t begin,
            std::size_t end);

  std::vector<std::uint8_t> flags_;
};

}  // namespace kerf::features
