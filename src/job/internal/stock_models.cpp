#include "job/internal/stock_models.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "math/math.hpp"
#include "stock/field/height_field.hpp"
#include "stock/turned/turned_part.hpp"

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

bool is_about_spindle(const stock::Shape& shape) {
  const auto* const round = std::get_if<stock::CylinderShape>(&shape);
  return round != nullptr && round->along == 2 && round->u == 0 && round->v == 0;
}

/// What the spindle of a lathe turns about its axis (stock.md §3).
bool becomes_profile(const StockJob& job, const stock::Shape& shape) {
  const bool is_wanted = job.model == StockModel::automatic || job.model == StockModel::profile;
  return is_wanted && job.job.definition.turns() && is_about_spindle(shape);
}

MadeModel make_profile(const stock::CylinderShape& bar) {
  MadeModel made;
  made.model = std::make_unique<stock::turned::TurnedPart>(
      stock::turned::bar(bar.diameter, bar.from, bar.to, bar.inner_diameter));
  return made;
}

// The largest number of columns along an axis that a grid may have.
constexpr double kMostColumns = 67'108'864;

/// `cell_mm`, or as much more as the memory asks for.
double fitting_cell(const stock::Bounds& box, bool is_box, double cell_mm, std::size_t bytes) {
  const double longest = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  double cell = std::max(cell_mm, longest / kMostColumns);
  while (stock::field::HeightField::bytes_of(stock::field::grid_of(box, cell), is_box) > bytes &&
         cell < longest)
    cell *= 1.1;
  return cell;
}

stock::field::ColumnAt column_of(const stock::CylinderShape& round) {
  return [round](double x, double y) -> stock::field::Column {
    const double d = 2 * math::hypot(x - round.u, y - round.v);
    if (d > round.diameter || d < round.inner_diameter) return {};
    return {round.from, round.to};
  };
}

}  // namespace

void choose_model(const StockJob& job, const SurveyedTools& tools, StockPlan& plan) {
  if (becomes_profile(job, plan.shape)) {
    plan.kind = StockModel::profile;
    plan.reason = "the work turns, and no tool does";
    return;
  }
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

MadeModel make_model(const StockPlan& plan, const StockJob& job) {
  if (plan.kind == StockModel::profile)
    return make_profile(std::get<stock::CylinderShape>(plan.shape));
  const unsigned jobs = job.jobs > 0 ? job.jobs : std::max(1U, std::thread::hardware_concurrency());
  const stock::Bounds box = stock::bounds(plan.shape);
  const bool is_box = std::holds_alternative<stock::BoxShape>(plan.shape);
  MadeModel made;
  const double cell = fitting_cell(box, is_box, plan.cell_mm, job.memory_bytes);
  if (cell > plan.cell_mm) {
    made.cell_enlarged = fmt::format("{:.4g} mm does not fit into {} MiB, {:.4g} mm does",
                                     plan.cell_mm, job.memory_bytes >> 20, cell);
  }
  const auto grid = stock::field::grid_of(box, cell);
  made.model = is_box ? std::make_unique<stock::field::HeightField>(grid, jobs)
                      : std::make_unique<stock::field::HeightField>(
                            grid, column_of(std::get<stock::CylinderShape>(plan.shape)), jobs);
  return made;
}

output::StockFacts::Model facts_of(const StockPlan& plan, const stock::Model& model) {
  output::StockFacts::Model facts;
  facts.reason = plan.reason;
  facts.bytes = model.bytes();
  facts.error_mm3 = model.error_mm3();
  if (dynamic_cast<const stock::turned::TurnedPart*>(&model) != nullptr) facts.kind = "profile";
  if (const auto* const field = dynamic_cast<const stock::field::HeightField*>(&model)) {
    const stock::field::Grid& grid = field->columns().grid();
    facts.kind = "zmap";
    facts.cell_mm = {grid.cell_x(), grid.cell_y()};
    facts.cells = {static_cast<std::uint64_t>(grid.nx), static_cast<std::uint64_t>(grid.ny)};
  }
  return facts;
}

}  // namespace kerf::job
