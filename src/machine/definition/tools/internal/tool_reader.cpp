#include "machine/definition/tools/internal/tool_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/decimal.hpp"
#include "machine/definition/tools/internal/tool_limits.hpp"

namespace kerf::machine {
namespace {

using stock::Measure;
using stock::Segment;
using stock::Tool;

constexpr std::size_t kMostParts = 1000;  // of a stack, of an outline
constexpr std::size_t kLongestText = 1000;
constexpr double kMost_mm = 1e5;

double number_of(const toml::node& node) {
  const auto value = node.is_number() ? node.value<double>() : std::nullopt;
  if (!value || !std::isfinite(*value)) throw WrongTool{node, "a number is expected"};
  return *value;
}

double length_of(const toml::table& table, std::string_view key) {
  const toml::node* const node = table.get(key);
  if (node == nullptr) throw WrongTool{table, "a segment needs its " + std::string(key)};
  const double value = number_of(*node);
  if (value > 0 && value <= kMost_mm) return value;
  throw WrongTool{*node,
                  std::string(key) + " is a number above 0 up to " + base::number_text(kMost_mm)};
}

std::string text_of(const toml::node& node) {
  const auto text = node.value<std::string>();
  if (!node.is_string() || text->size() > kLongestText) throw WrongTool{node, "a text is expected"};
  return *text;
}

const toml::array& list_of(const toml::node& node, const std::string& what) {
  const toml::array* const list = node.as_array();
  if (list == nullptr || list->size() > kMostParts) throw WrongTool{node, what + " is expected"};
  return *list;
}

Segment segment_of(const toml::node& node) {
  const toml::table* const table = node.as_table();
  if (table == nullptr)
    throw WrongTool{node, "{height, diameter} or {height, lower, upper} is expected"};
  for (const auto& [key, value] : *table) {
    constexpr std::array<std::string_view, 4> kKeys = {"height", "diameter", "lower", "upper"};
    if (std::find(kKeys.begin(), kKeys.end(), key.str()) == kKeys.end())
      throw WrongTool{value, "a segment has no key " + std::string(key.str())};
  }
  const double height = length_of(*table, "height");
  if (table->get("diameter") == nullptr)
    return {height, length_of(*table, "lower"), length_of(*table, "upper")};
  if (table->get("lower") != nullptr || table->get("upper") != nullptr)
    throw WrongTool{*table, "a segment has diameter, or lower and upper"};
  const double diameter = length_of(*table, "diameter");
  return {height, diameter, diameter};
}

std::vector<Segment> stack_of(const toml::node& node) {
  std::vector<Segment> stack;
  for (const toml::node& each : list_of(node, "a list of segments"))
    stack.push_back(segment_of(each));
  return stack;
}

void take_name(const toml::node& node, Tool& tool) { tool.name = text_of(node); }
void take_comment(const toml::node& node, Tool& tool) { tool.comment = text_of(node); }
void take_material(const toml::node& node, Tool& tool) { tool.material = text_of(node); }
void take_insert(const toml::node& node, Tool& tool) { tool.insert = text_of(node); }
void take_shank(const toml::node& node, Tool& tool) { tool.shank = stack_of(node); }
void take_holder(const toml::node& node, Tool& tool) { tool.holder = stack_of(node); }

void take_number(const toml::node& node, Tool& tool) {
  const auto value = node.is_integer() ? node.value<std::int64_t>() : std::nullopt;
  if (!value || *value < 1 || *value > kLargestToolNumber)
    throw WrongTool{node, "there is no tool " +
                              (value ? std::to_string(*value) : std::string("of this number"))};
  tool.number = static_cast<int>(*value);
}

void take_type(const toml::node& node, Tool& tool) {
  const std::string word = text_of(node);
  const stock::NamedKind named = stock::kind_named(word);
  if (named.row == nullptr)
    throw WrongTool{
        node, "there is no type " + word.substr(0, 40) + " of tools; docs/tools.md has them all"};
  tool.kind = named.row->kind;
  tool.type = named.name;
}

void take_hand(const toml::node& node, Tool& tool) {
  const std::string word = text_of(node);
  if (word != "right" && word != "left") throw WrongTool{node, "hand is right or left"};
  tool.hand = word == "left" ? stock::Hand::left : stock::Hand::right;
}

void take_driven(const toml::node& node, Tool& tool) {
  const std::string word = text_of(node);
  if (word != "face" && word != "side") throw WrongTool{node, "driven is face or side"};
  tool.driven = word == "face" ? stock::Driven::face : stock::Driven::side;
}

void take_centre(const toml::node& node, Tool& tool) {
  if (!node.is_boolean()) throw WrongTool{node, "true or false is expected"};
  tool.centre_cutting = node.as_boolean()->get();
}

void take_limits(const toml::node& node, Tool& tool) {
  if (!node.is_table()) throw WrongTool{node, "{fz, ap, ae, vc, ramp_deg} is expected"};
  for (const auto& [key, value] : *node.as_table()) {
    const auto* const limit =
        std::find_if(kLimitKeys.begin(), kLimitKeys.end(),
                     [&key = key](const LimitKey& each) { return each.name == key.str(); });
    if (limit == kLimitKeys.end())
      throw WrongTool{value, "limits has no key " + std::string(key.str())};
    if (!(number_of(value) > 0)) throw WrongTool{value, "a limit is above 0"};
    tool.limits.*(limit->of) = number_of(value);
  }
}

void take_profile(const toml::node& node, Tool& tool) {
  for (const toml::node& each : list_of(node, "a list of [r, height] or [r, height, bulge]")) {
    const toml::array& row = list_of(each, "[r, height] or [r, height, bulge]");
    if (row.size() < 2 || row.size() > 3)
      throw WrongTool{each, "[r, height] or [r, height, bulge] is expected"};
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < row.size(); ++i) values[i] = number_of(row[i]);
    if (std::abs(values[0]) > kMost_mm || std::abs(values[1]) > kMost_mm)
      throw WrongTool{each, "a point is farther than " + base::number_text(kMost_mm) + " mm"};
    tool.form.push_back({values[0], values[1], values[2]});
  }
}

void take_cutting(const toml::node& node, Tool& tool) {
  const toml::array& pair = list_of(node, "[from, to]");
  if (pair.size() != 2 || !pair[0].is_integer() || !pair[1].is_integer() ||
      number_of(pair[0]) < 0 || number_of(pair[1]) < 0)
    throw WrongTool{node, "[from, to], two points of profile counted from 0, is expected"};
  tool.cutting = {static_cast<std::size_t>(*pair[0].value<std::int64_t>()),
                  static_cast<std::size_t>(*pair[1].value<std::int64_t>())};
}

struct Item {
  std::string_view key;
  void (*take)(const toml::node& node, Tool& tool);
};
constexpr std::array<Item, 15> kItems = {{{"number", take_number},
                                          {"type", take_type},
                                          {"name", take_name},
                                          {"comment", take_comment},
                                          {"material", take_material},
                                          {"insert", take_insert},
                                          {"hand", take_hand},
                                          {"centre_cutting", take_centre},
                                          {"driven", take_driven},
                                          {"shank", take_shank},
                                          {"holder", take_holder},
                                          {"holder_name", nullptr},
                                          {"limits", take_limits},
                                          {"profile", take_profile},
                                          {"cutting", take_cutting}}};

void take_measure(const toml::key& key, const toml::node& node, Tool& tool) {
  const stock::MeasureRow* const row = stock::measure_named(key.str());
  if (row == nullptr) throw WrongTool{node, "a tool has no key " + std::string(key.str())};
  const double value = number_of(node);
  if (!row->takes(value)) throw WrongTool{node, row->in_words() + " is expected"};
  tool.measures.set(row->measure, value);
}

void take_key(const toml::key& key, const toml::node& node, Tool& tool) {
  const auto* const item = std::find_if(kItems.begin(), kItems.end(),
                                        [&](const Item& each) { return each.key == key.str(); });
  if (item == kItems.end()) return take_measure(key, node, tool);
  if (item->take != nullptr) item->take(node, tool);
}

void take_holder_by_name(const toml::table& table, const HolderNames& holders, Tool& tool) {
  const toml::node* const node = table.get("holder_name");
  if (node == nullptr) return;
  if (table.get("holder") != nullptr)
    throw WrongTool{*node, "a tool has holder or holder_name, not both"};
  const auto found = holders.find(text_of(*node));
  if (found == holders.end())
    throw WrongTool{*node, "there is no [[holder]] of the name " + text_of(*node)};
  tool.holder = found->second;
}

/// Where nobody has said it: an insert turns, everything else mills.
void choose_kind(Tool& tool) {
  if (!tool.type.empty()) return;
  const bool turns = !tool.insert.empty() || tool.measures.get(Measure::nose_radius) ||
                     tool.measures.get(Measure::tip);
  tool.kind = turns ? stock::ToolKind::turning : stock::ToolKind::flat;
}

/// The line of the key that a sentence begins with, else of the table.
const toml::node& place_of(const std::string& sentence, const toml::table& table) {
  const toml::node* const node = table.get(sentence.substr(0, sentence.find_first_of(" ,")));
  return node != nullptr ? *node : table;
}

void check_shape(const toml::table& table, const Tool& tool) {
  const bool may_lack_one = tool.type.empty() && !tool.is_insert() &&
                            tool.measures.get(Measure::diameter).value_or(0) == 0;
  const std::string wrong = may_lack_one ? std::string() : stock::objection(tool);
  if (!wrong.empty()) throw WrongTool{place_of(wrong, table), wrong};
}

}  // namespace

HolderNames read_holders(const toml::table& file) {
  HolderNames holders;
  const toml::node* const node = file.get("holder");
  if (node == nullptr) return holders;
  if (!node->is_array_of_tables()) throw WrongTool{*node, "[[holder]] tables are expected"};
  for (const toml::node& each : *node->as_array()) {
    const toml::table& table = *each.as_table();
    for (const auto& [key, value] : table) {
      if (key.str() != "name" && key.str() != "segments")
        throw WrongTool{value, "a holder has no key " + std::string(key.str())};
    }
    if (table.get("name") == nullptr || table.get("segments") == nullptr)
      throw WrongTool{table, "a holder needs name and segments"};
    const std::string name = text_of(*table.get("name"));
    if (!holders.emplace(name, stack_of(*table.get("segments"))).second)
      throw WrongTool{table, "there are two holders of the name " + name};
  }
  return holders;
}

Tool read_tool(const toml::table& table, const HolderNames& holders) {
  if (table.get("number") == nullptr) throw WrongTool{table, "a tool needs its number"};
  Tool tool;
  for (const auto& [key, node] : table) take_key(key, node, tool);
  take_holder_by_name(table, holders, tool);
  choose_kind(tool);
  check_shape(table, tool);
  return tool;
}

}  // namespace kerf::machine
