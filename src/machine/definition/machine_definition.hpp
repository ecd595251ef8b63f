#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "control/core/parameters.hpp"
#include "kinematics/kinematics.hpp"
#include "kinematics/settings.hpp"
#include "machine/definition/drive_settings.hpp"
#include "machine/definition/driven_axis.hpp"
#include "machine/definition/pattern_settings.hpp"
#include "machine/definition/tip_rates.hpp"
#include "motion/axis_setup.hpp"
#include "motion/spindle_name.hpp"
#include "planner/settings.hpp"
#include "stock/tool/tool.hpp"

namespace kerf::machine {

/// Languages that programs are written in. Kerf reads the first one; the others have their names.
inline constexpr std::array<std::string_view, 6> kDialects = {
    "fanuc-mill", "fanuc-lathe", "laser-basic", "teach", "motion", "pattern"};

/// The one of lathes.
inline constexpr std::string_view kLatheDialect = kDialects[1];

/// A machine as its TOML file describes it (docs/machine-file.md).
///
/// The file names the driven axes, the joints of the linkage. The program's axes are the same ones
/// where the linkage is Cartesian or an A/C head. On the others they are those of the tip, X Y Z
/// and, on an arm, C: then X and Y have the rates of `tip`, the others those of the joint that
/// moves them alone, and their reference points are where the tip is while the joints stand at
/// theirs. A stroke of the program's axes is that of driven axes which are the same thing.
///
/// At power-on every axis stands at 0: the program's where it names the driven ones, else the
/// driven ones.
struct MachineDefinition {
  std::string name;
  std::string description;
  std::string dialect;                ///< one of kDialects
  std::string linkage = "cartesian";  ///< the file's word for kinematics.kind
  std::vector<DrivenAxis> driven;     ///< 1 to kMaxAxes, in the order of the file
  TipRates tip;
  kinematics::Settings kinematics;  ///< its joints follow from `driven`
  planner::Settings interpolator;
  DriveSettings drive;
  PatternSettings pattern;
  motion::AxisSetup axes;  ///< the program's; they follow from the others
  base::JointPoint start;  ///< of the driven axes at power-on, where `axes` have theirs
  control::Parameters parameters;
  std::array<double, motion::kSpindles> spindle_kw{};  ///< of each spindle; 0: not known
  std::vector<stock::Tool> tools;  ///< of its [[tool]] tables, in the order of the file

  /// Reads a definition. Failure (input): what is wrong, with the line; every unknown key is wrong.
  [[nodiscard]] static base::Outcome<MachineDefinition> parse(std::string_view toml,
                                                              const std::string& source);

  /// `--machine-set`: changes axis.NAME.KEY, spindle.NAME.KEY or TABLE.KEY, any number or word of
  /// the tables axis, spindle, m_codes, g_codes, tip, kinematics, interpolator, drive, beam,
  /// pattern (docs/machine-file.md) but what makes another machine of it. Failure (usage; input: of
  /// a timer that no machine has at its laser): then nothing has changed.
  [[nodiscard]] base::Outcome<void> set(std::string_view key, std::string_view value);

  /// `--param`, `[control]`: changes a parameter of the control (control::Parameters::set()).
  /// Failure (usage): also for an axis that the machine lacks.
  [[nodiscard]] base::Outcome<void> set_parameter(std::string_view key, std::string_view value);

  /// Never null: neither parse() nor set() lets a linkage pass that cannot be made. Joints of a
  /// Cartesian machine have no range here: there the control compares strokes (`stroke_check`),
  /// which counts the tool's length.
  [[nodiscard]] std::unique_ptr<const kinematics::Kinematics> make_kinematics() const;

  /// Its tools are those of a lathe: its tool offsets are control::Memory::turning.
  [[nodiscard]] bool turns() const { return dialect == "fanuc-lathe"; }

  [[nodiscard]] planner::AxisLimits joint_limits() const;
  [[nodiscard]] std::vector<drive::StepAxis> step_axes() const;
};

/// A machine that comes with Kerf.
struct BuiltinMachine {
  std::string_view name;
  std::string_view toml;
};
[[nodiscard]] const std::vector<BuiltinMachine>& builtin_machines();

/// The built-in machine of this name, or the machine file at this path. Failure (usage): no machine
/// has this name; (input): the file cannot be read or is wrong.
[[nodiscard]] base::Outcome<MachineDefinition> find_machine(const std::string& name_or_path);

}  // namespace kerf::machine
