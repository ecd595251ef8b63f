#pragma once

#include <cstdint>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "features/edit/edit.hpp"

namespace kerf::job {

/// Why a text is no edits file, and where.
struct EditsFileFault {
  std::string sentence{};  ///< behind "THE EDITS FILE CANNOT BE READ: "
  std::uint32_t line = 1;
  std::uint32_t column = 1;  ///< in bytes
};

/// Reads an edits file, version 1. `turns`: contours are a lathe's, [z, x, bulge], x a diameter;
/// they are kept as they are written. Every member must be known, said once, of its type and a
/// number that is one, no farther from 0 than 1e6; a text of more than 64 MiB, with more than
/// 1,000,000 contour points or 20,000 edits is refused.
[[nodiscard]] tl::expected<std::vector<features::Edit>, EditsFileFault> read_edits(
    const std::string& text, bool turns = false);

}  // namespace kerf::job
