#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "features/path/recording.hpp"
#include "features/tree/feature.hpp"

namespace kerf::features {

/// A loop that was cut.
struct OldLoop {
  Span rows{};
  contour::Contour path{};
  double distance = 0;  ///< of its nearest point from the wall
  bool begins_at_corner = true;
};

/// The loops of a layer in the order in which they were cut. `walls`: its contours.
[[nodiscard]] std::vector<OldLoop> old_loops(const Recording& recording,
                                             const std::vector<Span>& loops,
                                             const std::vector<contour::Contour>& walls);

/// How a layer was cut.
struct OldWay {
  std::vector<OldLoop> loops{};  ///< in the order in which they were cut
  bool turns_sharply = false;    ///< round what stands out of the wall, not in arcs
};

/// How the layers of a recording were cut. Each is worked out once, however many edits of it are
/// tried; one thread at a time. The recording must outlive it.
class OldWays {
 public:
  explicit OldWays(const Recording& recording) : recording_(recording) {}

  /// Of a layer that was cut in one visit at least.
  [[nodiscard]] const OldWay& of(const Layer& layer);

 private:
  const Recording& recording_;
  std::map<std::uint32_t, OldWay> known_{};  // by the first row of the layer
};

}  // namespace kerf::features
