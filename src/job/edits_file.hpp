#pragma once

#include <string>
#include <vector>

#include "features/edit/edit.hpp"
#include "features/edit/fault.hpp"

namespace kerf::job {

/// Why a text is no edits file, and where.
struct EditsFileFault {
  std::string sentence{};  ///< behind "THE EDITS FILE CANNOT BE READ: "
  std::uint32_t line = 1;
  std::uint32_t column = 1;
};

/// Reads an edits file, version 1. `turns`: contours are a lathe's, [z, x, bulge]. Every member
/// must be known, of its type and a number that is one; a text of more than 64 MiB, or with more
/// than 1,000,000 contour points, is refused.
[[nodiscard]] tl::expected<std::vector<features::Edit>, EditsFileFault> read_edits(
    const std::string& text);

}  // namespace kerf::job
