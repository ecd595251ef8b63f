#include "control/gcode/codes/lathe_codes.hpp"

#include <algorithm>
#include <array>

namespace kerf::control {
namespace {

constexpr int kSystems = 3;  // A, B, C
constexpr int kNone = -1;

struct LatheRow {
  std::array<int, kSystems> numbers;  // kNone: the system lacks it
  CodeRow row;                        // but for its number
};

constexpr LatheRow kRows[] = {
#define G(a, b, c, meaning, group, letters, words, value, power_on, effect, title, sentence)      \
  {{a, b, c},                                                                                     \
   {0, Meaning::meaning, Group::group, letters, AxisWords::words, value, power_on, effect, title, \
    sentence}},
#define ALSO_G G
#define M(...)
#define ALSO_M(...)
#include "control/gcode/codes/lathe_codes.def"
#undef G
#undef ALSO_G
#undef M
#undef ALSO_M
};

constexpr FunctionRow kLatheFunctions[] = {
#define G(...)
#define ALSO_G(...)
#define M(number, function, moment, title, sentence) \
  {number, Function::function, Moment::moment, title, sentence},
#define ALSO_M M
#include "control/gcode/codes/lathe_codes.def"
#undef G
#undef ALSO_G
#undef M
#undef ALSO_M
};

template <int kSystem>
constexpr std::size_t count() {
  std::size_t rows = 0;
  for (const LatheRow& row : kRows) rows += row.numbers[kSystem] == kNone ? 0U : 1U;
  return rows;
}

template <int kSystem>
constexpr auto codes_of() {
  std::array<CodeRow, count<kSystem>()> codes;
  std::size_t next = 0;
  for (const LatheRow& each : kRows) {
    if (each.numbers[kSystem] == kNone) continue;
    codes[next] = each.row;
    codes[next++].number = static_cast<GCode>(each.numbers[kSystem]);
  }
  std::sort(codes.begin(), codes.end(),
            [](const CodeRow& a, const CodeRow& b) { return a.number < b.number; });
  return codes;
}

constexpr auto kCodesA = codes_of<0>();
constexpr auto kCodesB = codes_of<1>();
constexpr auto kCodesC = codes_of<2>();

// The groups of the T system by the number behind #40.
constexpr std::array kNumbers = {Group::one_shot,      Group::motion,
                                 Group::speed,         Group::distance,
                                 Group::turrets,       Group::feed,
                                 Group::unit,          Group::compensation,
                                 Group::spindle_watch, Group::stroke,
                                 Group::cycle,         Group::cycle_return,
                                 Group::modal_call,    Group::none,
                                 Group::work,          Group::stop_mode,
                                 Group::plane,         Group::none,
                                 Group::none,          Group::none,
                                 Group::none,          Group::polar_interpolation};

constexpr Habits kHabitsA{
    .letters_are_increments = true, .tool_brings_offset = true, .drawing_dimensions = true};
constexpr Habits kHabitsBC{.tool_brings_offset = true, .drawing_dimensions = true};

constexpr CodeTable kTableA(kCodesA, kLatheFunctions, kNumbers, kHabitsA);
constexpr CodeTable kTableB(kCodesB, kLatheFunctions, kNumbers, kHabitsBC);
constexpr CodeTable kTableC(kCodesC, kLatheFunctions, kNumbers, kHabitsBC);

}  // namespace

const CodeTable& lathe_codes(char system) {
  switch (system) {
    case 'B': return kTableB;
    case 'C': return kTableC;
    default: return kTableA;
  }
}

}  // namespace kerf::control
