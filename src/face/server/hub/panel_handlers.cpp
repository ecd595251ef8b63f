#include "face/server/hub/handlers.hpp"
#include "face/server/protocol/diagnostic_json.hpp"
#include "face/server/protocol/state_json.hpp"

namespace kerf::server {
namespace {

using base::Outcome;
using machine::LiveMachine;
using machine::Operation;

// What takes as long as the run up to now: it may be made again.
Pace pace_of(const Operation& key) {
  const bool again = std::holds_alternative<machine::SetBlockSkip>(key) ||
                     std::holds_alternative<machine::Interrupt>(key) ||
                     std::holds_alternative<machine::StepBack>(key) ||
                     std::holds_alternative<machine::StartAt>(key);
  return again ? Pace::slow : Pace::quick;
}

// What it means for the preview, which leaves out the same blocks and reads the same inputs.
using Effect = void (*)(Hub& hub, MachineRecord& machine);
Effect effect_of(const Operation& key) {
  if (std::holds_alternative<machine::SetBlockSkip>(key))
    return [](Hub& hub, MachineRecord& machine) { hub.previews().renew(machine.name); };
  if (std::holds_alternative<machine::SetInput>(key))
    return [](Hub& /*hub*/, MachineRecord& machine) { machine.is_preview_out_of_date = true; };
  return nullptr;
}

Json told(const std::vector<machine::Breakpoint>& breakpoints) {
  Json list = Json::array();
  for (const machine::Breakpoint& each : breakpoints) list.push_back(breakpoint_json(each));
  return list;
}

// They are kept for a machine that is made anew.
void breakpoints(Hub& hub, const Request& request) {
  const auto key = key_of(request);
  if (!key) return request.reply.no(key.error());
  hub.orders().give(
      request, Pace::quick,
      [&hub, key = *key, name = request.machine->name](Runner& runner) -> Outcome<Json> {
        if (auto set = runner.machine().perform(key); !set) return tl::unexpected(set.error());
        const std::vector<machine::Breakpoint>& list = runner.machine().breakpoints();
        hub.answers().to_sockets([&hub, name, list] {
          MachineRecord* const machine = hub.machines().find(name);
          if (machine == nullptr) return;
          machine->breakpoints = told(list);
          machine->breakpoint_list = list;
        });
        return Json{{"list", told(list)}};
      });
}

Json taught_json(const LiveMachine::Taught& taught) {
  return {{"text", taught.text}, {"line", taught.line}};
}

Outcome<Json> taught_outcome(const Outcome<LiveMachine::Taught>& taught) {
  if (!taught) return tl::unexpected(taught.error());
  return taught_json(*taught);
}

LiveMachine::Capture capture_named(const std::string& kind) {
  if (kind == "point") return LiveMachine::Capture::point;
  if (kind == "line") return LiveMachine::Capture::line;
  if (kind == "arc-via") return LiveMachine::Capture::arc_via;
  if (kind == "arc-end") return LiveMachine::Capture::arc_end;
  return LiveMachine::Capture::circle_end;
}

void capture(Hub& hub, const Request& request) {
  const Arguments arguments = request.arguments();
  hub.orders().give(
      request, Pace::quick,
      [what = capture_named(arguments.text("kind")), name = arguments.text("name")](
          Runner& runner) { return taught_outcome(runner.machine().capture(what, name)); });
}

void teach_record(Hub& hub, const Request& request) {
  hub.orders().give(request, Pace::quick,
                    [text = request.arguments().text("text")](Runner& runner) {
                      return taught_outcome(runner.machine().teach_record(text));
                    });
}

void teach_back(Hub& hub, const Request& request) {
  hub.orders().give(request, Pace::quick,
                    [](Runner& runner) { return taught_outcome(runner.machine().take_back()); });
}

void teach_new(Hub& hub, const Request& request) {
  hub.orders().give(request, Pace::quick, [](Runner& runner) -> Outcome<Json> {
    runner.machine().new_teaching();
    return taught_json(runner.machine().taught());
  });
}

}  // namespace

Outcome<Json> done(const Outcome<void>& outcome) {
  if (!outcome) return tl::unexpected(outcome.error());
  return Json::object();
}

base::Outcome<Operation> key_of(const Request& request) {
  return machine::find_operation((*request.body)["do"].get<std::string>())
      ->read(request.arguments());
}

void press(Hub& hub, const Request& request) {
  const auto key = key_of(request);
  if (!key) return request.reply.no(key.error());
  hub.orders().give(request, pace_of(*key),
                    [&hub, key = *key, name = request.machine->name](Runner& runner) {
                      auto pressed = done(runner.machine().perform(key));
                      const Effect effect = effect_of(key);
                      if (!pressed || effect == nullptr) return pressed;
                      hub.answers().to_sockets([&hub, name, effect] {
                        if (MachineRecord* const machine = hub.machines().find(name))
                          effect(hub, *machine);
                      });
                      return pressed;
                    });
}

const Handlers& panel_handlers() {
  static const Handlers handlers = {
      {"breakpoints", breakpoints}, {"teach-capture", capture}, {"teach-record", teach_record},
      {"teach-back", teach_back},   {"teach-new", teach_new},
  };
  return handlers;
}

}  // namespace kerf::server
