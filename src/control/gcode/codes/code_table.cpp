#include "control/gcode/codes/code_table.hpp"

#include <algorithm>
#include <cassert>

namespace kerf::control {

const CodeRow* CodeTable::search(GCode number) const {
  const auto found = std::find_if(codes_.begin(), codes_.end(),
                                  [&](const CodeRow& row) { return row.number == number; });
  return found == codes_.end() ? nullptr : &*found;
}

Group CodeTable::group_of(std::size_t number) const {
  if (!numbers_.empty()) return number < numbers_.size() ? numbers_[number] : Group::none;
  return number < kGroups ? static_cast<Group>(number) : Group::none;
}

const CodeRow& CodeTable::with(Meaning meaning) const {
  const auto found = std::find_if(codes_.begin(), codes_.end(),
                                  [&](const CodeRow& row) { return row.meaning == meaning; });
  assert(found != codes_.end());
  return *found;
}

const FunctionRow* CodeTable::find_function(std::int64_t number) const {
  const auto found = std::find_if(functions_.begin(), functions_.end(),
                                  [&](const FunctionRow& row) { return row.number == number; });
  return found == functions_.end() ? nullptr : &*found;
}

const FunctionRow* CodeTable::with(Function function) const {
  const auto found = std::find_if(functions_.begin(), functions_.end(),
                                  [=](const FunctionRow& row) { return row.function == function; });
  return found == functions_.end() ? nullptr : &*found;
}

std::string name_of(GCode code) {
  const std::string number = std::to_string(code / 10);
  const std::string name = (number.size() < 2 ? "G0" : "G") + number;
  return code % 10 == 0 ? name : name + "." + std::to_string(code % 10);
}

}  // namespace kerf::control
