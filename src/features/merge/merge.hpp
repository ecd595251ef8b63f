#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "base/diagnostic_code.hpp"
#include "base/language.hpp"
#include "features/rewrite/planned_row.hpp"

namespace kerf::features {

/// What a merge reads beside the recording. All must outlive it.
struct MergeSources {
  const base::Language& language;
  std::map<base::FileId, std::string> texts{};  ///< of the files that blocks stand in
  /// What a length without a point counts in its unit: 0.001; 0: as with one.
  double pointless = 0;
  /// What X says of a millimetre that the axis goes: 2 of a lathe whose programs say diameters.
  double x_counts = 1;
  /// Whether a block also sets something up (a tool, a spindle, a mode), so that it never goes.
  std::function<bool(const base::BlockId&)> sets_up{};
  /// Whether a jump or a call names the N word of a block, so that it never goes.
  std::function<bool(const base::BlockId&)> is_named{};
};

/// Bytes of a file that others take the place of; neither list has a part of a line end alone.
struct Replacement {
  std::uint64_t from = 0;
  std::uint64_t length = 0;
  std::string text{};
};

struct Merged {
  std::map<base::FileId, std::vector<Replacement>> replacements{};  ///< in their order
  std::uint32_t kept = 0;                                           ///< blocks within the stretches
  std::uint32_t patched = 0;
  std::uint32_t inserted = 0;
  std::uint32_t removed = 0;
};

/// Why a text cannot be merged.
struct CannotMerge {
  base::Code code{};
  std::string sentence{};
};

/// Makes the blocks of a program command the rows of a plan (features-contract §8): only digits of
/// words that must change, words that are missing, blocks that come in or go.
[[nodiscard]] tl::expected<Merged, CannotMerge> merge(const Recording& recording,
                                                      const RowPlan& plan,
                                                      const MergeSources& sources);

/// The text with its replacements.
[[nodiscard]] std::string replaced(const std::string& text,
                                   const std::vector<Replacement>& replacements);

}  // namespace kerf::features
