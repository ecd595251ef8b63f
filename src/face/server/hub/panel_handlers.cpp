#include "face/server/hub/handlers.hpp"
#include "face/server/protocol/diagnostic_json.hpp"
#include "face/server/protocol/state_json.hpp"

namespace kerf::server {
namespace {

using base::Outcome;
using machine::LiveMachine;

Outcome<Json> done(const Outcome<void>& outcome) {
  if (!outcome) return tl::unexpected(outcome.error());
  return Json::object();
}

tl::unexpected<base::Failure> usage(const std::string& message) {
  return tl::unexpected(base::Failure{base::Failure::Kind::usage, message});
}

// A key that needs nothing but the machine.
template <Outcome<void> (LiveMachine::*Key)()>
void press(Hub& hub, const Request& request) {
  hub.on_machine(request, Pace::quick,
                 [](Runner& runner) { return done((runner.machine().*Key)()); });
}

void reset(Hub& hub, const Request& request) {
  hub.on_machine(request, Pace::quick, [](Runner& runner) -> Outcome<Json> {
    runner.machine().reset();
    return Json::object();
  });
}

void mode(Hub& hub, const Request& request) {
  const auto mode = machine::mode_named(request.arguments().text("mode"));
  hub.on_machine(request, Pace::quick,
                 [mode](Runner& runner) { return done(runner.machine().set_mode(*mode)); });
}

void turn_switch(Hub& hub, const Request& request) {
  const auto which = machine::switch_named(request.arguments().text("switch"));
  const bool on = request.arguments().flag("on");
  hub.on_machine(request, Pace::quick, [which, on](Runner& runner) {
    return done(runner.machine().set_switch(*which, on));
  });
}

// The run may be made again, and the preview leaves out the same blocks.
void block_skip(Hub& hub, const Request& request) {
  std::uint32_t levels = 0;
  for (const std::int64_t level : request.arguments().integers("levels"))
    levels |= 1U << static_cast<unsigned>(level);
  hub.on_machine(request, Pace::slow, [levels, &hub, name = request.machine->name](Runner& runner) {
    auto set = done(runner.machine().set_block_skip(levels));
    if (set) {
      hub.to_sockets([&hub, name] {
        if (MachineRecord* const machine = hub.find(name)) hub.renew_preview(*machine);
      });
    }
    return set;
  });
}

// Likewise.
void interrupt(Hub& hub, const Request& request) {
  hub.on_machine(request, Pace::slow,
                 [](Runner& runner) { return done(runner.machine().interrupt()); });
}

void set_input(Hub& hub, const Request& request) {
  const Arguments arguments = request.arguments();
  hub.on_machine(request, Pace::quick,
                 [&hub, machine = request.machine->name,
                  name = "#" + std::to_string(arguments.integer("input")),
                  value = arguments.number("value")](Runner& runner) {
                   auto set = done(runner.machine().set_input(name, value));
                   if (set) {
                     hub.to_sockets([&hub, machine] {
                       if (MachineRecord* const found = hub.find(machine))
                         found->is_preview_out_of_date = true;
                     });
                   }
                   return set;
                 });
}

void override_dials(Hub& hub, const Request& request) {
  hub.on_machine(request, Pace::quick, [body = request.body](Runner& runner) {
    const Arguments arguments(*body);
    machine::OverrideDials dials = runner.machine().snapshot()->panel.dials;
    const auto turn = [&](const char* name, int& dial) {
      if (arguments.has(name)) dial = static_cast<int>(arguments.integer(name));
    };
    turn("feed", dials.feed);
    turn("rapid", dials.rapid);
    turn("spindle", dials.spindle);
    return done(runner.machine().set_dials(dials));
  });
}

void jog(Hub& hub, const Request& request) {
  hub.on_machine(request, Pace::quick, [body = request.body](Runner& runner) -> Outcome<Json> {
    const Arguments arguments(*body);
    const std::string axis = arguments.text("axis");
    const double speed = arguments.number("speed_mm_min");
    if (speed == 0) return usage("jog: a speed of 0 moves nothing");
    if (!arguments.has("distance_mm")) return done(runner.machine().jog(axis, speed));
    const double distance = arguments.number("distance_mm");
    return done(runner.machine().jog_by(axis, speed < 0 ? -distance : distance, std::abs(speed)));
  });
}

void mdi(Hub& hub, const Request& request) {
  hub.on_machine(request, Pace::quick, [text = request.arguments().text("text")](Runner& runner) {
    return done(runner.machine().mdi(text));
  });
}

void enter(Hub& hub, const Request& request) {
  hub.on_machine(request, Pace::quick, [text = request.arguments().text("text")](Runner& runner) {
    return done(runner.machine().enter(text));
  });
}

// Back: the run is made again from its start, which may take a while.
void step(Hub& hub, const Request& request) {
  const std::string how = request.arguments().text("how");
  if (how == "back") {
    hub.on_machine(request, Pace::slow,
                   [](Runner& runner) { return done(runner.machine().step_back()); });
    return;
  }
  const machine::Step step = how == "over"   ? machine::Step::over
                             : how == "into" ? machine::Step::into
                                             : machine::Step::out;
  hub.on_machine(request, Pace::quick,
                 [step](Runner& runner) { return done(runner.machine().step(step)); });
}

void run_to(Hub& hub, const Request& request) {
  const Arguments arguments = request.arguments();
  hub.on_machine(request, Pace::quick,
                 [file = arguments.text("file"), line = arguments.integer("line")](Runner& runner) {
                   return done(runner.machine().run_to(file, static_cast<std::uint32_t>(line)));
                 });
}

void start_at(Hub& hub, const Request& request) {
  hub.on_machine(request, Pace::slow, [line = request.arguments().integer("line")](Runner& runner) {
    return done(runner.machine().start_at(static_cast<std::uint32_t>(line)));
  });
}

Outcome<std::vector<machine::Breakpoint>> breakpoints_of(const Arguments& arguments) {
  std::vector<machine::Breakpoint> list;
  for (const Arguments& entry : arguments.list("list")) {
    if (entry.has("line") == entry.has("variable"))
      return usage("breakpoints: each has either a line or a variable");
    list.push_back({entry.text("file"), static_cast<std::uint32_t>(entry.integer("line")),
                    entry.text("condition"), entry.text("variable")});
  }
  return list;
}

void breakpoints(Hub& hub, const Request& request) {
  const auto list = breakpoints_of(request.arguments());
  if (!list) return request.reply.no(list.error().message);
  hub.on_machine(
      request, Pace::quick,
      [&hub, list = *list, name = request.machine->name](Runner& runner) -> Outcome<Json> {
        if (auto set = runner.machine().set_breakpoints(list); !set)
          return tl::unexpected(set.error());
        Json told = Json::array();
        for (const machine::Breakpoint& each : runner.machine().breakpoints())
          told.push_back(breakpoint_json(each));
        hub.to_sockets([&hub, name, told, list] {
          if (MachineRecord* const machine = hub.find(name)) {
            machine->breakpoints = told;
            machine->breakpoint_list = list;
          }
        });
        return Json{{"list", told}};
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
  hub.on_machine(
      request, Pace::quick,
      [what = capture_named(arguments.text("kind")), name = arguments.text("name")](
          Runner& runner) { return taught_outcome(runner.machine().capture(what, name)); });
}

void teach_record(Hub& hub, const Request& request) {
  hub.on_machine(request, Pace::quick, [text = request.arguments().text("text")](Runner& runner) {
    return taught_outcome(runner.machine().teach_record(text));
  });
}

void teach_back(Hub& hub, const Request& request) {
  hub.on_machine(request, Pace::quick,
                 [](Runner& runner) { return taught_outcome(runner.machine().take_back()); });
}

void teach_new(Hub& hub, const Request& request) {
  hub.on_machine(request, Pace::quick, [](Runner& runner) -> Outcome<Json> {
    runner.machine().new_teaching();
    return taught_json(runner.machine().taught());
  });
}

}  // namespace

const Handlers& panel_handlers() {
  static const Handlers handlers = {
      {"mode", mode},
      {"cycle-start", press<&LiveMachine::cycle_start>},
      {"feed-hold", press<&LiveMachine::feed_hold>},
      {"reset", reset},
      {"interrupt", interrupt},
      {"set-input", set_input},
      {"switch", turn_switch},
      {"block-skip", block_skip},
      {"override", override_dials},
      {"jog", jog},
      {"jog-stop", press<&LiveMachine::jog_stop>},
      {"home", press<&LiveMachine::home>},
      {"mdi", mdi},
      {"enter", enter},
      {"step", step},
      {"run-to", run_to},
      {"start-at", start_at},
      {"breakpoints", breakpoints},
      {"teach-capture", capture},
      {"teach-record", teach_record},
      {"teach-back", teach_back},
      {"teach-new", teach_new},
  };
  return handlers;
}

}  // namespace kerf::server
