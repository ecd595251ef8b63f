#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "stock/cutting/placement.hpp"

namespace kerf::machine {

/// `--stock-place` (docs/set-up.md): X,Y,Z[,A,B,C], mm and degrees. Failure (usage): `option` and
/// what is wrong.
[[nodiscard]] base::Outcome<stock::Placement> stock_place(std::string_view text,
                                                          const std::string& option);
/// The same of its numbers, three or six; nothing where they are not.
[[nodiscard]] std::optional<stock::Placement> placement_of(const std::vector<double>& numbers);

}  // namespace kerf::machine
