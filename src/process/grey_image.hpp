#pragma once

#include <cstdint>
#include <vector>

namespace kerf::process {

/// 0 is black and burns, 255 is white. Rows from the top, each from the left.
struct GreyImage {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> pixels;

  [[nodiscard]] std::uint8_t at(std::uint32_t x, std::uint32_t y) const {
    return pixels[std::size_t{y} * width + x];
  }
};

}  // namespace kerf::process
