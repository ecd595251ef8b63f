#pragma once

#include <memory>

#include "stock/replay/tiles.hpp"
#include "stock/sheet/sheet.hpp"

namespace kerf::stock::replay {

// What cuts and what burns leave of a sheet has nothing to do with each other, and is kept apart.
// The sheet outlives the tiles.

[[nodiscard]] std::unique_ptr<Tiles> coverage_tiles(sheet::Sheet& sheet);
[[nodiscard]] std::unique_ptr<Tiles> energy_tiles(sheet::Sheet& sheet);

}  // namespace kerf::stock::replay
