#include "job/live/model_cutting.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"
#include "stock/field/height_field.hpp"

namespace kerf::job {
namespace {

using stock::Bounds;
using stock::Vec3;
using stock::field::Grid;

/// As many as a browser makes triangles of in a second or two.
constexpr double kMostColumns = 2.4e6;
constexpr double kMostPoints = 4e5;
/// A level is worth its name where its cells are smaller by so much.
constexpr double kFiner = 0.8;
/// Of checkpoints of the fine level.
constexpr std::size_t kFineMemory_bytes = std::size_t{64} << 20U;

PartGrid part_grid(const Grid& grid) {
  return {{grid.x(0), grid.y(0)}, {grid.cell_x(), grid.cell_y()}, {grid.nx, grid.ny}};
}

double fine_cell(const stock::Model& model, const Bounds& box, double usual_mm) {
  const Vec3 size = box.high - box.low;
  if (dynamic_cast<const stock::field::HeightField*>(&model) != nullptr)
    return std::max(usual_mm, std::sqrt(size.x * size.y / kMostColumns));
  const double area = 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
  return std::max(usual_mm, std::sqrt(area / kMostPoints));
}

PartLevel level_of(const stock::Model& model) {
  PartLevel level{.cell_mm = model.grain_mm()};
  const auto* const field = dynamic_cast<const stock::field::HeightField*>(&model);
  if (field != nullptr) level.grid = part_grid(field->columns().grid());
  return level;
}

}  // namespace

ModelCutting::ModelCutting(const ModelBegin& pass, std::uint32_t run, std::size_t memory_bytes)
    : Cutting(pass, run), like_(pass.like), recording_(pass.model, {.memory_bytes = memory_bytes}) {
  see_against(pass.design);
  add_level(level_of(pass.model));
  const PartLevel& coarse = levels().front();
  PartLevel fine{.cell_mm = fine_cell(pass.model, box(), pass.usual_cell_mm)};
  if (!(fine.cell_mm < kFiner * coarse.cell_mm)) return;
  if (coarse.grid) fine.grid = part_grid(stock::field::grid_of(box(), fine.cell_mm));
  add_level(fine);
}

void ModelCutting::take(const stock::TimedCut& cut) {
  const auto motion = static_cast<std::uint32_t>(cut.cut.motion);
  if (cut.cut.is_looked_at) {
    const base::BlockId& block = cut.cut.block;
    table().add(motion, {static_cast<std::uint32_t>(block.file), block.line, cut.cut.tool},
                geometry::degrees(cut.cut.data.engagement.phi_rad));
  }
  recording_.tell(motion, cut.start_s, cut.end_s);
}

const Picture* ModelCutting::at(double time_s, std::uint32_t level,
                                const std::stop_token& unwanted) {
  auto& seen = seen_.at(level);
  if (!seen) seen = make(level);
  if (!seen->player.go_to(time_s, unwanted)) return nullptr;
  seen->picture->look();
  return seen->picture.get();
}

std::unique_ptr<ModelCutting::Seen> ModelCutting::make(std::uint32_t level) const {
  const bool is_alike = level == 0;
  return std::make_unique<Seen>(
      like_(is_alike ? 0 : levels()[level].cell_mm), recording_,
      stock::replay::Player::Settings{.is_alike = is_alike,
                                      .own = {.memory_bytes = kFineMemory_bytes}},
      PictureOf{owners(), design() != nullptr});
}

}  // namespace kerf::job
