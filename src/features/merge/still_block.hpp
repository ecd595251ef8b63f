#pragma once

#include <cstdint>
#include <optional>

#include "features/merge/merge_state.hpp"

namespace kerf::features {

/// A block that names a place and goes nowhere, since the tool stands there already. No row tells
/// of it; where the tool comes to stand elsewhere it would go back.
struct StillBlock {
  Bytes line{};  ///< with its end
  Bytes block{};
  std::vector<BlockWord> words{};
};

/// Those between the block of the row before and the one of `row`, in one file, one behind the
/// other.
[[nodiscard]] std::vector<StillBlock> still_before(const MergeState& state, std::uint32_t row);

/// They stay still where the new program stands by now; `row` comes next.
void stay_still(MergeState& state, std::uint32_t row);

/// Whether the last of them can go to where a new rapid goes, in its place.
[[nodiscard]] bool can_go(const MergeState& state, std::uint32_t row, const PlannedRow& rapid);

}  // namespace kerf::features
