#pragma once

#include <cstdint>

namespace kerf::drawing {

/// A pixel as it is stored; all four go from 0 to the same largest value.
struct Sample {
  std::uint32_t red = 0;
  std::uint32_t green = 0;
  std::uint32_t blue = 0;
  std::uint32_t alpha = 0;
};

/// `most` is the largest value, at most 65535. Whole numbers: half is exactly half.
inline std::uint8_t grey_of(const Sample& sample, std::uint32_t most) {
  const std::uint64_t full = most;
  const std::uint64_t colour = std::uint64_t{299} * sample.red + std::uint64_t{587} * sample.green +
                               std::uint64_t{114} * sample.blue;
  const std::uint64_t over_white = colour * sample.alpha + 1000 * full * (full - sample.alpha);
  const std::uint64_t whole = 1000 * full * full;
  return static_cast<std::uint8_t>((2 * 255 * over_white + whole) / (2 * whole));
}

}  // namespace kerf::drawing
