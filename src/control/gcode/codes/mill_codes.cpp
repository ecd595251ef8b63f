#include "control/gcode/codes/code_table.hpp"
#include "lang/gcode/call_codes.hpp"

namespace kerf::control {
namespace {

constexpr CodeRow kCodes[] = {
#define G(number, meaning, group, letters, words, value, power_on, effect, title, sentence) \
  {number, Meaning::meaning, Group::group, letters, AxisWords::words,                       \
   value,  power_on,         effect,       title,   sentence},
#define ALSO_G G
#define M(...)
#define ALSO_M M
#include "control/gcode/codes/mill_codes.def"
#undef G
#undef ALSO_G
#undef M
#undef ALSO_M
};

constexpr FunctionRow kFunctions[] = {
#define G(...)
#define ALSO_G G
#define M(number, function, moment, title, sentence) \
  {number, Function::function, Moment::moment, title, sentence},
#define ALSO_M M
#include "control/gcode/codes/mill_codes.def"
#undef G
#undef ALSO_G
#undef M
#undef ALSO_M
};

constexpr Meaning meaning_of(double code) {
  for (const CodeRow& row : kCodes) {
    if (row.number == code * 10) return row.meaning;
  }
  return Meaning::none;
}

// The language reads the words behind these as arguments.
static_assert(meaning_of(gcode::kMacroCall) == Meaning::macro_call);
static_assert(meaning_of(gcode::kModalCall) == Meaning::modal_call);
static_assert(meaning_of(gcode::kModalCallEveryBlock) == Meaning::modal_call_every_block);
static_assert(meaning_of(gcode::kModalCallOff) == Meaning::modal_call_off);

constexpr CodeTable kTable(kCodes, kFunctions);

}  // namespace

const CodeTable& mill_codes() { return kTable; }

}  // namespace kerf::control
