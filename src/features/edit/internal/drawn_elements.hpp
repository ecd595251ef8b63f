#pragma once

#include <vector>

#include "features/edit/outline.hpp"

namespace kerf::features {

/// The elements of a contour with those that were drawn among them: one after the other, each in
/// the gap, and in the direction, that leaves the least of gaps. Where there is no gap they are
/// last, and the contour is open there.
[[nodiscard]] std::vector<Outline::Step> with_drawn(std::vector<Outline::Step> placed,
                                                    const std::vector<Outline::Step>& drawn,
                                                    bool is_closed);

}  // namespace kerf::features
