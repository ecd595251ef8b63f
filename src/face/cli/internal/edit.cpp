#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "face/cli/commands.hpp"
#include "face/cli/failure.hpp"
#include "face/cli/internal/edit_arguments.hpp"
#include "face/cli/internal/edit_outputs.hpp"
#include "face/cli/internal/edits_source.hpp"
#include "face/cli/internal/undo.hpp"
#include "face/cli/operator_input.hpp"
#include "face/cli/run_report.hpp"
#include "face/cli/stock_order.hpp"
#include "face/cli/stock_table.hpp"
#include "job/edit_run.hpp"
#include "job/edit_undo.hpp"
#include "job/facts_of_edit.hpp"
#include "job/text_changes.hpp"
#include "output/features/edit_report.hpp"

namespace kerf::cli {
namespace {

using base::Outcome;

constexpr std::size_t kLargestProgram = 1UL << 30;

Outcome<std::string> whole(const base::ProgramText& program) {
  if (program.text) return *program.text;
  return base::read_whole(program.name, kLargestProgram, "a program");
}

std::vector<std::string> inputs_of(const EditOptions& options, const machine::SetUp& set_up) {
  std::vector<std::string> inputs = set_up.files();
  for (const std::string* const input : {&options.edits, &options.run.tools, &options.run.offsets,
                                         &options.run.state, &options.run.table.set_up})
    inputs.push_back(*input);
  if (options.run.machine.ends_with(".toml")) inputs.push_back(options.run.machine);
  return inputs;
}

std::vector<job::TextChange> changes_of(const std::string& file, const job::EditReport& report) {
  std::vector<job::TextChange> changes;
  std::copy_if(report.changes.begin(), report.changes.end(), std::back_inserter(changes),
               [&](const job::TextChange& change) { return change.file == file; });
  return changes;
}

// The changes of a report make the text, and give the old one back: else it would be of no use.
ChangedText changed(const job::EditedText& text, const job::EditReport& report) {
  const std::vector<job::TextChange> changes = changes_of(text.file, report);
  auto stretches = job::stretches_of(text.before, changes);
  const bool leads_there = stretches && job::with_stretches(text.before, *stretches) == text.after;
  const auto back = job::stretches_of(text.after, job::taken_back(changes));
  if (!leads_there || !back || job::with_stretches(text.after, *back) != text.before)
    throw std::logic_error("the changes of " + text.file + " are not those of its text");
  return {text.file, text.is_main, text.before, text.after, std::move(*stretches)};
}

/// The texts of a program behind an edit, its main text first, also where that stays as it is.
Outcome<std::vector<ChangedText>> texts_of(const EditOptions& options,
                                           const base::ProgramText& program,
                                           const job::EditResult& result) {
  std::vector<ChangedText> texts;
  for (const job::EditedText& text : result.texts) texts.push_back(changed(text, result.report));
  const auto main = std::find_if(texts.begin(), texts.end(),
                                 [](const ChangedText& text) { return text.is_main; });
  if (main != texts.end()) {
    std::rotate(texts.begin(), main, main + 1);
    return texts;
  }
  auto same = whole(program);
  if (!same) return tl::unexpected(same.error());
  texts.insert(texts.begin(), ChangedText{options.run.program, true, *same, *same, {}});
  return texts;
}

/// A file beside the program changes, and nobody has said where it shall go. Which of several edits
/// it is nobody knows.
std::optional<features::EditFault> other_file(const EditOptions& options,
                                              const std::vector<ChangedText>& texts,
                                              std::size_t edits) {
  const auto beside = std::find_if(texts.begin(), texts.end(), [](const ChangedText& text) {
    return !text.is_main && text.before != text.after;
  });
  if (beside == texts.end() || !options.output_library.empty()) return std::nullopt;
  return features::EditFault{
      .code = base::Code::edit_other_file,
      .sentence = "THE BLOCKS STAND IN " + beside->file,
      .hint =
          "--output-library names a folder for changed files; `\"scope\":\"this\"` writes the "
          "call out in the program",
      .edit = edits == 1 ? 0 : edits};
}

/// An edit that was asked for and verified goes where it was asked to go.
class Delivery {
 public:
  Delivery(const EditOptions& options, const EditsSource& edits, EditOutputs& outputs)
      : options_(options), edits_(edits), outputs_(outputs) {}

  ExitStatus deliver(const base::ProgramText& program, const job::EditResult& result) {
    auto texts = texts_of(options_, program, result);
    if (!texts) return fail(texts.error());
    if (const auto fault = other_file(options_, *texts, edits_.edits().size()))
      return refuse(*fault);
    const output::EditFacts facts = job::facts_of(result);
    if (auto written = outputs_.write(*texts, output::edit_report_json(facts)); !written)
      return fail(written.error());
    for (const features::EditFault& warning : result.report.warnings)
      edits_.tell(warning, base::Severity::warning, options_.run.diagnostics);
    if (options_.run.diagnostics == DiagnosticFormat::json) return ExitStatus::well;
    const std::string text = output::edit_report_text(facts) + outputs_.written();
    std::fwrite(text.data(), 1, text.size(), stderr);
    return ExitStatus::well;
  }

  ExitStatus refuse(const features::EditFault& fault) {
    edits_.tell(fault, base::Severity::error, options_.run.diagnostics);
    return fault.code == base::Code::budget_spent ? ExitStatus::budget : ExitStatus::findings;
  }

 private:
  const EditOptions& options_;
  const EditsSource& edits_;
  EditOutputs& outputs_;
};

ExitStatus make_edit(const EditOptions& options) {
  auto set_up = set_up_of(options.run.table);
  if (!set_up) return fail(set_up.error());
  EditOutputs outputs(options);
  if (auto opened = outputs.open(inputs_of(options, *set_up)); !opened) return fail(opened.error());
  auto edits = EditsSource::read(options.edits);
  if (!edits) return fail(edits.error());
  if (edits->fault()) {
    tell(*edits->fault(), edits->sources(), options.run.diagnostics);
    return ExitStatus::files;
  }
  auto order = order_on_table(options.run, std::move(*set_up));
  if (!order) return fail(order.error());
  order->job.job.input = kept_operator_input();
  auto ran =
      job::edit_features(order->job, {.edits = edits->edits(),
                                      .allows_collision = options.allows_collision,
                                      .allows_rest = options.allows_rest,
                                      .allows_other_files = !options.output_library.empty()});
  if (!ran) return fail(ran.error());
  order->ready.run = std::move(ran->run);
  report_diagnostics(order->ready, options.run.diagnostics);
  if (const ExitStatus status = exit_status_of(ran->status); status != ExitStatus::well)
    return status;
  Delivery delivery(options, *edits, outputs);
  return ran->edited ? delivery.deliver(order->job.job.program, *ran->edited)
                     : delivery.refuse(ran->edited.error());
}

}  // namespace

ExitStatus edit(const EditOptions& options) {
  if (auto right = check_edit(options); !right) return fail(right.error());
  return options.undo.empty() ? make_edit(options) : undo_edit(options);
}

}  // namespace kerf::cli
