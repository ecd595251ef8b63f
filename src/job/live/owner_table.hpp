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

/// What is told of a number.
struct OwnerRow {
  PartOwner owner{};          ///< the first that it stands for
  double engagement_deg = 0;  ///< the largest of all their motions, to a tenth; 0: not known

  friend bool operator==(const OwnerRow&, const OwnerRow&) = default;
};

/// The blocks that cut, by motions, and the 65,535 numbers that frames have for them. Where a
/// program has more blocks, neighbours share a number, which stands for the first of them; so
/// numbers may change, and begin anew with another edition. One thread adds, any asks.
class OwnerTable {
 public:
  static constexpr std::size_t kMostNumbers = 65'535;

  /// A motion of the owner, whose tool was engaged over so much of its circle; 0: not known.
  void add(std::uint32_t motion, const PartOwner& owner, double engagement_deg = 0);

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

  struct News {
    std::size_t first = 0;  ///< the number of the first row
    std::vector<OwnerRow> rows;
    std::uint64_t change = 0;  ///< up to which this is
  };
  /// What numbers stand for, from the first to the last one of which something else is known than
  /// at that change; at 0 of all, the first of them being nobody's.
  [[nodiscard]] News since(std::uint64_t change) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Numbered {
    OwnerRow row;
    std::uint64_t change = 0;  // when it became so
  };

  [[nodiscard]] std::uint32_t row_of(std::uint32_t motion) const;
  void take(std::uint32_t row, double engagement_deg);
  void share_more();

  mutable std::shared_mutex mutex_;
  std::vector<PartOwner> rows_;               // by their first cut
  std::map<PartOwner, std::uint32_t> known_;  // their rows
  std::vector<std::uint32_t> of_motion_;      // 1 + row; 0: none
  std::vector<Numbered> numbered_;            // from number 1 on
  std::uint32_t shift_ = 0;                   // 2^shift rows share a number
  std::uint64_t changes_ = 1;                 // the first is nobody
};

}  // namespace kerf::job
