#include "drawing/units.hpp"

#include <array>
#include <utility>

namespace kerf::drawing {

std::optional<double> mm_of_unit(std::string_view unit, double dpi) {
  constexpr std::array<std::pair<std::string_view, double>, 9> kUnits{{{"mm", 1},
                                                                       {"cm", 10},
                                                                       {"m", 1000},
                                                                       {"in", kMmAnInch},
                                                                       {"ft", 12 * kMmAnInch},
                                                                       {"pt", kMmAnInch / 72},
                                                                       {"pc", kMmAnInch / 6},
                                                                       {"um", 0.001},
                                                                       {"q", 0.25}}};
  if (unit == "px") return kMmAnInch / dpi;
  for (const auto& [name, mm] : kUnits)
    if (name == unit) return mm;
  return std::nullopt;
}

}  // namespace kerf::drawing
