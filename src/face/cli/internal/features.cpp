#include <cstdio>
#include <utility>

#include "face/cli/commands.hpp"
#include "face/cli/failure.hpp"
#include "face/cli/ready_run.hpp"
#include "face/cli/run_report.hpp"
#include "face/cli/stock_order.hpp"
#include "face/cli/stock_table.hpp"
#include "job/argument_probe.hpp"
#include "job/facts_of_features.hpp"
#include "job/features_run.hpp"
#include "output/features/feature_json.hpp"
#include "output/features/feature_svg.hpp"
#include "output/features/feature_text.hpp"

namespace kerf::cli {
namespace {

using features::Method;

Method method_of(const FeaturesOptions& options) {
  if (options.method == "literal") return Method::literal;
  return options.method == "swept" ? Method::swept : Method::both;
}

std::string told(const FeaturesOptions& options, const output::FeatureFacts& facts) {
  if (options.format == "json") return output::features_json(facts);
  return options.format == "svg" ? output::features_svg(facts) : output::features_text(facts);
}

}  // namespace

ExitStatus features(const FeaturesOptions& options) {
  auto set_up = set_up_of(options.run.table);
  if (!set_up) return fail(set_up.error());
  auto order = order_on_table(options.run, std::move(*set_up));
  if (!order) return fail(order.error());
  auto result = job::recognise_features(order->job, method_of(options));
  if (!result) return fail(result.error());
  if (options.probes_arguments) job::probe_arguments(order->job, method_of(options), *result);
  output::FeatureFacts facts = job::facts_of(*result);
  facts.run.chosen = order->ready.choice.chosen;
  facts.method = method_of(options);
  const std::string text = told(options, facts);
  std::fwrite(text.data(), 1, text.size(), stdout);
  order->ready.run = std::move(result->run);
  report_diagnostics(order->ready, options.run.diagnostics);
  if (result->notice)
    tell(*result->notice, order->ready.machine().sources(), options.run.diagnostics);
  return exit_status_of(result->status);
}

}  // namespace kerf::cli
