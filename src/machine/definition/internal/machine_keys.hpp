#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "machine/definition/internal/takes.hpp"
#include "machine/definition/machine_definition.hpp"

namespace kerf::machine {

/// A key that takes a number or a word, and what it changes in its owner.
template <typename Owner>
struct Key {
  std::string_view table;
  std::string_view name;
  Takes takes;
  void (*assign)(Owner&, double);
  bool (*belongs_to)(kinematics::Kind) = [](kinematics::Kind) { return true; };
};
using MachineKey = Key<MachineDefinition>;
using AxisKey = Key<DrivenAxis>;
using SpindleKey = Key<control::SpindleSettings>;

/// kW that a spindle can give: of MachineDefinition, not of the control.
inline constexpr std::string_view kSpindlePower = "power_kw";

/// A key that takes the three coordinates of a point, and where they go.
struct PointKey {
  std::string_view table;
  std::string_view name;
  std::array<double, 3> kinematics::TablePoints::*point;
};

/// Null when there is no such key. Those of tables that hold more than such keys (the names of
/// axes, the type of the kinematics) are not among them.
[[nodiscard]] const MachineKey* find_machine_key(std::string_view table, std::string_view name);
[[nodiscard]] const PointKey* find_point_key(std::string_view table, std::string_view name);
/// "0,25,-380"; nothing where it is not three numbers.
[[nodiscard]] std::optional<std::array<double, 3>> point_of(std::string_view text);
[[nodiscard]] const AxisKey* find_axis_key(std::string_view name);
[[nodiscard]] const SpindleKey* find_spindle_key(std::string_view name);

/// The limit of the main spindle becomes that of the control, where the file says one.
void limit_main_spindle(MachineDefinition& machine);

/// What is wrong with keys that must fit each other, a sentence, or nothing.
[[nodiscard]] std::string drive_objection(const DriveSettings& drive);

/// What is wrong with the laser's timer, a sentence, or nothing.
[[nodiscard]] std::string timer_objection(const DriveSettings& drive);

/// beam.gas, which takes a text of characters that show.
inline constexpr std::string_view kBeamGas = "gas";
inline constexpr std::string_view kGasInWords = "a name of 1 to 60 characters";
[[nodiscard]] bool is_gas(std::string_view text);

/// For a sentence: "a machine of the type arm".
[[nodiscard]] std::string type_in_words(const MachineDefinition& machine);

}  // namespace kerf::machine
