#include <algorithm>
#include <cstdio>

#include "face/cli/commands.hpp"
#include "face/cli/failure.hpp"
#include "face/cli/internal/draw_order.hpp"
#include "face/cli/internal/draw_outputs.hpp"
#include "face/cli/output_files.hpp"
#include "face/cli/run_report.hpp"
#include "job/drawing/draw_run.hpp"
#include "job/drawing/drawn_texts.hpp"
#include "output/drawings/draw_report.hpp"
#include "output/drawings/draw_summary.hpp"

namespace kerf::cli {
namespace {

bool has(const std::vector<drawing::Finding>& findings, base::Severity severity) {
  return std::any_of(findings.begin(), findings.end(), [&](const drawing::Finding& finding) {
    return finding.diagnostic.severity == severity;
  });
}

bool has(const std::vector<drawing::Finding>& findings, base::Code code) {
  return std::any_of(findings.begin(), findings.end(), [&](const drawing::Finding& finding) {
    return finding.diagnostic.code == code;
  });
}

ExitStatus status_of(const DrawOptions& options, const std::vector<drawing::Finding>& findings) {
  if (has(findings, base::Code::draw_limit) || has(findings, base::Code::budget_spent))
    return ExitStatus::budget;
  if (has(findings, base::Severity::error)) return ExitStatus::findings;
  const bool counts_warnings = options.fail_on == "warning";
  return counts_warnings && has(findings, base::Severity::warning) ? ExitStatus::findings
                                                                   : ExitStatus::well;
}

void tell_all(const DrawOptions& options, const output::DrawFacts& facts,
              const base::SourceSet& sources) {
  for (const drawing::Finding& finding : facts.findings)
    if (sources.contains(finding.diagnostic.place.file) || finding.diagnostic.place.line == 0)
      tell(finding.diagnostic, sources, options.run.diagnostics);
  if (options.run.diagnostics == DiagnosticFormat::json) return;
  const std::string words = output::draw_summary(facts);
  std::fwrite(words.data(), 1, words.size(), stderr);
}

output::DrawFacts facts_of(const Ordered& ordered, const job::DrawnPlan& plan,
                           const job::DrawResult& made) {
  output::DrawFacts facts{.files = plan.file_names(),
                          .drawing = plan.drawing(),
                          .cleaned = plan.cleaned(),
                          .nests = plan.nests(),
                          .texts = plan.texts(),
                          .plan = &plan.plan(),
                          .made = made.made,
                          .made_by_operation = made.by_operation,
                          .targets = {},
                          .findings = plan.findings(),
                          .assumed = ordered.assumed};
  facts.findings.insert(facts.findings.end(), made.findings.begin(), made.findings.end());
  const std::vector<std::string>& assumed = plan.plan().assumed;
  // Places in the job are of one file more.
  const base::FileId job{static_cast<std::uint32_t>(facts.files.size())};
  if (!plan.job_findings().empty()) facts.files.push_back(ordered.order.recipe.source);
  for (base::Diagnostic wrong : plan.job_findings()) {
    wrong.place.file = job;
    facts.findings.push_back({std::move(wrong), {}, {}});
  }
  facts.assumed.insert(facts.assumed.end(), assumed.begin(), assumed.end());
  return facts;
}

ExitStatus fail_job(const JobFault& fault, const base::SourceSet& sources,
                    DiagnosticFormat format) {
  if (fault.failure) return fail(*fault.failure);
  for (const base::Diagnostic& wrong : fault.wrong) tell(wrong, sources, format);
  return ExitStatus::files;
}

}  // namespace

ExitStatus draw(const DrawOptions& options) {
  base::SourceSet job_sources;
  auto ordered = draw_order_of(options, job_sources);
  if (!ordered) return fail_job(ordered.error(), job_sources, options.run.diagnostics);
  auto plan = job::DrawnPlan::of(ordered->order);
  if (!plan) return fail(plan.error());
  DrawOutputs outputs(options, ordered->order, *plan);
  if (auto opened = outputs.open(); !opened) return fail(opened.error());
  const machine::Budget budget{options.run.max_seconds, options.run.max_motions};
  const job::DrawResult made = job::make_drawing(ordered->order, *plan, budget, outputs.watchers());
  output::DrawFacts facts = facts_of(*ordered, **plan, made);
  const bool job_is_wrong = std::any_of(
      (*plan)->job_findings().begin(), (*plan)->job_findings().end(),
      [](const base::Diagnostic& wrong) { return wrong.severity == base::Severity::error; });
  const ExitStatus status = job_is_wrong ? ExitStatus::files : status_of(options, facts.findings);
  for (const base::Diagnostic& wrong : (*plan)->job_findings())
    tell(wrong, job_sources, options.run.diagnostics);
  const bool is_whole = !has(facts.findings, base::Severity::error);
  if (auto committed = outputs.commit(facts, is_whole || options.run.keep_partial); !committed)
    return fail(committed.error());
  tell_all(options, facts, (*plan)->sources());
  if (is_whole && !options.outputs.empty()) {
    if (auto kept = job::keep_serials(ordered->order); !kept) return fail(kept.error());
  }
  return status;
}

}  // namespace kerf::cli
