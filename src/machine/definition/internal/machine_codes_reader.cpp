#include "machine/definition/internal/machine_codes_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base/decimal.hpp"
#include "machine/definition/internal/machine_keys.hpp"
#include "machine/definition/internal/toml_value.hpp"

namespace kerf::machine {
namespace {

using control::BuilderFunction;
using control::SpindleSettings;
using motion::kSpindleNames;

constexpr double kMostMCode = 99999999;

constexpr std::array<std::pair<std::string_view, BuilderFunction>, 7> kFunctions = {{
    {"c_axis_on", BuilderFunction::c_axis_on},
    {"c_axis_off", BuilderFunction::c_axis_off},
    {"clamp", BuilderFunction::clamp},
    {"wait", BuilderFunction::wait},
    {"bar_feeder", BuilderFunction::bar_feeder},
    {"catcher", BuilderFunction::catcher},
    {"sub_spindle", BuilderFunction::sub_spindle},
}};

std::optional<BuilderFunction> function_named(std::string_view key) {
  const auto* const found = std::find_if(kFunctions.begin(), kFunctions.end(),
                                         [=](const auto& named) { return named.first == key; });
  return found == kFunctions.end() ? std::nullopt : std::optional(found->second);
}

/// "G12.1" in tenths; nothing where it is no G code.
std::optional<std::uint16_t> g_code(std::string_view text) {
  if (text.empty() || text[0] != 'G') return std::nullopt;
  const auto number = base::read_number(text.substr(1));
  const double tenths = number ? std::round(*number * 10) : -1;
  if (tenths < 0 || tenths > 9999 || std::fabs(*number * 10 - tenths) > 1e-6) return std::nullopt;
  return static_cast<std::uint16_t>(tenths);
}

// A number, or a list of numbers. False: something else.
bool read_numbers(const toml::node& node, std::vector<std::uint32_t>& numbers) {
  if (const toml::array* const list = node.as_array()) {
    return std::all_of(list->begin(), list->end(),
                       [&](const toml::node& item) { return read_numbers(item, numbers); });
  }
  const auto number = value_of(whole_numbers(0, kMostMCode), node);
  if (number) numbers.push_back(static_cast<std::uint32_t>(*number));
  return number.has_value();
}

}  // namespace

tl::unexpected<base::Failure> MachineCodesReader::wrong(const toml::node& node,
                                                        const std::string& what) const {
  return wrong_at(source_, &node, what);
}

base::Outcome<void> MachineCodesReader::read() {
  auto done = read_spindles();
  if (done) done = read_m_codes();
  return done ? read_g_codes() : done;
}

MachineCodesReader::Outcome MachineCodesReader::read_spindles() {
  const toml::node* const node = file_.get("spindle");
  if (node == nullptr) return {};
  // A single one is the main one.
  if (node->is_table()) return read_spindle(*node->as_table(), kSpindleNames.front());
  const toml::array* const spindles = node->as_array();
  if (spindles == nullptr) return wrong(*node, "a machine has [[spindle]] tables");
  for (const toml::node& spindle : *spindles) {
    if (!spindle.is_table()) return wrong(spindle, "spindle must be a table");
    if (auto done = read_spindle(*spindle.as_table(), {}); !done) return done;
  }
  return {};
}

MachineCodesReader::Outcome MachineCodesReader::read_spindle(const toml::table& table,
                                                             std::string_view usual_name) {
  const auto name = table["name"].value_or(std::string(usual_name));
  const auto* const known = std::find(kSpindleNames.begin(), kSpindleNames.end(), name);
  if (known == kSpindleNames.end())
    return wrong(table, "a spindle needs a name: main, live or sub");
  SpindleSettings spindle{.name = static_cast<motion::SpindleName>(known - kSpindleNames.begin())};
  if (codes_.find(spindle.name) != nullptr)
    return wrong(table, "spindle " + name + " stands twice");
  for (const auto& [key, node] : table) {
    if (auto done = read_item(std::string(key.str()), node, spindle); !done) return done;
  }
  codes_.spindles.push_back(std::move(spindle));
  return {};
}

MachineCodesReader::Outcome MachineCodesReader::read_item(const std::string& key,
                                                          const toml::node& node,
                                                          SpindleSettings& spindle) {
  if (key == "name") return {};
  if (key == "p")
    return read_numbers(node, spindle.numbers) ? Outcome{} : wrong(node, "p takes whole numbers");
  if (key == kSpindlePower) {
    const auto power = value_of(not_negative(), node);
    if (!power) return wrong(node, key + " must be " + in_words(not_negative()));
    spindle_kw_[index(spindle.name)] = *power;
    return {};
  }
  const SpindleKey* const known = find_spindle_key(key);
  if (known == nullptr) return wrong(node, "a spindle has no key " + key);
  const auto value = value_of(known->takes, node);
  if (!value) return wrong(node, key + " must be " + in_words(known->takes));
  known->assign(spindle, *value);
  return {};
}

MachineCodesReader::Outcome MachineCodesReader::read_m_codes() {
  const toml::node* const node = file_.get("m_codes");
  if (node == nullptr) return {};
  if (!node->is_table()) return wrong(*node, "m_codes must be a table");
  for (const auto& [key, numbers] : *node->as_table()) {
    if (auto done = read_function(key.str(), numbers); !done) return done;
  }
  return {};
}

MachineCodesReader::Outcome MachineCodesReader::read_function(std::string_view key,
                                                              const toml::node& node) {
  const auto function = function_named(key);
  if (!function) return wrong(node, "there is no key m_codes." + std::string(key));
  std::vector<std::uint32_t> numbers;
  if (!read_numbers(node, numbers)) return wrong(node, std::string(key) + " takes whole numbers");
  for (const std::uint32_t number : numbers) codes_.codes.push_back({number, *function});
  return {};
}

// G121 = "G12.1"
MachineCodesReader::Outcome MachineCodesReader::read_g_codes() {
  const toml::node* const node = file_.get("g_codes");
  if (node == nullptr) return {};
  if (!node->is_table()) return wrong(*node, "g_codes must be a table");
  for (const auto& [key, meant] : *node->as_table()) {
    const std::string why = change_g_code(codes_, key.str(), meant.value_or(std::string()));
    if (!why.empty()) return wrong(meant, "g_codes." + std::string(key.str()) + ": " + why);
  }
  return {};
}

std::string change_g_code(control::MachineCodes& codes, std::string_view code,
                          std::string_view meant) {
  const auto from = g_code(code);
  const auto to = g_code(meant);
  if (!from || !to) return "G codes are expected: G121 = \"G12.1\"";
  std::erase_if(codes.other_names, [&](const auto& name) { return name.code == *from; });
  codes.other_names.push_back({*from, *to});
  return {};
}

std::string change_m_codes(control::MachineCodes& codes, std::string_view key,
                           std::string_view text) {
  const auto function = function_named(key);
  if (!function) return "there is no such key";
  std::vector<control::MachineCodes::Code> changed = codes.codes;
  std::erase_if(changed, [=](const auto& code) { return code.function == *function; });
  while (!text.empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    const auto number = value_of(whole_numbers(0, kMostMCode), text.substr(0, comma));
    if (!number) return "whole numbers with commas between them are expected";
    changed.push_back({static_cast<std::uint32_t>(*number), *function});
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  codes.codes = std::move(changed);
  return {};
}

}  // namespace kerf::machine
