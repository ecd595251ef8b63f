#include "job/internal/stock_models.hpp"

#include <fmt/format.h>

#include "base/decimal.hpp"

namespace kerf::job {
namespace {

bool is_upright(const stock::Shape& shape) {
  const auto* const round = std::get_if<stock::CylinderShape>(&shape);
  return round == nullptr || round->along == 2;
}

std::string objection_to_zmap(const SurveyedTools& tools, const stock::Shape& shape) {
  if (!is_upright(shape)) return "the stock is no height field seen from +Z";
  if (tools.turned()) return "the work is tilted against the tool";
  if (tools.undercut()) return "a tool has an undercut";
  return {};
}

}  // namespace

void choose_model(const StockJob& job, const SurveyedTools& tools, StockPlan& plan) {
  const std::string objection = objection_to_zmap(tools, plan.shape);
  if (job.model == StockModel::tridexel || !objection.empty()) {
    plan.kind = StockModel::tridexel;
    plan.reason = objection.empty() ? "asked for" : objection;
    return;
  }
  plan.kind = StockModel::zmap;
  plan.reason = job.model == StockModel::zmap
                    ? "asked for"
                    : "every tool stands along Z, and none has an undercut";
}

}  // namespace kerf::job
