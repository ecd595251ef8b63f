#pragma once

#include <string>

#include "stock/sheet/sheet.hpp"

namespace kerf::output {

/// A tile of a sheet as a part of a frame (docs/panel-protocol.md, Frames of the part), padded to
/// four bytes. Precondition: something came to it.
[[nodiscard]] std::string sheet_part(const stock::sheet::Sheet& sheet, std::size_t tile);

}  // namespace kerf::output
