#include "face/server/hub/handlers.hpp"
#include "face/server/hub/speed_profile.hpp"
#include "face/server/protocol/diagnostic_json.hpp"
#include "face/server/protocol/language_json.hpp"
#include "face/server/protocol/pattern_text.hpp"
#include "face/server/protocol/state_json.hpp"
#include "job/run.hpp"
#include "machine/dialect/registry.hpp"

namespace kerf::server {
namespace {

using base::Outcome;

void instant(Hub& hub, const Request& request) {
  hub.orders().give(
      request, Pace::slow,
      [time_s = request.arguments().number("time_s")](Runner& runner) -> Outcome<Json> {
        auto& machine = runner.machine();
        const auto snapshot = machine.state_at(time_s);
        if (!snapshot) return tl::unexpected(snapshot.error());
        Json json = state_json(**snapshot, machine.definition());
        json.update(variables_json(machine.variables_at_state()));
        return json;
      });
}

void speeds(Hub& hub, const Request& request) {
  const Arguments arguments = request.arguments();
  const SpeedQuestion question{arguments.number("from_s"), arguments.number("to_s"),
                               static_cast<std::size_t>(arguments.integer("points"))};
  if (question.to_s < question.from_s)
    return request.reply.no("speeds: `to_s` comes before `from_s`");
  if (!request.machine->preview) return request.reply.no(base::Refusal::no_program);
  hub.background().compute(request,
                           [question, chunks = request.machine->preview->chunks()](
                               const base::WorkLimit& limit) -> Outcome<Json> {
                             auto profile = speed_profile(*chunks, question, limit);
                             if (!limit.reached()) return profile;
                             return tl::unexpected(base::refuse(base::Refusal::path_too_long, {}));
                           });
}

// Its program is read from the disk.
void journal(Hub& hub, const Request& request) {
  hub.orders().give(request, Pace::slow, [](Runner& runner) -> Outcome<Json> {
    auto text = runner.machine().journal();
    if (!text) return tl::unexpected(text.error());
    return Json{{"name", runner.name() + ".journal.json"}, {"text", std::move(*text)}};
  });
}

void pulses(Hub& hub, const Request& request) {
  hub.orders().give(
      request, Pace::slow,
      [seconds = request.arguments().number("seconds")](Runner& runner) -> Outcome<Json> {
        return runner.pulses().edges(seconds);
      });
}

// What stands in the way of a text shows without running it; the machine is one of its own.
Outcome<Json> diagnostics_of(const machine::MachineDefinition& definition, const std::string& name,
                             const std::string& text, const base::WorkLimit& limit) {
  auto file = base::SourceFile::from_text(name, text);
  const job::Job job{.definition = definition,
                     .memory = control::Memory(definition.parameters.n_offsets),
                     .settings = {.dialect = machine::dialect_shown_by(*file)}};
  auto run = job::Run::of(job, std::move(file));
  if (!run) return tl::unexpected(run.error());
  machine::Machine& machine = (*run)->machine();
  base::Findings found(limits::kDiagnostics, limit);
  machine.check(found);
  Json list = Json::array();
  for (const base::Diagnostic& each : found.list())
    list.push_back(diagnostic_json(each, machine.sources()));
  return Json{{"diagnostics", std::move(list)}, {"more", found.more()}};
}

// Where none is watched.
std::string usual_machine_of(const std::string& name) {
  const machine::DialectRow& row = is_pattern(name)
                                       ? *machine::find_dialect(machine::kPatternDialect)
                                       : machine::usual_dialect();
  return std::string(row.machine);
}

void check(Hub& hub, const Request& request) {
  const Arguments arguments = request.arguments();
  const MachineRecord* machine = request.machine;
  if (arguments.has("machine")) {
    machine = hub.machines().find(arguments.text("machine"));
    if (machine == nullptr)
      return request.reply.no("there is no machine " + arguments.text("machine"));
  }
  const auto definition = machine != nullptr
                              ? Outcome<machine::MachineDefinition>(machine->definition)
                              : machine::find_machine(usual_machine_of(arguments.text("name")));
  if (!definition) return request.reply.no(definition.error().message);
  hub.background().compute(request,
                           [definition = *definition,
                            body = request.body](const base::WorkLimit& limit) -> Outcome<Json> {
                             const Arguments asked(*body);
                             return diagnostics_of(definition, asked.text("name"),
                                                   asked.text("text"), limit);
                           });
}

void dialect(Hub& /*hub*/, const Request& request) {
  const Arguments arguments = request.arguments();
  std::string shown = machine::dialect_shown_by(
      *base::SourceFile::from_text(arguments.text("name"), arguments.text("text")));
  if (shown.empty() && request.machine != nullptr) shown = request.machine->definition.dialect;
  if (shown.empty()) shown = machine::usual_dialect().name;
  request.reply.yes({{"dialect", shown}});
}

// At once: it is no more work than to read the command, and who types waits for it.
void tokens(Hub& /*hub*/, const Request& request) {
  const Arguments arguments = request.arguments();
  const auto* const row = machine::find_dialect(arguments.text("dialect"));
  request.reply.yes({{"tokens", tokens_json(*row->language, arguments.text("lines"))}});
}

}  // namespace

const Handlers& view_handlers() {
  static const Handlers handlers = {{"instant", instant}, {"speeds", speeds}, {"pulses", pulses},
                                    {"journal", journal}, {"check", check},   {"dialect", dialect},
                                    {"tokens", tokens}};
  return handlers;
}

}  // namespace kerf::server
