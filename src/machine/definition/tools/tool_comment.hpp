#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "base/source_file.hpp"
#include "stock/tool/tool.hpp"

namespace kerf::machine {

/// What a comment of a program says of a tool (stock.md §1.5), without its parentheses. `number` is
/// that of the tool where the comment stands on a line that calls one, else 0:
///
///   T1 D=10. CR=0.5 - ZMIN=-5. - bullnose end mill        also TAPER=118DEG; T names the tool
///   TOOL/MILL,D,c,H,angle                                 diameter, corner radius, the side's
///                                                         angle to the axis; H is no flute length
///   DRILL D6.8, 6.8 drill Ø6.8                            only with a number
///
/// Lengths are in units of `mm_per_unit`. Nothing: it says none that has a shape. The tool's number
/// is 0 where neither names it.
[[nodiscard]] std::optional<stock::Tool> tool_in_comment(std::string_view comment, int number,
                                                         double mm_per_unit);

/// How a program writes.
struct CommentStyle {
  double mm_per_unit = 1;        ///< where the program has neither G20 nor G21
  bool has_offset_in_t = false;  ///< T0101 is tool 1: a lathe
};

/// The tools that the comments of a program describe, each by the first one that does, in the order
/// of the text. The program is read once, in the memory of some lines of it. A comment that names
/// no tool is that of the tool that its line calls, TOOL/MILL else that of the next one called.
[[nodiscard]] std::vector<stock::Tool> tools_in_comments(const base::SourceFile& program,
                                                         const CommentStyle& style);

}  // namespace kerf::machine
