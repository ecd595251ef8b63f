#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace kerf::server {

/// What keeps a text from being a command, seen in one pass without parsing it: brackets within
/// each other to more than kMostDepth, more than kMostValues values, a number or word of more than
/// kMostWordBytes. What passes costs as much to parse as it has bytes. The sentence, or nothing.
namespace json_shape {
inline constexpr int kMostDepth = 8;
inline constexpr std::size_t kMostValues = 20'000;
inline constexpr std::size_t kMostWordBytes = 100;
}  // namespace json_shape

[[nodiscard]] std::optional<std::string> objection_to_shape(std::string_view json);

}  // namespace kerf::server
