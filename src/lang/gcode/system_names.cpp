#include "lang/gcode/system_names.hpp"

#include <algorithm>
#include <array>

namespace kerf::gcode {
namespace {

// docs/dialect.md §3.1, §3.3
constexpr std::array kNames = {SystemName{"_UI", 1000, 0, 16, true},
                               SystemName{"_UIL", 1032, 0, 4, true},
                               SystemName{"_UO", 1100, 0, 16, true},
                               SystemName{"_UOL", 1132, 0, 4, true},
                               SystemName{"_ALM", 3000},
                               SystemName{"_CLOCK1", 3001},
                               SystemName{"_CLOCK2", 3002},
                               SystemName{"_CNTL1", 3003},
                               SystemName{"_CNTL2", 3004},
                               SystemName{"_MSGSTP", 3006},
                               SystemName{"_MRIMG", 3007},
                               SystemName{"_PRSTR", 3008},
                               SystemName{"_DATE", 3011},
                               SystemName{"_TIME", 3012},
                               SystemName{"_PARTSN", 3901},
                               SystemName{"_PARTST", 3902},
                               SystemName{"_ABSIO", 5001, 1, 20, true},
                               SystemName{"_ABSMT", 5021, 1, 20, true},
                               SystemName{"_ABSOT", 5041, 1, 20, true},
                               SystemName{"_ABSKP", 5061, 1, 20, true},
                               SystemName{"_TOFS", 5081, 1, 20, true}};

}  // namespace

std::optional<SystemName> system_name(std::string_view name) {
  const auto* const found = std::find_if(
      kNames.begin(), kNames.end(), [&](const SystemName& known) { return known.name == name; });
  if (found == kNames.end()) return std::nullopt;
  return *found;
}

}  // namespace kerf::gcode
