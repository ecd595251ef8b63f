#include "stock/sheet/pieces.hpp"

#include "stock/sheet/internal/piece_finder.hpp"

namespace kerf::stock::sheet {

Pieces pieces_of(const Sheet& sheet) { return PieceFinder(sheet).find(); }

}  // namespace kerf::stock::sheet
