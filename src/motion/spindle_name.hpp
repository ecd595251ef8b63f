#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace kerf::motion {

/// Which of a machine's spindles: that of the work (of a mill that of the tool), that of driven
/// tools, and the one that takes a turned part over.
enum class SpindleName : std::uint8_t { main, live, sub };

/// In the order of SpindleName, as files and records write them.
inline constexpr std::array<std::string_view, 3> kSpindleNames = {"main", "live", "sub"};
inline constexpr std::size_t kSpindles = kSpindleNames.size();

[[nodiscard]] constexpr std::size_t index(SpindleName name) {
  return static_cast<std::size_t>(name);
}
[[nodiscard]] constexpr std::string_view name_of(SpindleName name) {
  return kSpindleNames[index(name)];
}

}  // namespace kerf::motion
