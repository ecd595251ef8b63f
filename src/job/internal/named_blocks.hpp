#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace kerf::job {

/// The N words that jumps and calls of a text may name, ascending: GOTO10, P10, Q10. Rather one too
/// many.
[[nodiscard]] std::vector<std::uint32_t> named_blocks(std::string_view text);

}  // namespace kerf::job
