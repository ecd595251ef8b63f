#pragma once

#include <cstdint>
#include <map>
#include <shared_mutex>
#include <vector>

#include "base/block_id.hpp"
#include "output/part/part_frame.hpp"

namespace kerf::job {

/// Who cut a place: a block with a tool.
struct PartOwner {
  std::uint32_t file = 0;  ///< as base::FileId counts
  std::uint32_t line = 0;
  std::uint32_t tool = 0;

  friend auto operator<=>(const PartOwner&, const PartOwner&) = default;
};

/// The blocks that cut, by motions, and the 65,535 numbers that frames have for them. Where a
/// program has more blocks, neighbours share a number, which stands for the first of them; so
/// numbers may change, and begin anew with another edition. One thread adds, any asks.
class OwnerTable {
 public:
  static constexpr std::size_t kMostNumbers = 65'535;

  void add(std::uint32_t motion, const PartOwner& owner);

  /// Of the frames, 0: nobody. From 1 on.
  [[nodiscard]] std::uint16_t number(std::uint32_t motion) const;
  /// As frames ask for it; as long as the table is there.
  [[nodiscard]] output::OwnerOf numbers() const {
    return [this](std::uint32_t motion) { return number(motion); };
  }
  /// The exact one; nobody has line 0.
  [[nodiscard]] PartOwner owner(std::uint32_t motion) const;
  /// Grows when numbers begin anew.
  [[nodiscard]] std::uint32_t edition() const;
  /// Whom numbers stand for, from this number on, the first of all being nobody's.
  [[nodiscard]] std::vector<PartOwner> numbered(std::size_t from) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] std::uint32_t row_of(std::uint32_t motion) const;

  mutable std::shared_mutex mutex_;
  std::vector<PartOwner> rows_;               // by their first cut
  std::map<PartOwner, std::uint32_t> known_;  // their rows
  std::vector<std::uint32_t> of_motion_;      // 1 + row; 0: none
  std::uint32_t shift_ = 0;                   // 2^shift rows share a number
};

}  // namespace kerf::job
