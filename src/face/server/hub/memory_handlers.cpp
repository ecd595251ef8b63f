#include <cmath>

#include "control/core/offset_parts.hpp"
#include "face/server/hub/handlers.hpp"
#include "face/server/protocol/state_json.hpp"

namespace kerf::server {
namespace {

using base::Outcome;

std::optional<std::size_t> level_of(const Arguments& arguments) {
  if (!arguments.has("level")) return std::nullopt;
  return static_cast<std::size_t>(arguments.integer("level"));
}

void variables(Hub& hub, const Request& request) {
  hub.orders().give(request, Pace::quick, [body = request.body](Runner& runner) -> Outcome<Json> {
    const Arguments arguments(*body);
    if (!arguments.has("names"))
      return variables_json(runner.machine().variables(level_of(arguments)));
    return variables_json(
        runner.machine().variables_named(arguments.texts("names"), level_of(arguments)));
  });
}

// Where the control has read ahead the run is made again, which may take a while.
void set_variable(Hub& hub, const Request& request) {
  const auto key = key_of(request);
  if (!key) return request.reply.no(key.error());
  const auto before = std::make_shared<machine::SetVariable>(std::get<machine::SetVariable>(*key));
  before->value.reset();
  const auto act = [key = *key, before](Runner& runner) {
    const auto old = runner.machine().variables_named({before->name}, before->level);
    if (!old.rows.empty() && !std::isnan(old.rows[0].value)) before->value = old.rows[0].value;
    return done(runner.machine().perform(key));
  };
  const auto undo = [before](machine::LiveMachine& machine) {
    static_cast<void>(machine.perform(*before));
  };
  hub.orders().give_durably(request, {act, undo, {}}, Pace::slow);
}

// Rows of one work coordinate system, an axis each.
void add_system(Json& rows, const std::string& name, const base::AxisVector& origin,
                const motion::AxisSetup& axes) {
  for (std::size_t i = 0; i < axes.count(); ++i)
    rows.push_back({{"offset", name},
                    {"axis", std::string(1, axes.axes[i].letter)},
                    {"value", origin.values[i]}});
}

// Of the 300 further systems only those that somebody has set.
Json offsets_json(const control::Memory& memory, const motion::AxisSetup& axes) {
  Json rows = Json::array();
  add_system(rows, "EXT", memory.external, axes);
  for (std::size_t i = 0; i < memory.work.size(); ++i)
    add_system(rows, "G" + std::to_string(54 + i), memory.work[i], axes);
  for (std::size_t i = 0; i < memory.extended.size(); ++i) {
    if (memory.extended[i] != base::AxisVector{})
      add_system(rows, "G54.1 P" + std::to_string(i + 1), memory.extended[i], axes);
  }
  return rows;
}

void offsets(Hub& hub, const Request& request) {
  hub.orders().give(request, Pace::quick, [](Runner& runner) -> Outcome<Json> {
    const auto& machine = runner.machine();
    return Json{{"offsets", offsets_json(machine.memory(), machine.definition().axes)}};
  });
}

void set_offset(Hub& hub, const Request& request) {
  const auto key = key_of(request);
  if (!key) return request.reply.no(key.error());
  const auto act = [key = *key](Runner& runner) { return done(runner.machine().perform(key)); };
  hub.orders().give_durably(
      request, {act, {}, [&hub, name = request.machine->name] { hub.previews().renew(name); }});
}

template <typename Row>
Json tools_json(const std::vector<Row>& table) {
  Json rows = Json::array();
  for (std::size_t i = 1; i < table.size(); ++i) {
    if (table[i] == Row{}) continue;
    Json& row = rows.emplace_back(Json{{"number", i}});
    for (const auto& part : control::parts_of(table[i]))
      row[std::string(part.name)] = part.value(table[i]);
  }
  return {{"tools", std::move(rows)}, {"count", table.empty() ? 0 : table.size() - 1}};
}

void tools(Hub& hub, const Request& request) {
  hub.orders().give(request, Pace::quick, [](Runner& runner) -> Outcome<Json> {
    const control::Memory memory = runner.machine().memory();
    return runner.machine().definition().turns() ? tools_json(memory.turning)
                                                 : tools_json(memory.tools);
  });
}

bool is_tool_part(std::string_view name) {
  return control::part_named<control::ToolOffset>(name) != nullptr ||
         control::part_named<control::TurningOffset>(name) != nullptr;
}

void set_tool(Hub& hub, const Request& request) {
  const auto act = [body = request.body](Runner& runner) -> Outcome<Json> {
    const Arguments arguments(*body);
    const std::string tool = "tool." + std::to_string(arguments.integer("number")) + ".";
    for (const auto& [part, value] : body->items()) {
      if (!is_tool_part(part)) continue;
      auto set = runner.machine().perform(
          machine::SetOffset{.offset = tool + part, .value = arguments.number(part.c_str())});
      if (!set) return tl::unexpected(set.error());
    }
    return Json::object();
  };
  hub.orders().give_durably(
      request, {act, {}, [&hub, name = request.machine->name] { hub.previews().renew(name); }});
}

void settings(Hub& /*hub*/, const Request& request) {
  request.reply.yes({{"toml", request.machine->toml}});
}

}  // namespace

const Handlers& memory_handlers() {
  static const Handlers handlers = {
      {"variables", variables},
      {"set-variable", set_variable},
      {"offsets", offsets},
      {"set-offset", set_offset},
      {"tools", tools},
      {"set-tool", set_tool},
      {"measure-offset", set_offset},
      {"settings", settings},
  };
  return handlers;
}

}  // namespace kerf::server
