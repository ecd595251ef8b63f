#include "machine/definition/state_file.hpp"

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/decimal.hpp"
#include "base/output_file.hpp"
#include "base/source_file.hpp"
#include "control/core/offset_parts.hpp"
#include "lang/vm/value.hpp"

namespace kerf::machine {
namespace {

using control::Memory;
using control::ToolOffset;
using control::TurningOffset;
using nlohmann::json;

constexpr std::size_t kLargestState = 64 << 20;
constexpr int kFirstRetained = 500;
constexpr double kMostVariable = 4294967295.0;

// What does not fit the format throws; read_state() turns it into a sentence.
struct Unreadable {
  std::string what;
};

double number(const json& value, const char* where) {
  if (!value.is_number() || !std::isfinite(value.get<double>()))
    throw Unreadable{std::string(where) + " holds no number"};
  return value.get<double>();
}

int index(const std::string& text, int low, int high, const char* where) {
  const auto value = base::read_whole_number(text);
  if (!value || *value < static_cast<std::uint64_t>(low) ||
      *value > static_cast<std::uint64_t>(high))
    throw Unreadable{std::string(where) + " has no entry " + text};
  return static_cast<int>(*value);
}

json axes_json(const base::AxisVector& values) {
  json list = json::array();
  std::size_t count = base::kMaxAxes;
  while (count > 0 && values.values[count - 1] == 0) --count;
  for (std::size_t i = 0; i < count; ++i) list.push_back(values.values[i]);
  return list;
}

base::AxisVector axes_from(const json& list, const char* where) {
  base::AxisVector values;
  if (!list.is_array() || list.size() > base::kMaxAxes)
    throw Unreadable{std::string(where) + " is no list of axes"};
  for (std::size_t i = 0; i < list.size(); ++i) values.values[i] = number(list[i], where);
  return values;
}

// Of lathes: only what is not 0.
json turning_json(const Memory& memory) {
  json rows = json::object();
  for (std::size_t i = 1; i < memory.turning.size(); ++i) {
    for (const auto& part : control::parts_of(memory.turning[i])) {
      if (const double value = part.value(memory.turning[i]); value != 0)
        rows[std::to_string(i)][std::string(part.name)] = value;
    }
  }
  return rows;
}

json to_json(const Memory& memory) {
  json variables = json::object();
  for (std::size_t i = 0; i < (control::kCommons - control::kVolatileCommons); ++i) {
    const double value = memory.commons[control::kVolatileCommons + i];
    if (!vm::is_null(value))
      variables[std::to_string(static_cast<std::size_t>(kFirstRetained) + i)] = value;
  }
  json extended = json::object();
  for (std::size_t i = 0; i < memory.extended.size(); ++i) {
    if (memory.extended[i] != base::AxisVector{})
      extended[std::to_string(i + 1)] = axes_json(memory.extended[i]);
  }
  json work = json::array();
  for (const base::AxisVector& offset : memory.work) work.push_back(axes_json(offset));
  json tools = json::object();
  for (std::size_t i = 1; i < memory.tools.size(); ++i) {
    const ToolOffset& tool = memory.tools[i];
    if (tool == ToolOffset{}) continue;
    tools[std::to_string(i)] = {tool.length_geometry, tool.length_wear, tool.radius_geometry,
                                tool.radius_wear};
  }
  json kept = {{"kerf_state", 1},
               {"variables", variables},
               {"external", axes_json(memory.external)},
               {"work", work},
               {"extended", extended},
               {"tools", tools},
               {"parts", memory.parts},
               {"parts_required", memory.parts_required},
               {"running_hours", memory.running_hours},
               {"names", memory.names}};
  // Not in the files of mills.
  if (json turning = turning_json(memory); !turning.empty()) kept["turning"] = std::move(turning);
  return kept;
}

void read_tools(const json& tools, Memory& memory) {
  for (const auto& [key, value] : tools.items()) {
    const int n = index(key, 1, static_cast<int>(memory.tools.size()) - 1, "tools");
    if (!value.is_array() || value.size() != 4) throw Unreadable{"tools holds no four numbers"};
    memory.tools[static_cast<std::size_t>(n)] = {
        number(value[0], "tools"), number(value[1], "tools"), number(value[2], "tools"),
        number(value[3], "tools")};
  }
}

TurningOffset turning_from(const json& parts) {
  TurningOffset row;
  for (const auto& [name, value] : parts.items()) {
    const auto* const part = control::part_named<TurningOffset>(name);
    if (part == nullptr || !part->takes(number(value, "turning")))
      throw Unreadable{"turning holds a wrong " + name};
    part->of(row) = value.get<double>();
  }
  return row;
}

// Files that were written before there were lathes have none.
void read_turning(const json& state, Memory& memory) {
  if (!state.contains("turning")) return;
  for (const auto& [key, value] : state.at("turning").items()) {
    const int n = index(key, 1, static_cast<int>(memory.turning.size()) - 1, "turning");
    if (!value.is_object()) throw Unreadable{"turning holds no table"};
    memory.turning[static_cast<std::size_t>(n)] = turning_from(value);
  }
}

void from_json(const json& state, Memory& memory) {
  if (!state.is_object() || state.value("kerf_state", 0) != 1)
    throw Unreadable{"this is not a state file of Kerf"};
  for (const auto& [key, value] : state.at("variables").items()) {
    const int n = index(key, kFirstRetained, 999, "variables");
    memory.commons[control::kVolatileCommons + static_cast<std::size_t>(n - kFirstRetained)] =
        number(value, "variables");
  }
  memory.external = axes_from(state.at("external"), "external");
  const json& work = state.at("work");
  if (!work.is_array() || work.size() != control::kWorkSystems)
    throw Unreadable{"work must hold six systems"};
  for (std::size_t i = 0; i < control::kWorkSystems; ++i)
    memory.work[i] = axes_from(work[i], "work");
  for (const auto& [key, value] : state.at("extended").items()) {
    const int n = index(key, 1, static_cast<int>(control::kExtendedSystems), "extended");
    memory.extended[static_cast<std::size_t>(n - 1)] = axes_from(value, "extended");
  }
  read_tools(state.at("tools"), memory);
  read_turning(state, memory);
  memory.parts = number(state.at("parts"), "parts");
  memory.parts_required = number(state.at("parts_required"), "parts_required");
  memory.running_hours = number(state.at("running_hours"), "running_hours");
  for (const auto& [name, value] : state.at("names").items()) {
    const double variable = number(value, "names");
    if (!(variable >= 0 && variable <= kMostVariable && variable == std::floor(variable)))
      throw Unreadable{"names has " + name + " for no variable"};
    memory.names[name] = static_cast<std::uint32_t>(variable);
  }
}

}  // namespace

base::Outcome<void> read_state(const std::string& path, Memory& memory) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return {};
  const auto text = base::read_whole(path, kLargestState, "a state file");
  if (!text) return tl::unexpected(text.error());
  auto taken = take_state(*text, memory);
  if (!taken) taken.error().message = path + ": " + taken.error().message;
  return taken;
}

base::Outcome<void> take_state(const std::string& text, Memory& memory) {
  const auto unreadable = [&](const std::string& what) {
    return tl::unexpected(base::Failure{base::Failure::Kind::input, what});
  };
  Memory read = memory;
  try {
    from_json(json::parse(text), read);
  } catch (const Unreadable& what) {
    return unreadable(what.what);
  } catch (const json::exception&) {
    return unreadable("this is not a state file of Kerf");
  }
  memory = read;
  return {};
}

std::string state_text(const Memory& memory) { return to_json(memory).dump(1); }

base::Outcome<void> write_state(const std::string& path, const Memory& memory) {
  auto file = base::OutputFile::create(path);
  if (!file) return tl::unexpected(file.error());
  (*file)->write(state_text(memory));
  (*file)->write("\n");
  return (*file)->commit(base::OutputFile::Durability::survives_power_loss);
}

}  // namespace kerf::machine
