#pragma once

#include "features/merge/merge.hpp"

namespace kerf::features {

/// An operation whose blocks shall name another tool.
struct ToolWords {
  std::uint32_t was = 0;
  std::uint32_t is = 0;
  Span rows{};  ///< of the operation
};

/// Adds to a merge what makes the opening of an operation, and what it says of its offsets, name
/// another tool: T before its first row, H and D up to its last, where they are the old number
/// (features-contract §8.7). A T that was said earlier is looked for there. Nothing else changes.
[[nodiscard]] tl::expected<void, CannotMerge> change_tool_words(const Recording& recording,
                                                                const ToolWords& wish,
                                                                const MergeSources& sources,
                                                                Merged& merged);

}  // namespace kerf::features
