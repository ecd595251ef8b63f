#include "face/server/hub/internal/feature_edits.hpp"

#include <utility>

#include "base/diagnostic.hpp"
#include "face/server/hub/guarded.hpp"
#include "job/edit_undo.hpp"
#include "job/facts_of_edit.hpp"
#include "job/text_changes.hpp"
#include "output/features/edit_report.hpp"

namespace kerf::server {
namespace {

using base::Failure;
using base::Outcome;

constexpr std::uint64_t kMostText = 256UL << 20U;

/// As refusals are told: who has other words for it knows it by its code.
Failure failure_of(const output::EditPreview::Problem& problem) {
  Failure failure{Failure::Kind::usage, problem.message};
  failure.code = problem.code;
  failure.values = {{"edit", problem.edit ? std::to_string(*problem.edit) : ""},
                    {"line", std::to_string(problem.line)},
                    {"column", std::to_string(problem.column)},
                    {"hint", problem.hint}};
  return failure;
}

/// `line`: of the text, the first that is another; 0: nobody knows.
Failure changed_since(std::uint32_t line) {
  const base::Diagnostic error = base::make_error(base::Code::edit_changed_since, {});
  Failure failure{Failure::Kind::usage, error.message};
  if (line > 0) failure.message += ": LINE " + std::to_string(line);
  failure.code = error.number;
  failure.values = {{"line", std::to_string(line)}};
  return failure;
}

/// Why nothing is written or loaded now; the machine itself is asked again when it is.
std::optional<Failure> busy(const MachineRecord& machine) {
  if (!machine.program) return base::refuse(base::Refusal::no_program);
  if (machine.snapshot && machine.snapshot->status == machine::Status::running)
    return base::refuse(base::Refusal::running);
  return std::nullopt;
}

/// What the library has under a name; nothing: there is none.
Outcome<std::optional<std::string>> text_in(const Library& library, const std::string& name) {
  using Text = std::optional<std::string>;
  const auto path = library.path_of(name);
  if (!path && path.error().code == base::refuse(base::Refusal::no_library_program, {""}).code)
    return Text();
  if (!path) return tl::unexpected(path.error());
  auto text = base::read_whole(*path, kMostText, "a program");
  if (!text) return tl::unexpected(text.error());
  return Text(std::move(*text));
}

/// A program that was loaded as a text is not in the library yet: what the edit is made on becomes
/// a revision first, so that it can be had back.
Outcome<void> keep_before(Library& library, const LoadedProgram& program,
                          const std::string& before) {
  const auto there = text_in(library, program.name);
  if (!there) return tl::unexpected(there.error());
  if (*there == before) return {};
  if (!program.text) return tl::unexpected(changed_since(0));
  const auto kept = library.write(program.name, before);
  return kept ? Outcome<void>{} : tl::unexpected(kept.error());
}

Json library_json(const Revision& revision, const std::string& name) {
  return {{"name", name}, {"library_revision", revision.number}};
}

Json revision_json(const MachineRecord& machine) {
  return {{"revision", machine.feature_revision}};
}

/// What the loaded program was before its last edit.
Outcome<UneditedProgram> unedited(Library& library, const LoadedProgram& program) {
  const auto edit = library.last_edit(program.name);
  if (!edit) return tl::unexpected(edit.error());
  if (!*edit) return tl::unexpected(base::refuse(base::Refusal::nothing_to_undo, {program.name}));
  Outcome<std::optional<std::string>> text = program.text;
  if (!program.text) text = text_in(library, program.name);
  if (!text) return tl::unexpected(text.error());
  const auto undo = job::read_edit_report((*edit)->report);
  if (!undo || !*text) return tl::unexpected(changed_since(0));
  const auto stretches = job::undo_of(undo->front(), **text);
  if (!stretches) return tl::unexpected(changed_since(stretches.error().line));
  return UneditedProgram{job::with_stretches(**text, *stretches), **edit};
}

}  // namespace

// Made

void FeatureEdits::apply(const Request& request) {
  thread_.here();
  if (const auto why = busy(*request.machine)) return request.reply.no(*why);
  around_.features.with_scene(*request.machine,
                              [this, request](const Outcome<Features::Scene>& scene) {
                                if (!scene) return request.reply.no(scene.error());
                                verify(request, *scene);
                              });
}

void FeatureEdits::verify(const Request& request, const Features::Scene& scene) {
  const auto work = [this, request, scene] {
    const auto made = guarded([&] {
      return job::make_edits(***scene->made, request.arguments().text("edits"), request.unwanted());
    });
    if (!made) return around_.answers.answer(request.reply, tl::unexpected(made.error()));
    if (!*made)
      return around_.answers.answer(request.reply, tl::unexpected(failure_of((*made).error())));
    around_.answers.to_sockets(
        [this, request, scene, result = **made] { verified(request, scene, result); });
  };
  around_.worker.post({.work = work, .unwanted = request.unwanted(), .owner = scene.get()});
}

// What was verified is an edit of the scene: of nothing that has been loaded meanwhile.
void FeatureEdits::verified(const Request& request, const Features::Scene& scene,
                            const job::EditResult& result) {
  thread_.here();
  MachineRecord* const machine = request.client->watched();
  if (machine == nullptr || machine != request.machine || machine->scene != scene)
    return request.reply.no(changed_since(0));
  if (const auto why = busy(*machine)) return request.reply.no(*why);
  const std::string report = output::edit_report_json(job::facts_of(result));
  const Json told = Json::parse(report);
  if (result.texts.empty()) {
    return request.reply.yes({{"report", told},
                              {"name", machine->program->name},
                              {"library_revision", nullptr},
                              {"revision", scene->revision}});
  }
  const job::EditedText& text = result.texts.front();
  const auto write = [program = *machine->program, before = text.before, after = text.after, report,
                      told](Library& library) -> Outcome<Json> {
    if (auto kept = keep_before(library, program, before); !kept)
      return tl::unexpected(kept.error());
    const auto written = library.write_edited(program.name, after, report);
    if (!written) return tl::unexpected(written.error());
    Json answer{{"report", told}};
    answer.update(library_json(*written, program.name));
    return answer;
  };
  around_.programs.load_made(
      *machine, request.reply,
      {machine->program->name, text.after, machine->program->dialect, write, revision_json});
}

// Taken back

void FeatureEdits::undo(const Request& request) {
  thread_.here();
  if (const auto why = busy(*request.machine)) return request.reply.no(*why);
  around_.disk.post([this, request, program = *request.machine->program,
                     revision = request.machine->feature_revision] {
    const auto before = guarded([&] { return unedited(around_.library, program); });
    if (!before) return around_.answers.answer(request.reply, tl::unexpected(before.error()));
    around_.answers.to_sockets([this, request, program, revision, before = *before] {
      if (request.client->watched() == request.machine &&
          request.machine->feature_revision == revision)
        return take_back(request, program, before);
      request.reply.no(changed_since(0));
    });
  });
}

// Looked at once more where it is written: something else may have been saved since.
void FeatureEdits::take_back(const Request& request, const LoadedProgram& program,
                             const UneditedProgram& before) {
  const auto write = [program, before](Library& library) -> Outcome<Json> {
    const auto now = unedited(library, program);
    if (!now) return tl::unexpected(now.error());
    if (now->edit.number != before.edit.number || now->text != before.text)
      return tl::unexpected(changed_since(0));
    const auto written = library.write_unedited(program.name, before.text, before.edit);
    if (!written) return tl::unexpected(written.error());
    Json answer{{"left", before.edit.before}};
    answer.update(library_json(*written, program.name));
    return answer;
  };
  around_.programs.load_made(*request.machine, request.reply,
                             {program.name, before.text, program.dialect, write, revision_json});
}

}  // namespace kerf::server
