#pragma once

#include <memory>
#include <vector>

#include "control/core/memory.hpp"
#include "stock/cutting/cutting_tool.hpp"

namespace kerf::job {

/// The tools of a run by number, each from the first that knows its shape (stock.md §1.5): `tools`
/// in their order, the radius in the offset memory, a flat end mill of 6 mm. The memory must
/// outlive the rack.
[[nodiscard]] std::unique_ptr<stock::ToolRack> make_rack(std::vector<stock::Tool> tools,
                                                         const control::Memory& memory);

}  // namespace kerf::job
