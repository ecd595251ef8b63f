#pragma once

#include <cstdint>
#include <utility>

namespace kerf::machine {

/// The outcome of `attempt(block)` for the first block from `first` to `last` where it has one: an
/// optional. A block where it has one has mostly only such blocks behind it; where that is not so,
/// this may be a later one.
template <typename Attempt>
auto at_first_block(std::uint64_t first, std::uint64_t last, Attempt&& attempt) {
  auto best = attempt(first);
  if (best) return best;
  for (std::uint64_t bad = first, good = last + 1; bad + 1 < good;) {
    const std::uint64_t middle = bad + (good - bad) / 2;
    if (auto found = attempt(middle)) {
      best = std::move(found);
      good = middle;
    } else {
      bad = middle;
    }
  }
  return best;
}

}  // namespace kerf::machine
