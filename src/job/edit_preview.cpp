#include "job/edit_preview.hpp"

#include "base/diagnostic.hpp"
#include "job/edits_file.hpp"
#include "job/facts_of_edit.hpp"
#include "job/internal/edited_areas.hpp"
#include "job/internal/edited_paths.hpp"
#include "job/text_changes.hpp"
#include "output/features/edit_report.hpp"
#include "output/programs/unified_diff.hpp"

namespace kerf::job {
namespace {

using base::Code;
using features::EditFault;
using Problem = output::EditPreview::Problem;

Problem problem_of(const EditsFileFault& fault) {
  const base::Diagnostic error = base::make_error(Code::edit_file, {}, fault.sentence);
  return {.edit = std::nullopt,
          .line = fault.line,
          .column = fault.column,
          .code = error.number,
          .message = error.message,
          .hint = {},
          .at = std::nullopt};
}

Problem problem_of(const EditFault& fault, const std::vector<features::Edit>& edits) {
  const base::Diagnostic error = base::make_error(fault.code, {});
  Problem problem{.edit = fault.edit,
                  .code = error.number,
                  .message = fault.sentence.empty() ? error.message : fault.sentence,
                  .hint = fault.hint,
                  .at = fault.at};
  if (fault.edit >= edits.size()) return problem;
  problem.line = edits[fault.edit].line;
  problem.column = edits[fault.edit].column;
  return problem;
}

/// A program that does not reach its end is not edited.
std::optional<EditFault> unfinished(const FeaturesResult& result) {
  if (result.status == machine::RunStatus::alarm) {
    const auto& alarm = result.run->machine().alarm();
    return EditFault{.code = Code::edit_not_editable,
                     .sentence = "THE PROGRAM ENDS IN AN ALARM" +
                                 (alarm ? ": " + alarm->number + " " + alarm->message : "")};
  }
  if (result.status != machine::RunStatus::budget) return std::nullopt;
  return EditFault{.code = Code::edit_not_editable,
                   .sentence = "THE PROGRAM WAS NOT RUN TO ITS END: IT TAKES TOO LONG"};
}

std::string diff_of(const EditResult& result) {
  std::string diff;
  for (const EditedText& text : result.texts) {
    if (const auto stretches = stretches_of(text.before, result.report.changes))
      diff += output::unified_diff(text.file, text.before, *stretches);
  }
  return diff;
}

std::vector<output::EditPreview::Outline> outlines_of(const features::EditSketch& sketch) {
  std::vector<output::EditPreview::Outline> outlines;
  for (const features::EditSketch::Outline& one : sketch.contours) {
    output::EditPreview::Outline outline{
        .of = {"F" + std::to_string(one.feature + 1), one.layer + 1},
        .island = one.contour.island,
        .is_closed = one.contour.is_closed,
        .elements = {}};
    for (const features::Outline::Step& step : one.contour.elements)
      outline.elements.push_back({step.element, step.edge});
    outlines.push_back(std::move(outline));
  }
  return outlines;
}

output::EditPreview::Cut cut_of(const EditScene& scene, const EditDraft& draft) {
  const FeaturesResult& before = scene.features();
  output::EditPreview::Cut cut;
  cut.loops = edited_paths(before.recording, before.tree, draft.plan);
  add_edited_areas(before.recording, before.tree, draft.plan, cut);
  cut.diff = diff_of(draft.result);
  cut.edit = facts_of(draft.result);
  return cut;
}

}  // namespace

base::Outcome<output::EditPreview> preview_edits(const EditScene& scene, const std::string& edits,
                                                 PreviewUntil until,
                                                 const std::stop_token& unwanted) {
  output::EditPreview preview;
  const auto read = read_edits(edits, scene.features().recording.turns);
  if (!read) {
    preview.problem = problem_of(read.error());
    return preview;
  }
  features::EditSketch sketch = scene.sketch(*read);
  preview.contours = outlines_of(sketch);
  if (const auto early = unfinished(scene.features())) sketch.fault = *early;
  if (sketch.fault) preview.problem = problem_of(*sketch.fault, *read);
  if (preview.problem || until == PreviewUntil::contour || unwanted.stop_requested())
    return preview;
  auto draft = scene.draft({.edits = *read});
  if (!draft) {
    preview.problem = problem_of(draft.error(), *read);
    return preview;
  }
  if (unwanted.stop_requested()) return preview;
  preview.cut = cut_of(scene, *draft);
  if (until == PreviewUntil::paths || unwanted.stop_requested()) return preview;
  auto verified = scene.verified(std::move(*draft), unwanted);
  if (!verified) return tl::unexpected(verified.error());
  if (*verified) {
    preview.report = output::edit_report_json(facts_of(**verified));
  } else {
    preview.problem = problem_of(verified->error(), *read);
  }
  return preview;
}

base::Outcome<MadeEdit> make_edits(const EditScene& scene, const std::string& edits,
                                   const std::stop_token& unwanted) {
  const auto read = read_edits(edits, scene.features().recording.turns);
  if (!read) return MadeEdit(tl::unexpected(problem_of(read.error())));
  const auto refused = [&](const EditFault& fault) {
    return MadeEdit(tl::unexpected(problem_of(fault, *read)));
  };
  if (const auto early = unfinished(scene.features())) return refused(*early);
  auto draft = scene.draft({.edits = *read});
  if (!draft) return refused(draft.error());
  auto verified = scene.verified(std::move(*draft), unwanted);
  if (!verified) return tl::unexpected(verified.error());
  if (!*verified) return refused(verified->error());
  return MadeEdit(std::move(**verified));
}

}  // namespace kerf::job
