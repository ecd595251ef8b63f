#include "machine/definition/offset_file.hpp"

#include <toml++/toml.h>

#include <cmath>

#include "base/decimal.hpp"
#include "control/core/offset_parts.hpp"
#include "machine/definition/tools/tool_tables.hpp"

namespace kerf::machine {
namespace {

using control::Memory;

struct Wrong {
  Wrong(const toml::node* node, std::string text)
      : line(node->source().begin.line), what(std::move(text)) {}
  std::uint32_t line;  // the document is gone when this is caught
  std::string what;
};

double number(const toml::node& node) {
  const auto value = node.value<double>();
  if (!value || !std::isfinite(*value)) throw Wrong{&node, "a number is expected"};
  return *value;
}

std::size_t offset_number(const toml::node& node, const std::string& text, const Memory& memory) {
  const auto value = base::read_whole_number(text);
  if (!value || *value < 1 || *value >= memory.tools.size())
    throw Wrong{&node, "there is no tool offset " + text};
  return static_cast<std::size_t>(*value);
}

base::AxisVector* work_system(const std::string& name, Memory& memory) {
  if (name == "EXT") return &memory.external;
  if (name.size() == 3 && name.starts_with("G5") && name[2] >= '4' && name[2] <= '9') {
    return &memory.work[static_cast<std::size_t>(name[2] - '4')];
  }
  if (!name.starts_with("G54.1")) return nullptr;
  const std::size_t p = name.find_first_of("0123456789", 5);
  if (p == std::string::npos) return nullptr;
  const auto n = base::read_whole_number(std::string_view(name).substr(p));
  const bool marked = name.find_first_not_of(" P", 5) == p;
  const bool there = n && *n >= 1 && *n <= memory.extended.size();
  return marked && there ? &memory.extended[static_cast<std::size_t>(*n) - 1] : nullptr;
}

void read_work(const toml::table& table, const motion::AxisSetup& axes, Memory& memory) {
  for (const auto& [key, node] : table) {
    base::AxisVector* const system = work_system(std::string(key.str()), memory);
    if (system == nullptr || !node.is_table())
      throw Wrong{&node, "there is no work coordinate system " + std::string(key.str())};
    for (const auto& [letter, value] : *node.as_table()) {
      const auto axis = letter.str().size() == 1 ? axes.find(letter.str()[0]) : std::nullopt;
      if (!axis) throw Wrong{&value, "the machine has no axis " + std::string(letter.str())};
      (*system)[*axis] = number(value);
    }
  }
}

// False: such an offset has no part of this name.
template <typename Row>
bool read_part(const toml::key& key, const toml::node& value, Row& row) {
  const auto* const part = control::part_named<Row>(key.str());
  if (part == nullptr) return false;
  if (!part->takes(number(value)))
    throw Wrong{&value, std::string(key.str()) + " is a whole number from 0 to " +
                            std::to_string(part->most_whole)};
  part->of(row) = number(value);
  return true;
}

// The names say whether it is an offset of a lathe.
void read_offset(const toml::table& table, std::size_t number, Memory& memory) {
  for (const auto& [key, value] : table) {
    if (!read_part(key, value, memory.tools[number]) &&
        !read_part(key, value, memory.turning[number]))
      throw Wrong{&value, "a tool offset has no key " + std::string(key.str())};
  }
}

void read_offset_tables(const toml::table& table, Memory& memory) {
  for (const auto& [key, node] : table) {
    if (!node.is_table()) throw Wrong{&node, "a table is expected"};
    read_offset(*node.as_table(), offset_number(node, std::string(key.str()), memory), memory);
  }
}

// The tools of the file are read by themselves.
void read_all(const toml::table& table, const motion::AxisSetup& axes, Memory& memory) {
  for (const auto& [key, node] : table) {
    if (key.str() == "beam") continue;
    const bool is_list = node.is_array_of_tables();
    if (is_list && (key.str() == "tool" || key.str() == "holder")) continue;
    if (key.str() == "work" && node.is_table()) {
      read_work(*node.as_table(), axes, memory);
    } else if ((key.str() == "tool" || key.str() == "tool_offset") && node.is_table()) {
      read_offset_tables(*node.as_table(), memory);
    } else {
      throw Wrong{&node, "there is no table " + std::string(key.str())};
    }
  }
}

}  // namespace

bool looks_like_toml(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string::npos &&
         (text[first] == '[' || text[first] == '#' || text.find(" = ") != std::string::npos) &&
         text.find('[') != std::string::npos;
}

bool set_offsets(const stock::Tool& tool, const control::Parameters& parameters, Memory& memory) {
  using stock::Measure;
  const auto row = static_cast<std::size_t>(tool.number);
  if (tool.number < 1 || row >= memory.tools.size()) return false;
  const auto diameter = tool.measures.get(Measure::diameter);
  const auto length = tool.measures.get(Measure::length);
  if (diameter) memory.tools[row].radius_geometry = *diameter / 2;
  if (diameter && parameters.offset_memory != 'C')
    memory.tools[row].length_geometry = *diameter / 2;
  if (length) memory.tools[row].length_geometry = *length;
  if (const auto nose = tool.said(Measure::nose_radius))
    memory.turning[row].geometry.radius = *nose;
  if (const auto tip = tool.said(Measure::tip)) memory.turning[row].tip = *tip;
  return true;
}

base::Outcome<void> read_offsets(const std::string& text, const std::string& source,
                                 const motion::AxisSetup& axes,
                                 const control::Parameters& parameters, Memory& memory) {
  const auto failure = [&](std::uint32_t line, const std::string& what) {
    return tl::unexpected(base::Failure{base::Failure::Kind::input,
                                        source + ":" + std::to_string(line) + ": " + what});
  };
  Memory read = memory;
  try {
    const toml::table table = toml::parse(text);
    const auto tools = read_tool_tables(table, source, stock::ToolSource::file);
    if (!tools) return tl::unexpected(tools.error());
    for (const ToolEntry& entry : *tools) {
      if (!set_offsets(entry.tool, parameters, read))
        return failure(entry.line, "there is no tool offset " + std::to_string(entry.tool.number));
    }
    read_all(table, axes, read);
  } catch (const toml::parse_error& error) {
    return failure(error.source().begin.line, std::string(error.description()));
  } catch (const Wrong& wrong) {
    return failure(wrong.line, wrong.what);
  }
  memory = read;
  return {};
}

}  // namespace kerf::machine
