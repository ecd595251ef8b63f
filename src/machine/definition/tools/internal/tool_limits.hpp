#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "stock/tool/tool.hpp"

namespace kerf::machine {

/// A key of `limits`.
struct LimitKey {
  std::string_view name;
  std::optional<double> stock::ToolLimits::*of;
};
inline constexpr std::array<LimitKey, 5> kLimitKeys = {
    {{"fz", &stock::ToolLimits::fz},
     {"ap", &stock::ToolLimits::ap},
     {"ae", &stock::ToolLimits::ae},
     {"vc", &stock::ToolLimits::vc},
     {"ramp_deg", &stock::ToolLimits::ramp_deg}}};

}  // namespace kerf::machine
