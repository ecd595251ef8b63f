#pragma once

#include <cstddef>
#include <cstdint>

namespace kerf::stock {

/// What a piece of a tool does where it meets material.
enum class ToolPart : std::uint8_t {
  edge,    ///< cuts
  flank,   ///< above the flutes, not wider than the edges below it: FLUTE_LENGTH
  shank,   ///< neck or shank, wider than the edges below it: SHANK_COLLISION
  holder,  ///< HOLDER_COLLISION
};
inline constexpr std::size_t kToolParts = 4;

[[nodiscard]] constexpr std::size_t index(ToolPart part) { return static_cast<std::size_t>(part); }

}  // namespace kerf::stock
