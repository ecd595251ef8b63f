#include "face/server/hub/machine_record.hpp"

#include "face/server/hub/client.hpp"
#include "face/server/protocol/diagnostic_json.hpp"
#include "face/server/protocol/state_json.hpp"
#include "machine/dialect/program_look.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::server {
namespace {

Json suited_kinds(const machine::MachineDefinition& definition) {
  using machine::ProgramKind;
  Json kinds = Json::array();
  for (const ProgramKind kind :
       {ProgramKind::mill, ProgramKind::lathe, ProgramKind::lathe_c, ProgramKind::laser,
        ProgramKind::laser_basic, ProgramKind::teach, ProgramKind::pattern}) {
    if (machine::suits(definition, kind)) kinds.push_back(machine::name_of(kind));
  }
  return kinds;
}

// Of time between two previews: where the one before has come to its end, and where it has not.
constexpr double kPause_ms = 500;
constexpr double kLongPause_ms = 5000;

}  // namespace

MachineRecord::MachineRecord(const StoredMachine& stored, std::shared_ptr<Runner> runner_in,
                             MachineThread& thread_in)
    : name(stored.name),
      kind(stored.kind),
      toml(stored.toml),
      definition(stored.definition),
      runner(std::move(runner_in)),
      thread(&thread_in),
      program(stored.program) {}

bool MachineRecord::wants_preview(double now_ms) const {
  if (!is_preview_out_of_date || !path) return false;
  if (!path->done) return now_ms - preview_began_ms >= kLongPause_ms;
  return path->has_read_inputs && now_ms - preview_began_ms >= kPause_ms;
}

void MachineRecord::touch() {
  ++touched_;
  for (Client* const watcher : watchers) watcher->wake();
}

const StateDocument& MachineRecord::state() {
  if (documented_ == touched_ || !snapshot) return document_;
  documented_ = touched_;
  Json json = state_json(*snapshot, definition);
  // Before a program has run the machine names no file.
  if (snapshot->file.empty() && program) json["file"] = file_label(program->name);
  const bool whole = path && path->done && path->error.is_null();
  json["total_s"] = whole ? Json(path->totals.time_s) : Json(nullptr);
  json["preview_run"] = preview_run;
  json["operator"] = op != nullptr ? Json(op->name()) : Json(nullptr);
  json["clients"] = Json::array();
  json["people"] = Json::object();
  for (const Client* const watcher : watchers) {
    json["clients"].push_back(watcher->name());
    if (!watcher->person.empty()) json["people"][watcher->name()] = watcher->person;
  }
  json["request"] = request
                        ? Json{{"client", request->client->name()}, {"until_ms", request->until_ms}}
                        : Json(nullptr);
  json["fault"] = fault.empty() ? Json(nullptr) : Json(fault);
  json["unsaved"] = unsaved.empty() ? Json(nullptr) : Json(unsaved);
  document_.update(json);
  return document_;
}

Json MachineRecord::path_event() const {
  Json json = {{"event", "path"}, {"machine", name}, {"run", path->run}, {"done", path->done}};
  const output::PathTotals& totals = path->totals;
  json["motions"] = totals.motions;
  json["vertices"] = totals.vertices;
  json["time_s"] = totals.time_s;
  json["bounds"] =
      totals.vertices > 0 ? Json{{"min", totals.low}, {"max", totals.high}} : Json(nullptr);
  json["files"] = path->files;
  json["dialect"] = dialect();
  json["error"] = path->error;
  json["findings"] = path->findings;
  json["stop"] = path->stop;
  json["cut_short"] = path->is_cut_short;
  return json;
}

const std::string& MachineRecord::dialect() const {
  return program && !program->dialect.empty() ? program->dialect : definition.dialect;
}

Json MachineRecord::row() const {
  return {{"name", name},
          {"title", output::printable(definition.description)},
          {"definition", kind},
          {"status", snapshot ? Json(machine::name_of(snapshot->status)) : Json("idle")},
          {"program", program ? Json(program->name) : Json(nullptr)},
          {"operator", op != nullptr ? Json(op->name()) : Json(nullptr)},
          {"clients", watchers.size()},
          {"suits", suited_kinds(definition)}};
}

}  // namespace kerf::server
