#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace kerf::stock::saved {

inline constexpr std::string_view kMagic = "KSTOCK1\n";
/// What files of any version begin with; a digit or more and the end of the line follow.
inline constexpr std::string_view kFamily = "KSTOCK";

inline constexpr std::size_t kLargestHead = 1 << 20;  ///< bytes of JSON
inline constexpr std::size_t kMostPrograms = 100;     ///< that are named
inline constexpr double kFarthest_mm = 1e6;           ///< of any coordinate
inline constexpr int kMostCellsAlong = 1 << 26;
inline constexpr std::uint32_t kNoTile = 0xffff'ffff;  ///< ends the tiles of a sheet

}  // namespace kerf::stock::saved
