#include "face/server/protocol/state_json.hpp"

#include <cmath>

#include "face/server/protocol/diagnostic_json.hpp"
#include "face/server/protocol/language_json.hpp"
#include "machine/dialect/dialect.hpp"
#include "machine/dialect/registry.hpp"
#include "machine/panel/operation_table.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::server {
namespace {

using machine::MachineDefinition;
using machine::Snapshot;

// Vacant variables, and travels without an end, are null.
Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

// Positions are told to a millionth of a millimetre: noise behind that would be sent for nothing.
double told(double value) {
  constexpr double kGrain = 1e6;
  const double rounded = std::round(value * kGrain) / kGrain;
  return std::isfinite(rounded) ? rounded + 0.0 : 0;
}

// As people count: of a diameter twice the way.
Json by_axis(const base::AxisVector& mm, const motion::AxisSetup& axes) {
  const base::AxisVector values = axes.counted(mm);
  Json json = Json::object();
  for (std::size_t i = 0; i < axes.count(); ++i)
    json[std::string(1, axes.axes[i].letter)] = told(values.values[i]);
  return json;
}

Json by_joint(const base::AxisVector& values, const MachineDefinition& definition) {
  Json json = Json::object();
  for (std::size_t i = 0; i < definition.driven.size(); ++i)
    json[definition.driven[i].name] = told(values.values[i]);
  return json;
}

const char* name_of(motion::Spindle::Turning turning) {
  switch (turning) {
    case motion::Spindle::Turning::clockwise: return "clockwise";
    case motion::Spindle::Turning::counterclockwise: return "counterclockwise";
    case motion::Spindle::Turning::stopped: return "stop";
    case motion::Spindle::Turning::oriented: return "oriented";
  }
  return "";
}

const char* name_of(motion::Coolant::State state) {
  switch (state) {
    case motion::Coolant::State::off: return "off";
    case motion::Coolant::State::mist: return "mist";
    case motion::Coolant::State::flood: return "flood";
  }
  return "";
}

Json alarm_json(const std::optional<machine::AlarmText>& alarm) {
  if (!alarm) return nullptr;
  return {{"code", alarm->code},
          {"message", output::printable(alarm->message)},
          {"program", output::printable(alarm->program)},
          {"file", file_label(alarm->file)},
          {"line", alarm->line},
          {"column", alarm->column},
          {"length", alarm->length},
          {"cause", alarm->cause},
          {"remedy", output::printable(alarm->remedy)}};
}

Json stack_json(const std::vector<machine::CallLevel>& stack) {
  Json json = Json::array();
  for (const machine::CallLevel& level : stack)
    json.push_back({{"program", output::printable(level.program)},
                    {"file", file_label(level.file)},
                    {"line", level.line},
                    {"level", level.level}});
  return json;
}

Json hit_json(const std::optional<machine::BreakpointHit>& hit) {
  if (!hit) return nullptr;
  Json json = breakpoint_json(hit->breakpoint);
  if (!hit->breakpoint.variable.empty()) {
    json["written_line"] = hit->written_line;
    json["before"] = number_or_null(hit->before);
    json["after"] = number_or_null(hit->after);
  }
  if (!hit->trouble.empty()) json["trouble"] = output::printable(hit->trouble);
  return json;
}

Json switches_json(const machine::PanelSettings& panel) {
  Json json = Json::object();
  for (std::size_t i = 0; i < machine::kSwitches; ++i) {
    const auto which = static_cast<machine::Switch>(i);
    json[std::string(machine::name_of(which))] = panel[which];
  }
  return json;
}

Json messages_json(const std::vector<std::string>& messages) {
  Json json = Json::array();
  for (const std::string& message : messages) json.push_back(output::printable(message));
  return json;
}

// Lines that a program prints keep their ends.
std::string printed_text(const std::string& printed) {
  std::string text;
  for (std::size_t begin = 0; begin < printed.size();) {
    const std::size_t end = std::min(printed.find('\n', begin), printed.size());
    text += output::printable(printed.substr(begin, end - begin));
    if (end < printed.size()) text += '\n';
    begin = end + 1;
  }
  return text;
}

const char* kind_name(kinematics::Kind kind) {
  switch (kind) {
    case kinematics::Kind::cartesian: return "cartesian";
    case kinematics::Kind::x_theta_z: return "x-theta-z";
    case kinematics::Kind::head_ac: return "head-ac";
    case kinematics::Kind::arm: return "arm";
  }
  return "";
}

Json kinematics_json(const MachineDefinition& definition) {
  const kinematics::Settings& settings = definition.kinematics;
  Json json = {{"kind", kind_name(settings.kind)}};
  switch (settings.kind) {
    case kinematics::Kind::cartesian: break;
    case kinematics::Kind::x_theta_z:
      json["x1"] = settings.x_theta_z.x1_mm;
      json["theta0_deg"] = settings.x_theta_z.theta0_deg;
      json["z0"] = settings.x_theta_z.z0_mm;
      break;
    case kinematics::Kind::head_ac:
      json["r_a"] = settings.head.r_a_mm;
      json["r_c"] = settings.head.r_c_mm;
      break;
    case kinematics::Kind::arm:
      json["upper_arm"] = settings.arm.upper_arm_mm;
      json["forearm"] = settings.arm.forearm_mm;
      json["forearm_absolute"] = settings.arm.forearm_absolute;
      json["elbow"] = settings.arm.elbow_minus ? "minus" : "plus";
      break;
  }
  return json;
}

Json axis_json(const motion::AxisConfig& axis) {
  const bool bounded = axis.travel_min < axis.travel_max;
  const double count = axis.count_per_mm();
  return {{"name", std::string(1, axis.letter)},
          {"rotary", axis.rotary},
          {"diameter", axis.diameter},
          {"min", bounded ? number_or_null(axis.travel_min * count) : Json(nullptr)},
          {"max", bounded ? number_or_null(axis.travel_max * count) : Json(nullptr)},
          {"unit", axis.rotary ? "deg" : "mm"},
          {"program", true}};
}

Json joint_json(const machine::DrivenAxis& joint, const motion::AxisSetup& axes) {
  const bool named = joint.name.size() == 1 && axes.find(joint.name[0]).has_value();
  return {{"name", joint.name},
          {"rotary", joint.rotary},
          {"min", number_or_null(joint.travel_low)},
          {"max", number_or_null(joint.travel_high)},
          {"unit", joint.rotary ? "deg" : "mm"},
          {"program", named}};
}

}  // namespace

Json breakpoint_json(const machine::Breakpoint& breakpoint) {
  if (!breakpoint.variable.empty()) return {{"variable", breakpoint.variable}};
  Json json = {{"file", file_label(breakpoint.file)}, {"line", breakpoint.line}};
  if (!breakpoint.condition.empty()) json["condition"] = breakpoint.condition;
  return json;
}

Json state_json(const Snapshot& s, const MachineDefinition& definition) {
  Json json;
  json["status"] = machine::name_of(s.status);
  json["mode"] = machine::name_of(s.panel.mode);
  json["program"] = output::printable(s.program);
  json["file"] = file_label(s.file);
  json["line"] = s.line;
  json["text"] = output::printable(s.text);
  json["time_s"] = told(s.time_s);
  json["run"] = s.run;
  json["motion"] = s.motion;
  json["motions"] = s.motions;
  json["position"] = {{"machine", by_axis(s.machine.numbers(), definition.axes)},
                      {"work", by_axis(s.work, definition.axes)},
                      {"distance", by_axis(s.distance, definition.axes)}};
  json["joints"] = by_joint(s.joints, definition);
  json["modal"] = s.modal;
  json["feed"] = {{"programmed_mm_min", told(s.feed_programmed_mm_min)},
                  {"actual_mm_min", told(s.feed_actual_mm_min)},
                  {"programmed_mm_rev", told(s.feed_mm_rev)}};
  json["spindle"] = {{"speed_rpm", told(s.spindle_rpm)},
                     {"direction", name_of(s.spindle)},
                     {"surface_m_min", told(s.surface_m_min)},
                     {"limit_rpm", told(s.spindle_limit_rpm)},
                     {"load", nullptr}};
  json["tool"] = s.tool;
  json["tool_offset"] = s.tool_offset;
  json["coolant"] = name_of(s.coolant);
  json["power_percent"] = told(s.power_percent);
  json["beam"] = s.beam;
  json["override"] = {{"feed", s.panel.dials.feed},
                      {"rapid", s.panel.dials.rapid},
                      {"spindle", s.panel.dials.spindle}};
  json["switches"] = switches_json(s.panel);
  json["skip"] = machine::levels_of(s.panel.skip_levels);
  json["alarm"] = alarm_json(s.alarm);
  json["messages"] = messages_json(s.messages);
  json["stack"] = stack_json(s.stack);
  json["variables_revision"] = s.variables_revision;
  json["printed"] = printed_text(s.printed);
  json["waits_for_input"] = s.waits_for_input;
  json["inputs"] = s.inputs;
  json["breakpoint"] = hit_json(s.breakpoint);
  return json;
}

Json definition_json(const MachineDefinition& definition) {
  Json json;
  json["name"] = definition.name;
  json["title"] = output::printable(definition.description);
  json["dialect"] = definition.dialect;
  json["dialects"] = machine::dialect_names();
  json["axes"] = Json::array();
  json["rapid_mm_min"] = Json::object();
  for (const motion::AxisConfig& axis : definition.axes.axes) {
    json["axes"].push_back(axis_json(axis));
    json["rapid_mm_min"][std::string(1, axis.letter)] = axis.rapid_per_min;
  }
  json["joints"] = Json::array();
  for (const machine::DrivenAxis& joint : definition.driven)
    json["joints"].push_back(joint_json(joint, definition.axes));
  json["kinematics"] = kinematics_json(definition);
  json["laser"] = definition.drive.laser.fitted();
  json["lathe"] = definition.turns();
  json["period_s"] = definition.interpolator.period_s;
  json["modal_groups"] = modal_groups_json(definition.dialect, definition.parameters);
  return json;
}

Json variables_json(const machine::VariableListing& listing) {
  const auto scope_name = [](machine::VariableScope scope) {
    switch (scope) {
      case machine::VariableScope::local: return "local";
      case machine::VariableScope::common: return "common";
      case machine::VariableScope::permanent: return "permanent";
      case machine::VariableScope::program: return "program";
    }
    return "";
  };
  Json json = {{"variables", Json::array()}, {"scopes", Json::array()}};
  for (const machine::VariableRow& row : listing.rows) {
    const bool local = row.scope == machine::VariableScope::local;
    Json entry = {{"name", row.name},
                  {"value", number_or_null(row.value)},
                  {"level", local ? Json(row.level) : Json(nullptr)},
                  {"scope", scope_name(row.scope)},
                  {"changed", row.changed}};
    if (!row.label.empty()) entry["title"] = output::printable(row.label);
    json["variables"].push_back(std::move(entry));
  }
  for (const machine::VariableScope scope : listing.scopes)
    json["scopes"].push_back(scope_name(scope));
  json["levels"] = listing.levels;
  return json;
}

}  // namespace kerf::server
