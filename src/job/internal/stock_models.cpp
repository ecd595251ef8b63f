#include "job/internal/stock_models.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "math/math.hpp"
#include "stock/dexel/tri_dexel.hpp"
#include "stock/field/height_field.hpp"

namespace kerf::job {
namespace {

using stock::Vec3;

bool is_upright(const stock::Workpiece& shape) {
  const auto* const round = std::get_if<stock::CylinderShape>(&shape);
  return round == nullptr || round->along == 2;
}

std::string objection_to_zmap(const SurveyedTools& tools, const stock::Workpiece& shape) {
  if (!is_upright(shape)) return "the stock is no height field seen from +Z";
  if (tools.turned()) return "the work is tilted against the tool";
  if (tools.undercut()) return "a tool has an undercut";
  return {};
}

// The largest number of columns along an axis that a grid may have.
constexpr double kMostColumns = 67'108'864;
constexpr double kLeastTurning_mm = 0.001;

stock::field::ColumnAt column_of(const stock::CylinderShape& round) {
  return [round](double x, double y) -> stock::field::Column {
    const double d = 2 * math::hypot(x - round.u, y - round.v);
    if (d > round.diameter || d < round.inner_diameter) return {};
    return {round.from, round.to};
  };
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

namespace {

stock::dexel::Shape dexels_of(const stock::Workpiece& piece) {
  const auto* const round = std::get_if<stock::CylinderShape>(&piece);
  if (round == nullptr) return stock::dexel::box_shape(stock::bounds(piece));
  // Dexels along Y have Z before X.
  const bool swapped = round->along == 1;
  return stock::dexel::round_shape({.axis = round->along,
                                    .b = swapped ? round->v : round->u,
                                    .c = swapped ? round->u : round->v,
                                    .low = round->from,
                                    .high = round->to,
                                    .radius_mm = round->diameter / 2,
                                    .inner_mm = round->inner_diameter / 2});
}

/// What a model of this kind takes before the first cut.
double bytes_for(const StockPlan& plan, double cell_mm) {
  const stock::Bounds box = stock::bounds(plan.shape);
  if (plan.kind == StockModel::tridexel) return stock::dexel::TriDexel::bytes_for(box, cell_mm);
  const bool is_box = std::holds_alternative<stock::BoxShape>(plan.shape);
  return static_cast<double>(
      stock::field::HeightField::bytes_of(stock::field::grid_of(box, cell_mm), is_box));
}

/// The cell of the plan, or as much more as the memory asks for.
double fitting_cell(const StockPlan& plan, std::size_t bytes) {
  const Vec3 size = stock::bounds(plan.shape).high - stock::bounds(plan.shape).low;
  const double longest = std::max({size.x, size.y, size.z});
  double cell = std::max(plan.cell_mm, longest / kMostColumns);
  while (bytes_for(plan, cell) > static_cast<double>(bytes) && cell < longest) cell *= 1.1;
  return cell;
}

std::unique_ptr<stock::Model> model_of(const StockPlan& plan, double cell_mm, unsigned jobs) {
  if (plan.kind == StockModel::tridexel)
    return std::make_unique<stock::dexel::TriDexel>(dexels_of(plan.shape), cell_mm, jobs);
  const auto grid = stock::field::grid_of(stock::bounds(plan.shape), cell_mm);
  const auto* const round = std::get_if<stock::CylinderShape>(&plan.shape);
  if (round == nullptr) return std::make_unique<stock::field::HeightField>(grid, jobs);
  return std::make_unique<stock::field::HeightField>(grid, column_of(*round), jobs);
}

}  // namespace

MadeModel make_model(const StockPlan& plan, const StockJob& job) {
  const unsigned jobs = job.jobs > 0 ? job.jobs : std::max(1U, std::thread::hardware_concurrency());
  const double cell = fitting_cell(plan, job.memory_bytes);
  MadeModel made;
  made.turning_tolerance_mm = std::max(kLeastTurning_mm, cell / 50);  // stock.md §4
  if (cell > plan.cell_mm) {
    made.cell_enlarged = fmt::format("{:.4g} mm does not fit into {} MiB, {:.4g} mm does",
                                     plan.cell_mm, job.memory_bytes >> 20, cell);
  }
  made.model = model_of(plan, cell, jobs);
  return made;
}

output::StockFacts::Model facts_of(const StockPlan& plan, const stock::Model& model) {
  output::StockFacts::Model facts;
  facts.reason = plan.reason;
  facts.bytes = model.bytes();
  facts.error_mm3 = model.error_mm3();
  if (const auto* const field = dynamic_cast<const stock::field::HeightField*>(&model)) {
    const stock::field::Grid& grid = field->columns().grid();
    facts.kind = "zmap";
    facts.cell_mm = {grid.cell_x(), grid.cell_y()};
    facts.cells = {static_cast<std::uint64_t>(grid.nx), static_cast<std::uint64_t>(grid.ny)};
  }
  if (const auto* const dexels = dynamic_cast<const stock::dexel::TriDexel*>(&model)) {
    facts.kind = "tridexel";
    // Dexels along X lie on the grid of Y and Z, those along Z on that of X and Y.
    const stock::dexel::Lattice& along_x = dexels->lattice(0);
    const stock::dexel::Lattice& along_z = dexels->lattice(2);
    facts.cell_mm = {along_z.cell_b, along_z.cell_c, along_x.cell_c};
    for (const int count : {along_z.columns, along_z.rows, along_x.rows})
      facts.cells.push_back(static_cast<std::uint64_t>(count));
    const auto grids = dexels->grids_mm3();
    facts.grids_mm3.assign(grids.begin(), grids.end());
  }
  return facts;
}

}  // namespace kerf::job
