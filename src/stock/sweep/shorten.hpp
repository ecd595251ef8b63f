#pragma once

#include <cstddef>
#include <vector>

#include "stock/sweep/sweep.hpp"

namespace kerf::stock {

/// Of the sweeps from `first` on, which are one motion, only this share of their way is left, in
/// [0, 1].
void shorten(std::vector<Sweep>& sweeps, std::size_t first, double share);

}  // namespace kerf::stock
