#include "job/internal/stock_models.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "job/internal/mesh_stock.hpp"
#include "math/math.hpp"
#include "stock/compare/dexel_solid.hpp"
#include "stock/cutting/saved_part.hpp"
#include "stock/dexel/tri_dexel.hpp"
#include "stock/field/height_field.hpp"
#include "stock/saved/saved_turned.hpp"
#include "stock/turnmill/turn_mill_part.hpp"

namespace kerf::job {
namespace {

using stock::Vec3;

/// Of a mesh by the columns of the field that it would become.
bool is_height_field(const StockJob& job, StockPlan plan) {
  const auto* const round = std::get_if<stock::CylinderShape>(&plan.shape);
  const auto* const mesh = std::get_if<stock::MeshShape>(&plan.shape);
  if (const auto* const saved = std::get_if<stock::SavedShape>(&plan.shape))
    return saved->part->kind() == stock::SavedPart::Kind::field;
  if (mesh == nullptr) return round == nullptr || round->along == 2;
  plan.kind = StockModel::zmap;
  const double cell = cell_of(plan, ModelSize::of(job));
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

/// What is_about_spindle() is, as its half section.
contour::Region section_of(const stock::Workpiece& shape) {
  if (const auto* const saved = std::get_if<stock::SavedShape>(&shape))
    return dynamic_cast<const stock::saved::SavedTurned&>(*saved->part).region();
  const auto& bar = std::get<stock::CylinderShape>(shape);
  return stock::turned::bar(bar.diameter, bar.from, bar.to, bar.inner_diameter);
}

MadeModel make_profile(const stock::Workpiece& shape) {
  MadeModel made;
  made.model = std::make_unique<stock::turned::TurnedPart>(section_of(shape));
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
  if (job.job.definition.turns()) {
    plan.kind = StockModel::tridexel;
    plan.reason = is_asked_for ? "asked for" : "the stock is no bar about the spindle";
    return;
  }
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
  if (plan.kind == StockModel::tridexel) {
    return beside + stock::dexel::TriDexel::bytes_for(box, cell_mm) +
           (plan.is_compared ? stock::compare::DexelSolid::bytes_for(box, cell_mm) : 0);
  }
  const bool is_box = std::holds_alternative<stock::BoxShape>(plan.shape);
  return beside + static_cast<double>(stock::field::HeightField::bytes_of(
                      stock::field::grid_of(box, cell_mm), is_box));
}

std::unique_ptr<stock::Model> part_of_lathe(const StockPlan& plan, double cell_mm, unsigned jobs) {
  using stock::turnmill::TurnMillPart;
  if (!is_about_spindle(plan.shape))
    return std::make_unique<TurnMillPart>(dexels_of(plan.shape), cell_mm, jobs);
  return std::make_unique<TurnMillPart>(section_of(plan.shape), cell_mm, jobs);
}

double longest_side(const StockPlan& plan) {
  const Vec3 size = stock::bounds(plan.shape).high - stock::bounds(plan.shape).low;
  return std::max({size.x, size.y, size.z});
}

/// Of surfaces a picture takes so many points with `along` cells to the longest side, however thick
/// the stock is.
constexpr double kPointsOfSurface = 0.625;

double picture_cell(const StockPlan& plan, int along) {
  const double cell = longest_side(plan) / along;
  if (plan.kind != StockModel::tridexel) return cell;
  const Vec3 size = stock::bounds(plan.shape).high - stock::bounds(plan.shape).low;
  const double area = 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
  return std::max(cell, std::sqrt(area / kPointsOfSurface) / along);
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

double cell_of(const StockPlan& plan, const ModelSize& size) {
  const auto bytes =
      static_cast<double>(size.memory_bytes - std::min(plan.lines_bytes, size.memory_bytes));
  const double longest = longest_side(plan);
  double cell = std::max({plan.cell_mm, longest / kMostColumns, size.least_cell_mm});
  while (bytes_for(plan, cell) > bytes && cell < longest) cell *= 1.1;
  return cell;
}

MadeModel make_model(const StockPlan& plan, const ModelSize& size) {
  if (plan.kind == StockModel::profile) return make_profile(plan.shape);
  const unsigned jobs =
      size.jobs > 0 ? size.jobs : std::max(1U, std::thread::hardware_concurrency());
  MadeModel made;
  if (const auto* const saved = std::get_if<stock::SavedShape>(&plan.shape);
      saved != nullptr && !size.turns) {
    made.turning_tolerance_mm = std::max(kLeastTurning_mm, saved->part->cell_mm() / 50);
    made.model = model_again(*saved->part, plan.kind, jobs);
    made.cell_mm = saved->part->cell_mm();
    if (made.model) return made;
  }
  double cell = cell_of(plan, size);
  if (cell > plan.cell_mm) {
    made.cell_enlarged = fmt::format("{:.4g} mm does not fit into {} MiB, {:.4g} mm does",
                                     plan.cell_mm, size.of_bytes >> 20, cell);
  }
  if (size.most_along > 0) cell = picture_cell(plan, size.most_along);
  made.turning_tolerance_mm = std::max(kLeastTurning_mm, cell / 50);  // stock.md §4
  made.cell_mm = cell;
  made.model = size.turns ? part_of_lathe(plan, cell, jobs) : model_of(plan, cell, jobs);
  return made;
}

const stock::dexel::TriDexel* dexels_of(const stock::Model& model) {
  if (const auto* const part = dynamic_cast<const stock::turnmill::TurnMillPart*>(&model))
    return &part->dexels();
  return dynamic_cast<const stock::dexel::TriDexel*>(&model);
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
  if (const stock::dexel::TriDexel* const dexels = dexels_of(model)) {
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
