#include "control/gcode/codes/code_table.hpp"

namespace kerf::control {
namespace {

constexpr CodeRow kCodes[] = {
#define G(number, meaning, group, letters, words, value, power_on, effect, title, sentence) \
  {number, Meaning::meaning, Group::group, letters, AxisWords::words,                       \
   value,  power_on,         effect,       title,   sentence},
#define M(number, function, moment, title, sentence)
#include "control/gcode/codes/mill_codes.def"
#undef G
#undef M
};

constexpr FunctionRow kFunctions[] = {
#define G(number, meaning, group, letters, words, value, power_on, effect, title, sentence)
#define M(number, function, moment, title, sentence) \
  {number, Function::function, Moment::moment, title, sentence},
#include "control/gcode/codes/mill_codes.def"
#undef G
#undef M
};

constexpr CodeTable kTable(kCodes, kFunctions);

}  // namespace

const CodeTable& mill_codes() { return kTable; }

}  // namespace kerf::control
