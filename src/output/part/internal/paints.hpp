#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "output/part/part_picture.hpp"
#include "output/picture/drawing/palette.hpp"

namespace kerf::output::plot {

inline constexpr Color kUncut{203, 209, 215};
inline constexpr Color kFixturePaint{118, 130, 146};
inline constexpr Color kSectionPaint{236, 214, 176};
inline constexpr Color kErrorMark{206, 32, 41};
inline constexpr Color kWarningMark{214, 122, 0};

/// Which colour what of a picture has: that of the stock, fixtures, sections, and one a tool.
class Paints {
 public:
  explicit Paints(const PartScene& scene);

  static constexpr std::uint16_t kStock = 0, kFixture = 1, kSection = 2;

  [[nodiscard]] const std::vector<Color>& colors() const { return colors_; }
  /// Of a face that this motion has cut.
  [[nodiscard]] std::uint16_t of_motion(std::uint32_t motion) const;
  /// Of facts.tools[i].
  [[nodiscard]] Color of_tool(std::size_t i) const { return colors_[3 + i]; }

 private:
  const PartScene& scene_;
  std::vector<Color> colors_;
  std::map<std::uint32_t, std::uint16_t> of_number_;
};

}  // namespace kerf::output::plot
