#include "control/gcode/acts/data_setting.hpp"

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"

namespace kerf::control {
namespace {

using base::Axis;
using base::AxisSet;
using base::AxisVector;
using base::Code;

constexpr double kMostToolOffset = 9999.999;    // mm
constexpr std::int64_t kFirstGeometry = 10000;  // P of a lathe's G10: wear up to here

// What the L of a tool offset names in each memory: 0 geometry length, 1 wear length, 2 geometry
// radius, 3 wear radius; -1: no such L.
int tool_part(char memory, std::int64_t l) {
  if (memory == 'A') return l == 11 || l == 1 ? 0 : -1;
  if (memory == 'B') return l == 10 ? 0 : l == 11 || l == 1 ? 1 : -1;
  if (l < 10 || l > 13) return l == 1 ? 1 : -1;
  return static_cast<int>(l - 10);
}

}  // namespace

bool DataSetting::execute(const Words& words) {
  std::int64_t l = 0;
  if (!words.has('L') && state_.codes.habits().tool_brings_offset) return set_turning_offset(words);
  if (!words.has('L')) return state_.alarms.raise(Code::g10_format, "L is missing");
  if (!state_.values.integer(words['L'], 0, 99999999, l)) return false;
  if (l == 2 || l == 20) return set_work_offset(words);
  if (l == 50 || l == 52) {
    state_.parameter_entry = true;
    return true;
  }
  if (tool_part(state_.parameters.offset_memory, l) < 0) {
    return state_.alarms.raise(Code::g10_format, words['L'].text,
                               "this L does not exist with offset memory " +
                                   std::string(1, state_.parameters.offset_memory));
  }
  return set_tool_offset(words, l);
}

bool DataSetting::set_work_offset(const Words& words) {
  std::int64_t p = 0;
  if (!words.has('P')) return state_.alarms.raise(Code::g10_format, "P is missing");
  if (!state_.values.integer(words['P'], 0, 99999999, p)) return false;
  const bool extended = base::round_away(words['L'].value) == 20;
  const auto most = static_cast<std::int64_t>(extended ? kExtendedSystems : kWorkSystems);
  if (p < (extended ? 1 : 0) || p > most) {
    return state_.alarms.raise(Code::g10_format, words['P'].text,
                               "there is no such work coordinate system");
  }
  AxisVector values;
  AxisSet named = 0;
  if (!targets_.values(words, values, named)) return false;
  AxisVector& target = extended ? state_.memory.extended[static_cast<std::size_t>(p - 1)]
                       : p == 0 ? state_.memory.external
                                : state_.memory.work[static_cast<std::size_t>(p - 1)];
  for (std::size_t i = 0; i < state_.axes.count(); ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    if (!base::contains(named, axis)) continue;
    const double value = values[axis] * state_.axes[axis].count_per_mm();
    target[axis] = state_.modal.incremental() ? base::tidy(target[axis] + value) : value;
  }
  ++state_.memory.revision;
  state_.coordinates.offsets_changed();
  return true;
}

bool DataSetting::set_tool_offset(const Words& words, std::int64_t l) {
  std::int64_t p = 0;
  double value = 0;
  if (!words.has('P') || !words.has('R')) {
    return state_.alarms.raise(Code::g10_format, words.has('P') ? "R is missing" : "P is missing");
  }
  if (!state_.values.integer(words['P'], 0, 99999999, p) ||
      !state_.values.length(words['R'], value))
    return false;
  if (p < 1 || p > state_.parameters.n_offsets) {
    return state_.alarms.raise(
        Code::illegal_offset_number, words['P'].text,
        "the control has " + std::to_string(state_.parameters.n_offsets) + " offsets");
  }
  ToolOffset& tool = state_.memory.tools[static_cast<std::size_t>(p)];
  double* const parts[] = {&tool.length_geometry, &tool.length_wear, &tool.radius_geometry,
                           &tool.radius_wear};
  double& part = *parts[tool_part(state_.parameters.offset_memory, l)];
  if (state_.modal.incremental()) value = base::tidy(part + value);
  if (value > kMostToolOffset || value < -kMostToolOffset) {
    return state_.alarms.raise(Code::offset_too_large, words['R'].text);
  }
  part = value;
  ++state_.memory.revision;
  return true;
}

// A part of an offset: the first letter is its new value, the second one what is added to it.
bool DataSetting::set_part(const Words& words, char letter, char increment, double& part) {
  for (const char name : {letter, increment}) {
    if (name == 0 || !words.has(name)) continue;
    double value = 0;
    if (!state_.values.length(words[name], value)) return false;
    if (name == increment) value = base::tidy(part + value);
    if (value > kMostToolOffset || value < -kMostToolOffset)
      return state_.alarms.raise(Code::offset_too_large, words[name].text);
    part = value;
  }
  return true;
}

// G10 P of a lathe: wear, from 10001 on geometry; R is the nose, Q the direction of the tip.
bool DataSetting::set_turning_offset(const Words& words) {
  std::int64_t p = 0;
  if (!words.has('P')) return state_.alarms.raise(Code::g10_format, "P is missing");
  if (!state_.values.integer(words['P'], 0, 99999999, p)) return false;
  if (p == 0) return set_work_shift(words);
  const bool geometry = p > kFirstGeometry;
  const std::int64_t number = geometry ? p - kFirstGeometry : p;
  if (number > state_.parameters.n_offsets) {
    return state_.alarms.raise(
        Code::illegal_offset_number, words['P'].text,
        "the control has " + std::to_string(state_.parameters.n_offsets) + " offsets");
  }
  TurningOffset& row = state_.memory.turning[static_cast<std::size_t>(number)];
  TurningOffset changed = row;
  TurningOffset::Part& part = geometry ? changed.geometry : changed.wear;
  std::int64_t tip = static_cast<std::int64_t>(row.tip);
  if (words.has('Q') && !state_.values.integer(words['Q'], 0, 9, tip)) return false;
  changed.tip = static_cast<double>(tip);
  if (!set_part(words, 'X', 'U', part.x) || !set_part(words, 'Y', 'V', part.y) ||
      !set_part(words, 'Z', 'W', part.z) || !set_part(words, 'R', 'C', part.radius))
    return false;
  row = changed;
  ++state_.memory.revision;
  return true;
}

// G10 P0: EXT, as the operator enters it.
bool DataSetting::set_work_shift(const Words& words) {
  base::AxisVector shift = state_.memory.external;
  constexpr std::pair<char, char> kLetters[] = {{'X', 'U'}, {'Y', 'V'}, {'Z', 'W'}, {'C', 'H'}};
  for (const auto& [letter, increment] : kLetters) {
    const auto axis = state_.axes.find(letter);
    if (axis && !set_part(words, letter, increment, shift[*axis])) return false;
  }
  state_.memory.external = shift;
  ++state_.memory.revision;
  state_.coordinates.offsets_changed();
  return true;
}

// A parameter of eight bits: R is their pattern, bit 7 first.
bool DataSetting::enter_bits(const gcode::Word& word, std::uint32_t number) {
  const auto key = [&](int bit) { return std::to_string(number) + "#" + std::to_string(bit); };
  std::int64_t pattern = -1;
  for (int bit = 0; bit < 8; ++bit) {
    if (!Parameters::is_key(key(bit))) continue;
    if (pattern < 0 && !state_.values.integer(word, 0, 11111111, pattern)) return false;
    std::int64_t digits = pattern;
    for (int i = 0; i < bit; ++i) digits /= 10;
    const auto set = state_.parameters.set(key(bit), std::to_string(digits % 10));
    if (!set) return state_.alarms.raise(Code::parameter_entry, word.text, set.error().message);
  }
  if (pattern < 0) {
    state_.assume(Assumed::parameter_entry,
                  "parameter entry by G10 L50: Kerf does not have this parameter");
  }
  return true;
}

// P counts the axes: 1 is the first.
bool DataSetting::name_axis(const Words& words, std::string& key) {
  std::int64_t p = 0;
  if (!words.has('P'))
    return state_.alarms.raise(Code::parameter_entry,
                               "parameter " + key + " belongs to an axis: P is missing");
  if (!state_.values.integer(words['P'], 0, 99999999, p)) return false;
  if (p < 1 || p > static_cast<std::int64_t>(state_.axes.count()))
    return state_.alarms.raise(Code::parameter_entry, words['P'].text,
                               "the machine has " + std::to_string(state_.axes.count()) + " axes");
  key += std::string(".") + state_.axes[Axis{static_cast<std::uint8_t>(p - 1)}].letter;
  return true;
}

bool DataSetting::enter_parameter(const Words& words, std::uint32_t number) {
  double value = 0;
  if (number == 0 || !words.has('R')) {
    return state_.alarms.raise(Code::parameter_entry, "parameter entry needs N and R");
  }
  if (!state_.values.plain(words['R'], value)) return false;
  std::string key = std::to_string(number);
  if (Parameters::belongs_to_axis(key)) {
    if (!name_axis(words, key)) return false;
    return set_parameter(words['R'], key, value);
  }
  if (words.has('P')) {
    state_.assume(Assumed::parameter_of_axis,
                  "parameter entry by G10 L50: no axis or spindle has a parameter of its own "
                  "with this number, P is ignored");
  }
  if (!Parameters::is_key(key)) return enter_bits(words['R'], number);
  return set_parameter(words['R'], key, value);
}

bool DataSetting::set_parameter(const gcode::Word& word, const std::string& key, double value) {
  const auto set = state_.parameters.set(key, base::number_text(value));
  return set || state_.alarms.raise(Code::parameter_entry, word.text, set.error().message);
}

}  // namespace kerf::control
