#include "machine/definition/internal/machine_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "kinematics/make.hpp"
#include "machine/definition/internal/machine_codes_reader.hpp"
#include "machine/definition/internal/program_axes.hpp"
#include "machine/definition/internal/toml_value.hpp"
#include "machine/definition/tools/tool_tables.hpp"

namespace kerf::machine {
namespace {

constexpr std::array<std::string_view, 16> kTables = {
    "name",  "description", "dialect", "axis",         "spindle", "tip",  "kinematics", "pattern",
    "drive", "m_codes",     "g_codes", "interpolator", "control", "tool", "holder",     "beam"};
constexpr std::array<std::string_view, 6> kTablesOfKeys = {"kinematics", "tip",     "interpolator",
                                                           "drive",      "pattern", "beam"};
constexpr std::array<std::string_view, 3> kJointNames = {"T1", "T2", "T3"};

template <std::size_t N>
bool is_one_of(std::string_view word, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_letter(std::string_view name) {
  return name.size() == 1 && std::string_view("XYZABCUVW").find(name) != std::string_view::npos;
}

}  // namespace

tl::unexpected<base::Failure> MachineReader::wrong(const toml::node* node,
                                                   const std::string& what) const {
  return wrong_at(source_, node, what);
}

base::Outcome<MachineDefinition> MachineReader::read() {
  using Step = Outcome (MachineReader::*)();
  constexpr std::array<Step, 8> kSteps = {
      &MachineReader::read_head,    &MachineReader::read_linkage, &MachineReader::read_axes,
      &MachineReader::read_codes,   &MachineReader::read_tables,  &MachineReader::finish,
      &MachineReader::read_control, &MachineReader::read_tools};
  for (const Step step : kSteps) {
    if (auto done = (this->*step)(); !done) return tl::unexpected(done.error());
  }
  return std::move(machine_);
}

MachineReader::Outcome MachineReader::read_head() {
  for (const auto& [key, node] : file_) {
    if (!is_one_of(key.str(), kTables))
      return wrong(&node, "a machine has no key " + std::string(key.str()));
  }
  machine_.name = file_["name"].value_or(std::string());
  if (machine_.name.empty()) return wrong(nullptr, "a machine needs a name");
  machine_.description = file_["description"].value_or(std::string());
  machine_.dialect = kDialects[0];
  const toml::node* const dialect = file_.get("dialect");
  if (dialect == nullptr) return {};
  const auto word = dialect->value<std::string>();
  if (!word || !is_one_of(*word, kDialects))
    return wrong(dialect, "there is no dialect " + word.value_or("of this kind"));
  machine_.dialect = *word;
  return {};
}

// The type comes first: it says which names axes may have, and which keys there are.
MachineReader::Outcome MachineReader::read_linkage() {
  const toml::table* const table = file_["kinematics"].as_table();
  const toml::node* const type = table != nullptr ? table->get("type") : nullptr;
  if (type == nullptr) return {};
  const auto word = type->value<std::string>();
  const auto kind = word ? kinematics::kind_named(*word) : std::nullopt;
  if (!kind) return wrong(type, "there is no kinematics " + word.value_or("of this type"));
  machine_.linkage = *word;
  machine_.kinematics.kind = *kind;
  return {};
}

// The file says places as programs do.
void MachineReader::halve_places(DrivenAxis& axis) {
  axis.travel_low /= 2;
  axis.travel_high /= 2;
  for (double& place : axis.reference) place /= 2;
}

MachineReader::Outcome MachineReader::read_axes() {
  const toml::array* const axes = file_["axis"].as_array();
  if (axes == nullptr || axes->empty() || axes->size() > base::kMaxAxes) {
    return wrong(file_.get("axis"),
                 "a machine has 1 to " + std::to_string(base::kMaxAxes) + " [[axis]] tables");
  }
  for (const toml::node& node : *axes) {
    if (!node.is_table()) return wrong(&node, "axis must be a table");
    if (auto r = read_axis(*node.as_table()); !r) return r;
  }
  return {};
}

MachineReader::Outcome MachineReader::read_axis(const toml::table& table) {
  DrivenAxis axis;
  if (auto r = read_name(table, axis); !r) return r;
  for (const auto& [key, node] : table) {
    if (auto r = read_axis_item(std::string(key.str()), node, axis); !r) return r;
  }
  if (table.get("velocity") == nullptr) return wrong(&table, "an axis needs its velocity");
  if (axis.diameter) {
    if (axis.rotary) return wrong(&table, "an angle has no diameter");
    halve_places(axis);
  }
  machine_.driven.push_back(std::move(axis));
  return {};
}

MachineReader::Outcome MachineReader::read_name(const toml::table& table, DrivenAxis& axis) const {
  axis.name = table["name"].value_or(std::string());
  const bool joint = has_own_tip(machine_.kinematics.kind) && is_one_of(axis.name, kJointNames);
  if (!is_letter(axis.name) && !joint) {
    return wrong(&table,
                 "an axis needs a name: one of X Y Z A B C U V W, or on linkages of the "
                 "type arm or x-theta-z one of T1 T2 T3");
  }
  for (const DrivenAxis& other : machine_.driven) {
    if (other.name == axis.name) return wrong(&table, "axis " + axis.name + " stands twice");
  }
  return {};
}

MachineReader::Outcome MachineReader::read_axis_item(const std::string& key, const toml::node& node,
                                                     DrivenAxis& axis) const {
  if (key == "name") return {};
  if (key == "rotary") return read_flag(node, key, axis.rotary);
  if (key == "diameter") return read_flag(node, key, axis.diameter);
  if (key == "travel") return read_travel(node, axis);
  if (key == "reference") return read_numbers(node, key, axis.reference);
  const AxisKey* const known = find_axis_key(key);
  if (known == nullptr) return wrong(&node, "an axis has no key " + key);
  return read_value(*known, node, axis);
}

MachineReader::Outcome MachineReader::read_flag(const toml::node& node, const std::string& key,
                                                bool& flag) const {
  if (!node.is_boolean()) return wrong(&node, key + " must be true or false");
  flag = node.as_boolean()->get();
  return {};
}

MachineReader::Outcome MachineReader::read_travel(const toml::node& node, DrivenAxis& axis) const {
  std::array<double, 2> travel{};
  if (auto r = read_numbers(node, "travel", travel); !r) return r;
  if (!(travel[0] < travel[1])) return wrong(&node, "travel takes its lower end first");
  axis.travel_low = travel[0];
  axis.travel_high = travel[1];
  return {};
}

MachineReader::Outcome MachineReader::read_numbers(const toml::node& node, const std::string& key,
                                                   std::span<double> into) const {
  const std::string expected = key + " takes " + std::to_string(into.size()) + " numbers";
  const toml::array* const list = node.as_array();
  if (list == nullptr || list->size() != into.size()) return wrong(&node, expected);
  for (std::size_t i = 0; i < into.size(); ++i) {
    const auto value = value_of(any_number(), (*list)[i]);
    if (!value) return wrong(&node, expected);
    into[i] = *value;
  }
  return {};
}

template <typename Owner>
MachineReader::Outcome MachineReader::read_value(const Key<Owner>& key, const toml::node& node,
                                                 Owner& owner) const {
  const auto value = value_of(key.takes, node);
  if (!value) return wrong(&node, std::string(key.name) + " must be " + in_words(key.takes));
  key.assign(owner, *value);
  return {};
}

// The limit of the main spindle is a parameter of the control, which may say otherwise.
MachineReader::Outcome MachineReader::read_codes() {
  control::MachineCodes& codes = machine_.parameters.machine_codes;
  if (auto r = MachineCodesReader(file_, source_, codes, machine_.spindle_kw).read(); !r) return r;
  limit_main_spindle(machine_);
  return {};
}

MachineReader::Outcome MachineReader::read_tables() {
  for (const std::string_view name : kTablesOfKeys) {
    const toml::node* const node = file_.get(name);
    if (node == nullptr) continue;
    if (!node->is_table()) return wrong(node, std::string(name) + " must be a table");
    for (const auto& [key, item] : *node->as_table()) {
      if (auto r = read_item(name, std::string(key.str()), item); !r) return r;
    }
  }
  return {};
}

MachineReader::Outcome MachineReader::read_item(std::string_view table, const std::string& key,
                                                const toml::node& node) {
  if (table == "kinematics" && key == "type") return {};
  const std::string name = std::string(table) + "." + key;
  if (const PointKey* const point = find_point_key(table, key))
    return read_point(*point, name, node);
  if (table == "beam" && key == kBeamGas) return read_gas(node);
  const MachineKey* const known = find_machine_key(table, key);
  if (known == nullptr) return wrong(&node, "there is no key " + name);
  if (!known->belongs_to(machine_.kinematics.kind))
    return wrong(&node, type_in_words(machine_) + " has no key " + name);
  return read_value(*known, node, machine_);
}

MachineReader::Outcome MachineReader::read_point(const PointKey& key, const std::string& name,
                                                 const toml::node& node) {
  if (machine_.kinematics.kind != kinematics::Kind::cartesian)
    return wrong(&node, type_in_words(machine_) + " has no key " + name);
  std::string text;
  if (const toml::array* const numbers = node.as_array()) {
    for (const toml::node& number : *numbers) text += (text.empty() ? "" : ",") + text_of(number);
  }
  const auto point = point_of(text);
  if (!point) return wrong(&node, name + " must be three numbers: [X, Y, Z]");
  machine_.kinematics.tables.*key.point = *point;
  return {};
}

MachineReader::Outcome MachineReader::read_gas(const toml::node& node) {
  const auto text = node.value<std::string>();
  if (!node.is_string() || !text || !is_gas(*text))
    return wrong(&node, "beam.gas must be " + std::string(kGasInWords));
  machine_.drive.laser.gas = *text;
  return {};
}

MachineReader::Outcome MachineReader::finish() {
  if (const std::string text = timer_objection(machine_.drive); !text.empty())
    return wrong(file_.at_path("drive.timer").node(), text);
  if (const std::string text = drive_objection(machine_.drive); !text.empty())
    return wrong(file_.get("drive"), text);
  const std::string text = complete(machine_);
  if (text.empty()) return {};
  const toml::node* const linkage = file_.get("kinematics");
  return wrong(linkage != nullptr ? linkage : file_.get("axis"), text);
}

// What leaves the travel of a mill or lathe is told by its limit switches; a laser burns its frame.
MachineReader::Outcome MachineReader::read_control() {
  machine_.parameters.stroke_check =
      !machine_.axes.linked && (machine_.drive.laser.fitted() || file_.contains("pattern"));
  const toml::node* const node = file_.get("control");
  if (node == nullptr) return {};
  if (!node->is_table()) return wrong(node, "control must be a table");
  for (const auto& [key, value] : *node->as_table()) {
    if (auto r = read_parameter(std::string(key.str()), value); !r) return r;
  }
  return {};
}

MachineReader::Outcome MachineReader::read_tools() {
  for (const char* name : {"tool", "holder"}) {
    const toml::node* const node = file_.get(name);
    if (node != nullptr && !node->is_array_of_tables())
      return wrong(node, std::string("[[") + name + "]] tables are expected");
  }
  auto read = read_tool_tables(file_, source_, stock::ToolSource::machine);
  if (!read) return tl::unexpected(read.error());
  for (ToolEntry& entry : *read) machine_.tools.push_back(std::move(entry.tool));
  return {};
}

// overrun = { X = 0.5, Y = -0.5 } is overrun.X and overrun.Y.
MachineReader::Outcome MachineReader::read_parameter(const std::string& key,
                                                     const toml::node& node) {
  if (const toml::table* const of_axes = node.as_table()) {
    for (const auto& [axis, value] : *of_axes) {
      if (auto r = read_parameter(key + "." + std::string(axis.str()), value); !r) return r;
    }
    return {};
  }
  const auto set = machine_.set_parameter(key, text_of(node));
  return set ? Outcome{} : wrong(&node, set.error().message);
}

}  // namespace kerf::machine
