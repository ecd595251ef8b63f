#pragma once

#include <string>
#include <vector>

#include "stock/tool/tool.hpp"

namespace kerf::machine {

/// What a run shows of a tool, for where nobody describes it.
struct ToolUse {
  bool turns = false;                 ///< on a lathe, by a tool that stands still
  bool cuts_only_along_axis = false;  ///< all its cutting moves go along its own axis
  double offset_radius_mm = 0;        ///< radius geometry of the offset of its own number
  double offset_nose_mm = 0;          ///< of a lathe: nose radius geometry of that offset
  int offset_tip = 0;                 ///< and its direction, 0 to 9
};

/// The tool that a number stands for, its source in it, and what nobody has said but the run goes
/// by: a sentence each, without a full stop.
struct ChosenTool {
  stock::Tool tool;
  std::vector<std::string> assumed;
};

/// Who describes a tool counts in the order of stock::ToolSource, tool by tool (stock.md §1.5): a
/// file, the machine, the program's comments, the offset memory, the assumption. A description
/// without a shape leaves that to the next one; its length and its name count all the same.
class ToolChoice {
 public:
  ToolChoice() = default;
  /// Descriptions of any sources in any order; of one source the first one of a number counts.
  explicit ToolChoice(std::vector<stock::Tool> tools);

  /// Always one that has a shape: stock::objection() is empty.
  [[nodiscard]] ChosenTool choose(int number, const ToolUse& use) const;

 private:
  std::vector<stock::Tool> tools_;
};

}  // namespace kerf::machine
