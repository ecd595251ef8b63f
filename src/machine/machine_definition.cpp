#include "machine/machine_definition.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/decimal.hpp"
#include "base/source_file.hpp"

namespace kerf::machine {
namespace {

constexpr std::size_t kLargestFile = 1 << 20;

tl::unexpected<base::Failure> wrong(const std::string& source, const toml::node* node,
                                    const std::string& what) {
  std::string where = source;
  if (node != nullptr) where += ":" + std::to_string(node->source().begin.line);
  return tl::unexpected(base::Failure{base::Failure::Kind::input, where + ": " + what});
}

bool known(std::string_view key, std::initializer_list<std::string_view> keys) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

base::Outcome<void> read_numbers(const toml::node* node, std::span<double> into,
                                 const std::string& source, const char* what) {
  const toml::array* const list = node->as_array();
  if (list == nullptr || list->size() != into.size()) {
    return wrong(source, node,
                 std::string(what) + " takes " + std::to_string(into.size()) + " numbers");
  }
  for (std::size_t i = 0; i < into.size(); ++i) {
    const auto value = (*list)[i].value<double>();
    if (!value || !std::isfinite(*value))
      return wrong(source, node, std::string(what) + " takes numbers");
    into[i] = *value;
  }
  return {};
}

base::Outcome<void> read_positive(const toml::table& table, const char* key, double& into,
                                  const std::string& source) {
  const toml::node* const node = table.get(key);
  if (node == nullptr) return {};
  const auto value = node->value<double>();
  if (!value || !(*value > 0) || !std::isfinite(*value))
    return wrong(source, node, std::string(key) + " must be a positive number");
  into = *value;
  return {};
}

base::Outcome<control::AxisConfig> read_axis(const toml::table& table, const std::string& source) {
  control::AxisConfig axis;
  for (const auto& [key, node] : table) {
    if (known(key.str(),
              {"name", "rotary", "velocity", "acceleration", "jerk", "travel", "reference"}))
      continue;
    return wrong(source, &node, "an axis has no key " + std::string(key.str()));
  }
  const auto name = table["name"].value<std::string>();
  if (!name || name->size() != 1 ||
      std::string_view("XYZABCUVW").find((*name)[0]) == std::string_view::npos) {
    return wrong(source, &table, "an axis needs a name: one of X Y Z A B C U V W");
  }
  axis.letter = (*name)[0];
  if (const toml::node* const node = table.get("rotary")) {
    if (!node->is_boolean()) return wrong(source, node, "rotary is true or false");
    axis.rotary = node->as_boolean()->get();
  }
  if (table.get("velocity") == nullptr) return wrong(source, &table, "an axis needs its velocity");
  double travel[2] = {0, 0};
  if (auto r = read_positive(table, "velocity", axis.rapid_per_min, source); !r)
    return tl::unexpected(r.error());
  if (auto r = read_positive(table, "acceleration", axis.acceleration, source); !r)
    return tl::unexpected(r.error());
  if (auto r = read_positive(table, "jerk", axis.jerk, source); !r)
    return tl::unexpected(r.error());
  if (const toml::node* const node = table.get("travel")) {
    if (auto r = read_numbers(node, travel, source, "travel"); !r) return tl::unexpected(r.error());
  }
  if (const toml::node* const node = table.get("reference")) {
    if (auto r = read_numbers(node, axis.reference, source, "reference"); !r)
      return tl::unexpected(r.error());
  }
  axis.travel_min = travel[0];
  axis.travel_max = travel[1];
  return axis;
}

std::string text_of(const toml::node& node) {
  if (const auto text = node.value<std::string>()) return *text;
  if (const auto flag = node.as_boolean()) return flag->get() ? "1" : "0";
  if (const auto number = node.value<double>()) return base::number_text(*number);
  return {};
}

base::Outcome<void> read_axes(const toml::table& table, MachineDefinition& machine,
                              const std::string& source) {
  const toml::array* const axes = table["axis"].as_array();
  if (axes == nullptr || axes->empty() || axes->size() > base::kMaxAxes) {
    return wrong(source, table.get("axis"),
                 "a machine has 1 to " + std::to_string(base::kMaxAxes) + " [[axis]] tables");
  }
  for (const toml::node& node : *axes) {
    if (!node.is_table()) return wrong(source, &node, "axis must be a table");
    auto axis = read_axis(*node.as_table(), source);
    if (!axis) return tl::unexpected(axis.error());
    if (machine.axes.find(axis->letter))
      return wrong(source, &node, std::string("axis ") + axis->letter + " stands twice");
    machine.axes.axes.push_back(*axis);
  }
  return {};
}

base::Outcome<void> read_dialect(const toml::node* node, MachineDefinition& machine,
                                 const std::string& source) {
  machine.dialect = kDialects[0];
  if (node == nullptr) return {};
  const auto name = node->value<std::string>();
  if (!name || std::find(kDialects.begin(), kDialects.end(), *name) == kDialects.end())
    return wrong(source, node, "there is no dialect " + name.value_or("of this kind"));
  machine.dialect = *name;
  return {};
}

base::Outcome<void> read_control(const toml::node* node, MachineDefinition& machine,
                                 const std::string& source) {
  if (node == nullptr) return {};
  if (!node->is_table()) return wrong(source, node, "control must be a table");
  for (const auto& [key, value] : *node->as_table()) {
    auto set = machine.parameters.set(key.str(), text_of(value));
    if (!set) return wrong(source, &value, set.error().message);
  }
  return {};
}

std::string join_lines(std::string_view text) {
  std::string line(text.substr(0, text.find('\n')));
  return line;
}

}  // namespace

base::Outcome<MachineDefinition> MachineDefinition::parse(std::string_view text,
                                                          const std::string& source) {
  toml::table table;
  try {
    table = toml::parse(text);
  } catch (const toml::parse_error& error) {
    return tl::unexpected(base::Failure{base::Failure::Kind::input,
                                        source + ":" + std::to_string(error.source().begin.line) +
                                            ": " + join_lines(error.description())});
  }
  MachineDefinition machine;
  for (const auto& [key, node] : table) {
    if (known(key.str(), {"name", "description", "dialect", "axis", "control"})) continue;
    return wrong(source, &node, "a machine has no key " + std::string(key.str()));
  }
  machine.name = table["name"].value_or(std::string());
  if (machine.name.empty()) return wrong(source, nullptr, "a machine needs a name");
  machine.description = table["description"].value_or(std::string());
  if (auto r = read_dialect(table.get("dialect"), machine, source); !r)
    return tl::unexpected(r.error());
  if (auto r = read_axes(table, machine, source); !r) return tl::unexpected(r.error());
  if (auto r = read_control(table.get("control"), machine, source); !r)
    return tl::unexpected(r.error());
  return machine;
}

base::Outcome<void> MachineDefinition::set(std::string_view key, std::string_view value) {
  const auto usage = [&](const std::string& what) {
    return tl::unexpected(base::Failure{
        base::Failure::Kind::usage,
        "--machine-set " + std::string(key) + "=" + std::string(value) + ": " + what});
  };
  if (!key.starts_with("axis.") || key.size() < 8 || key[6] != '.')
    return usage("there is no such key");
  const auto axis = axes.find(key[5]);
  if (!axis) return usage("the machine has no such axis");
  double number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (error != std::errc() || end != value.data() + value.size() || !(number > 0) ||
      !std::isfinite(number)) {
    return usage("a positive number is expected");
  }
  control::AxisConfig& config = axes.axes[base::index(*axis)];
  const std::string_view item = key.substr(7);
  if (item == "velocity") {
    config.rapid_per_min = number;
  } else if (item == "acceleration") {
    config.acceleration = number;
  } else if (item == "jerk") {
    config.jerk = number;
  } else {
    return usage("there is no such key");
  }
  return {};
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
  auto file = base::SourceFile::open(name_or_path);
  if (!file) return tl::unexpected(file.error());
  if ((*file)->size() > kLargestFile) {
    return tl::unexpected(
        base::Failure{base::Failure::Kind::input, name_or_path + ": too large for a machine file"});
  }
  std::string text((*file)->size(), '\0');
  text.resize((*file)->read(0, text));
  return MachineDefinition::parse(text, name_or_path);
}

}  // namespace kerf::machine
