#include "job/internal/stock_models.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "job/internal/mesh_stock.hpp"
#include "math/math.hpp"
#include "stock/cutting/saved_part.hpp"
#include "stock/dexel/tri_dexel.hpp"
#include "stock/field/height_field.hpp"
#include "stock/turned/turned_part.hpp"

namespace kerf::job {
namespace {

using stock::Vec3;

/// The least of what a field takes, as a field or beside it.
double bytes_for(const StockPlan& plan, double cell_mm);
double fitting_cell(const StockPlan& plan, std::size_t bytes);

/// Of a mesh by the columns of the field that it would become.
bool is_height_field(const StockJob& job, StockPlan plan) {
  const auto* const round = std::get_if<stock::CylinderShape>(&plan.shape);
  const auto* const mesh = std::get_if<stock::MeshShape>(&plan.shape);
  if (const auto* const saved = std::get_if<stock::SavedShape>(&plan.shape))
    return saved->part->kind() == stock::SavedPart::Kind::field;
  if (mesh == nullptr) return round == nullptr || round->along == 2;
  plan.kind = StockModel::zmap;
  const double cell = fitting_cell(plan, job.memory_for_model());
  return MeshColumns(*mesh, stock::field::grid_of(mesh->box, cell)).is_height_field();
}

std::string objection_to_zmap(const StockJob& job, const SurveyedTools& tools,
                              const StockPlan& plan) {
  if (!is_height_field(job, plan)) return "the stock is no height field seen from +Z";
  if (tools.turned()) return "the work is tilted against the tool";
  if (tools.undercut()) return "a tool has an undercut";
  return {};
}

bool is_about_spindle(const stock::Workpiece& shape) {
  if (const auto* const saved = std::get_if<stock::SavedShape>(&shape))
    return saved->part->kind() == stock::SavedPart::Kind::turned;
  const auto* const round = std::get_if<stock::CylinderShape>(&shape);
  return round != nullptr && round->along == 2 && round->u == 0 && round->v == 0;
}

/// What the spindle of a lathe turns about its axis (stock.md §3).
bool becomes_profile(const StockJob& job, const stock::Workpiece& shape) {
  const bool is_wanted = job.model == StockModel::automatic || job.model == StockModel::profile;
  return is_wanted && job.job.definition.turns() && is_about_spindle(shape);
}

MadeModel make_profile(const stock::Workpiece& shape) {
  MadeModel made;
  if (const auto* const saved = std::get_if<stock::SavedShape>(&shape)) {
    made.model = saved->part->model(1);
    return made;
  }
  const auto& bar = std::get<stock::CylinderShape>(shape);
  made.model = std::make_unique<stock::turned::TurnedPart>(
      stock::turned::bar(bar.diameter, bar.from, bar.to, bar.inner_diameter));
  return made;
}

/// The model of a part that was cut before, with its own cells; null: it is not of this kind.
std::unique_ptr<stock::Model> model_again(const stock::SavedPart& part, StockModel kind,
                                          unsigned jobs) {
  using Kind = stock::SavedPart::Kind;
  if (kind == StockModel::zmap && part.kind() == Kind::field) return part.model(jobs);
  return kind == StockModel::tridexel ? part.dexels(jobs) : nullptr;
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
  if (becomes_profile(job, plan.shape)) {
    plan.kind = StockModel::profile;
    plan.reason = "the work turns, and no tool does";
    return;
  }
  const bool is_asked_for = job.model == StockModel::tridexel;
  const std::string objection = is_asked_for ? "asked for" : objection_to_zmap(job, tools, plan);
  if (!objection.empty()) {
    plan.kind = StockModel::tridexel;
    plan.reason = objection;
    return;
  }
  plan.kind = StockModel::zmap;
  plan.reason = job.model == StockModel::zmap
                    ? "asked for"
                    : "every tool stands along Z, and none has an undercut";
}

stock::dexel::Shape dexels_of(const stock::Workpiece& piece) {
  if (const auto* const mesh = std::get_if<stock::MeshShape>(&piece))
    return stock::dexel::mesh_shape(mesh->solid);
  if (const auto* const saved = std::get_if<stock::SavedShape>(&piece))
    return stock::dexel::mesh_shape(saved->part->solid().solid);
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

namespace {

/// Ends of dexels that a mesh has beyond two a dexel, and the lines through it while it is asked.
double bytes_for_mesh(const StockPlan& plan, double cell_mm) {
  const auto* const mesh = std::get_if<stock::MeshShape>(&plan.shape);
  if (mesh == nullptr) return 0;
  const double along_z = bytes_of_lines(*mesh, 2, cell_mm);
  if (plan.kind != StockModel::tridexel) return along_z;
  const double along_x = bytes_of_lines(*mesh, 0, cell_mm);
  const double along_y = bytes_of_lines(*mesh, 1, cell_mm);
  return along_x + along_y + along_z + std::max({along_x, along_y, along_z});
}

/// What a model of this kind takes before the first cut.
double bytes_for(const StockPlan& plan, double cell_mm) {
  const stock::Bounds box = stock::bounds(plan.shape);
  const double beside = bytes_for_mesh(plan, cell_mm);
  if (plan.kind == StockModel::tridexel)
    return beside + stock::dexel::TriDexel::bytes_for(box, cell_mm);
  const bool is_box = std::holds_alternative<stock::BoxShape>(plan.shape);
  return beside + static_cast<double>(stock::field::HeightField::bytes_of(
                      stock::field::grid_of(box, cell_mm), is_box));
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
  if (const auto* const mesh = std::get_if<stock::MeshShape>(&plan.shape)) {
    return std::make_unique<stock::field::HeightField>(grid, MeshColumns(*mesh, grid).columns(),
                                                       jobs);
  }
  const auto* const round = std::get_if<stock::CylinderShape>(&plan.shape);
  if (round == nullptr) return std::make_unique<stock::field::HeightField>(grid, jobs);
  return std::make_unique<stock::field::HeightField>(grid, column_of(*round), jobs);
}

}  // namespace

MadeModel make_model(const StockPlan& plan, const StockJob& job) {
  if (plan.kind == StockModel::profile) return make_profile(plan.shape);
  const unsigned jobs = job.jobs > 0 ? job.jobs : std::max(1U, std::thread::hardware_concurrency());
  MadeModel made;
  if (const auto* const saved = std::get_if<stock::SavedShape>(&plan.shape)) {
    made.turning_tolerance_mm = std::max(kLeastTurning_mm, saved->part->cell_mm() / 50);
    made.model = model_again(*saved->part, plan.kind, jobs);
    if (made.model) return made;
  }
  const double cell = fitting_cell(plan, job.memory_for_model());
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
  if (dynamic_cast<const stock::turned::TurnedPart*>(&model) != nullptr) facts.kind = "profile";
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
