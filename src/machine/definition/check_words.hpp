#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/diagnostic_code.hpp"
#include "base/result.hpp"
#include "stock/cutting/cutting_force.hpp"

namespace kerf::machine {

// Words of checks and materials, as command lines and files of set-ups have them. Failure (usage):
// the option and what is wrong.

/// `--material`: a group (P, M, K, N, S, H), or kc11,mc.
[[nodiscard]] base::Outcome<stock::CutMaterial> cut_material(const std::string& text,
                                                             const std::string& option);
/// `--no-check`: the code of a check of stock.
[[nodiscard]] base::Outcome<base::Code> stock_check(const std::string& text,
                                                    const std::string& option);

/// Which findings make a run fail (`--fail-on`).
enum class FailOn : std::uint8_t { warning, error, never };
/// error, warning or never.
[[nodiscard]] base::Outcome<FailOn> fail_on(std::string_view text, const std::string& option);

}  // namespace kerf::machine
