#pragma once

#include <vector>

#include "geometry/contour/region.hpp"
#include "stock/tool/tool.hpp"

namespace kerf::features {

/// On which side of its path a turning tool stands.
enum class Beyond : std::uint8_t {
  outside,  ///< farther from the axis
  inside,   ///< nearer to it
  front     ///< towards +Z
};

/// How wide a tool is from its programmed point on.
struct TipWidth {
  double low = 0;
  double high = 0;
};
/// Along Z, or of a tool that plunges into the face along X, by the width of the tool and the
/// direction of its tip.
[[nodiscard]] TipWidth tip_width(const stock::Tool& tool);

/// A round nose behind the imaginary tip that the program leads.
struct Nose {
  double radius = 0;       ///< 0: nobody has said, or it is sharp
  contour::Vec2 centre{};  ///< from the tip, (z, x)
};
[[nodiscard]] Nose nose_of(const stock::Tool& tool);

/// What a nose reaches along the path of its tip, and all that lies beyond.
[[nodiscard]] contour::Region reached_by_nose(const std::vector<contour::Edge>& path, Beyond beyond,
                                              const Nose& nose);

/// All that lies beyond a path on one side, as far as the tool reaches along the path.
[[nodiscard]] contour::Region reached(const std::vector<contour::Edge>& path, Beyond beyond,
                                      TipWidth width);

}  // namespace kerf::features
