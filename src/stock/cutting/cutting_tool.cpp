#include "stock/cutting/cutting_tool.hpp"

#include <utility>

namespace kerf::stock {

CuttingTool cutting_tool(const Tool& tool, double touch_mm) {
  Body body;
  body.core_mm = tool.core_mm().value_or(0);
  body.touch_mm = touch_mm;
  body.cuts = tool.kind != ToolKind::probe;
  if (tool.is_insert()) {
    body.insert = insert_of(tool);
  } else {
    body.profile = profile_of(tool);
  }
  return {.tool = tool, .body = std::move(body)};
}

}  // namespace kerf::stock
