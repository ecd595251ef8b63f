#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/language.hpp"

namespace kerf::features {

/// The value of a `#n=`: bytes of the text.
struct Assignment {
  std::size_t from = 0;
  std::size_t length = 0;
};

/// Where the first program of a text says `#n=`, and what stands behind it up to the end of the
/// block.
[[nodiscard]] std::vector<Assignment> assignments_of(const base::Language& language,
                                                     const std::string& text, std::uint32_t n);

}  // namespace kerf::features
