#include "stock/cutting/cutting_tool.hpp"

namespace kerf::stock {

CuttingTool cutting_tool(const Tool& tool, double touch_mm) {
  return {.tool = tool,
          .body = {.profile = tool.is_insert() ? Profile{} : profile_of(tool),
                   .core_mm = tool.core_mm().value_or(0),
                   .touch_mm = touch_mm,
                   .cuts = tool.kind != ToolKind::probe}};
}

}  // namespace kerf::stock
