#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace kerf::machine {

/// Far beyond every machine; more is a slip of the pen.
inline constexpr double kFarthest_mm = 100'000;

/// Between `least` and `most` numbers with commas between them, none of them beyond kFarthest_mm;
/// nothing where they are not.
[[nodiscard]] std::optional<std::vector<double>> numbers_in(std::string_view list,
                                                            std::size_t least, std::size_t most);

}  // namespace kerf::machine
