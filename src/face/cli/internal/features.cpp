#include <cstdio>

#include "face/cli/commands.hpp"
#include "face/cli/failure.hpp"
#include "face/cli/ready_run.hpp"
#include "face/cli/run_report.hpp"
#include "face/cli/stock_order.hpp"
#include "face/cli/stock_table.hpp"
#include "job/facts_of_features.hpp"
#include "job/features_run.hpp"
#include "output/features/feature_json.hpp"
#include "output/features/feature_text.hpp"

namespace kerf::cli {
namespace {

using features::Method;

Method method_of(const FeaturesOptions& options) {
  if (options.method == "literal") return Method::literal;
  return options.method == "swept" ? Method::swept : Method::both;
}

std::string told(const FeaturesOptions& options, const output::FeatureFacts& facts) {
  return options.format == "json" ? output::features_json(facts) : output::features_text(facts);
}

}  // namespace

ExitStatus features(const FeaturesOptions& options) {
  const auto set_up = set_up_of(options.run.table);
  if (!set_up) return fail(set_up.error());
  auto program = kept_program(options.run.program);
  if (!program) return fail(program.error());
  auto source = program->open();
  if (!source) return fail(source.error());
  auto ordered = job_of(options.run, **source);
  if (!ordered) return fail(ordered.error());
  ReadyRun ready{nullptr, ordered->choice, ordered->hint};
  auto job = stock_job(options.run, *set_up, std::move(*ordered), std::move(*program), **source);
  if (!job) return fail(job.error());
  auto result = job::recognise_features(*job, method_of(options));
  if (!result) return fail(result.error());
  output::FeatureFacts facts = job::facts_of(*result);
  facts.run.chosen = ready.choice.chosen;
  facts.method = method_of(options);
  const std::string text = told(options, facts);
  std::fwrite(text.data(), 1, text.size(), stdout);
  ready.run = std::move(result->run);
  report_diagnostics(ready, options.run.diagnostics);
  return exit_status_of(result->status);
}

}  // namespace kerf::cli
