#pragma once

#include <cstdint>

namespace kerf::test {

/// Calls of operator new in this program, on all threads.
[[nodiscard]] std::uint64_t allocations_so_far();

}  // namespace kerf::test
