#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace kerf::output::plot {

inline constexpr double kTickText = 12;  ///< pixels, of the labels

/// A mark of a ruler; minor ones have no label.
struct Tick {
  double value = 0;
  bool major = false;
  std::string label;
};

/// Marks at round values (1, 2 or 5 times a power of ten apart) from `low` to `high`, low <= high,
/// with at least `min_step` > 0 between labelled ones. Values that are shown multiplied by
/// `label_factor` are round in what is shown.
[[nodiscard]] std::vector<Tick> ruler(double low, double high, double min_step,
                                      double label_factor = 1);

}  // namespace kerf::output::plot
