#include "machine/definition/machine_definition.hpp"

#include <algorithm>
#include <cassert>

#include "base/source_file.hpp"
#include "kinematics/make.hpp"
#include "machine/definition/internal/machine_codes_reader.hpp"
#include "machine/definition/internal/machine_keys.hpp"
#include "machine/definition/internal/machine_reader.hpp"
#include "machine/definition/internal/program_axes.hpp"
#include "motion/feed.hpp"

namespace kerf::machine {
namespace {

constexpr std::size_t kLargestFile = 1 << 20;

std::string first_line(std::string_view text) {
  return std::string(text.substr(0, text.find('\n')));
}

/// "name" and what stands behind its dot; the second is empty without one.
struct Path {
  std::string_view head;
  std::string_view rest;
};
Path split_path(std::string_view text) {
  const std::size_t dot = text.find('.');
  if (dot == std::string_view::npos) return {text, {}};
  return {text.substr(0, dot), text.substr(dot + 1)};
}

/// Why not, or nothing when it is done.
template <typename Owner>
std::string change(const Key<Owner>* key, std::string_view text, Owner& owner) {
  if (key == nullptr) return "there is no such key";
  const auto value = value_of(key->takes, text);
  if (!value) return in_words(key->takes) + " is expected";
  key->assign(owner, *value);
  return {};
}

std::string change_axis(MachineDefinition& machine, std::string_view path, std::string_view text) {
  const Path at = split_path(path);
  const auto axis = std::find_if(machine.driven.begin(), machine.driven.end(),
                                 [&](const DrivenAxis& a) { return a.name == at.head; });
  if (axis == machine.driven.end()) return "the machine has no such axis";
  return change(find_axis_key(at.rest), text, *axis);
}

std::string change_spindle(MachineDefinition& machine, std::string_view path,
                           std::string_view text) {
  Path at = split_path(path);
  if (at.rest.empty()) at = {motion::kSpindleNames.front(), path};
  if (at.rest == kSpindlePower) {
    const auto* const name =
        std::find(motion::kSpindleNames.begin(), motion::kSpindleNames.end(), at.head);
    const auto power = value_of(not_negative(), text);
    if (name == motion::kSpindleNames.end()) return "the machine has no such spindle";
    if (!power) return in_words(not_negative()) + " is expected";
    machine.spindle_kw[static_cast<std::size_t>(name - motion::kSpindleNames.begin())] = *power;
    return {};
  }
  auto& spindles = machine.parameters.machine_codes.spindles;
  const auto spindle = std::find_if(spindles.begin(), spindles.end(), [&](const auto& each) {
    return name_of(each.name) == at.head;
  });
  if (spindle == spindles.end()) return "the machine has no such spindle";
  const std::string objection = change(find_spindle_key(at.rest), text, *spindle);
  if (objection.empty() && at.rest == "max_rpm") limit_main_spindle(machine);
  return objection;
}

std::string change_point(MachineDefinition& machine, const PointKey& key, std::string_view text) {
  if (machine.kinematics.kind != kinematics::Kind::cartesian)
    return type_in_words(machine) + " has no such key";
  const auto point = point_of(text);
  if (!point) return "three numbers are expected: X,Y,Z";
  machine.kinematics.tables.*key.point = *point;
  return {};
}

std::string change_gas(MachineDefinition& machine, std::string_view text) {
  if (!is_gas(text)) return std::string(kGasInWords) + " is expected";
  machine.drive.laser.gas = text;
  return {};
}

std::string change_any(MachineDefinition& machine, std::string_view path, std::string_view text) {
  const auto [table, item] = split_path(path);
  if (table == "axis") return change_axis(machine, item, text);
  if (table == "spindle") return change_spindle(machine, item, text);
  if (table == "g_codes") return change_g_code(machine.parameters.machine_codes, item, text);
  if (table == "m_codes") return change_m_codes(machine.parameters.machine_codes, item, text);
  if (const PointKey* const key = find_point_key(table, item))
    return change_point(machine, *key, text);
  if (table == "beam" && item == kBeamGas) return change_gas(machine, text);
  const MachineKey* const key = find_machine_key(table, item);
  if (key != nullptr && !key->belongs_to(machine.kinematics.kind))
    return type_in_words(machine) + " has no such key";
  return change(key, text, machine);
}

}  // namespace

base::Outcome<MachineDefinition> MachineDefinition::parse(std::string_view text,
                                                          const std::string& source) {
  try {
    const toml::table file = toml::parse(text);
    return MachineReader(file, source).read();
  } catch (const toml::parse_error& error) {
    return tl::unexpected(base::Failure{base::Failure::Kind::input,
                                        source + ":" + std::to_string(error.source().begin.line) +
                                            ": " + first_line(error.description())});
  }
}

base::Outcome<void> MachineDefinition::set(std::string_view key, std::string_view value) {
  MachineDefinition changed = *this;
  std::string objection = change_any(changed, key, value);
  if (objection.empty()) objection = drive_objection(changed.drive);
  if (objection.empty()) objection = complete(changed);
  const std::string of_timer = timer_objection(changed.drive);
  if (objection.empty()) objection = of_timer;
  if (!objection.empty()) {
    return tl::unexpected(base::Failure{
        objection == of_timer ? base::Failure::Kind::input : base::Failure::Kind::usage,
        "--machine-set " + std::string(key) + "=" + std::string(value) + ": " + objection});
  }
  *this = std::move(changed);
  return {};
}

base::Outcome<void> MachineDefinition::set_parameter(std::string_view key, std::string_view value) {
  if (auto set = parameters.set(key, value); !set) return set;
  const Path path = split_path(key);
  if (path.rest.size() != 1 || axes.find(path.rest[0])) return {};
  return tl::unexpected(base::Failure{base::Failure::Kind::usage,
                                      "parameter " + std::string(key) + "=" + std::string(value) +
                                          ": the machine has no axis " + std::string(path.rest)});
}

std::unique_ptr<const kinematics::Kinematics> MachineDefinition::make_kinematics() const {
  auto made = kinematics::make_kinematics(kinematics);
  assert(made);
  return std::move(*made);
}

planner::AxisLimits MachineDefinition::joint_limits() const {
  planner::AxisLimits limits;
  for (std::size_t i = 0; i < driven.size(); ++i) {
    limits.velocity.values[i] = driven[i].velocity_per_min / motion::kSecondsPerMinute;
    limits.acceleration.values[i] = driven[i].acceleration;
    limits.jerk.values[i] = driven[i].jerk;
  }
  return limits;
}

std::vector<drive::StepAxis> MachineDefinition::step_axes() const {
  std::vector<drive::StepAxis> motors;
  for (const DrivenAxis& axis : driven) {
    motors.push_back({axis.name, axis.steps_per_unit, axis.most_rate_hz});
  }
  return motors;
}

base::Outcome<MachineDefinition> find_machine(const std::string& name_or_path) {
  for (const BuiltinMachine& machine : builtin_machines()) {
    if (machine.name == name_or_path) return MachineDefinition::parse(machine.toml, name_or_path);
  }
  if (name_or_path.find('.') == std::string::npos && name_or_path.find('/') == std::string::npos) {
    std::string names;
    for (const BuiltinMachine& machine : builtin_machines())
      names += " " + std::string(machine.name);
    return tl::unexpected(base::Failure{
        base::Failure::Kind::usage, "there is no machine " + name_or_path + "; built in:" + names +
                                        "; a machine file ends in .toml"});
  }
  const auto text = base::read_whole(name_or_path, kLargestFile, "a machine file");
  if (!text) return tl::unexpected(text.error());
  return MachineDefinition::parse(*text, name_or_path);
}

}  // namespace kerf::machine
