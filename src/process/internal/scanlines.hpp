#pragma once

#include <vector>

#include "process/passes.hpp"
#include "process/scan.hpp"

namespace kerf::process {

struct Hatch {
  double spacing = 0.1;
  double angle_deg = 0;
  double inset = 0;
  bool is_bidirectional = true;
};

/// What of closed outlines, by the even-odd rule or their own, lies on parallel lines: as many as
/// fit in the extent across them, about its middle. Every second one is turned round where the
/// hatch goes both ways. n log n in edges, and linear in what is found.
[[nodiscard]] std::vector<ScanLine> hatched(const std::vector<Outline>& outlines,
                                            const Hatch& hatch);

}  // namespace kerf::process
