#include "stock/saved/saved_field.hpp"

#include <algorithm>
#include <cmath>

#include "stock/field/height_field.hpp"
#include "stock/saved/quarter_turn.hpp"
#include "stock/saved/saved_dexels.hpp"
#include "stock/surface/contouring.hpp"
#include "stock/surface/height_samples.hpp"

namespace kerf::stock::saved {
namespace {

using field::FieldState;
using field::Grid;

/// A column of the state, mm over the lowest place of the box.
struct Post {
  float bottom = 0;
  float top = 0;

  [[nodiscard]] bool holds(double height) const {
    return static_cast<double>(bottom) < height && height < static_cast<double>(top);
  }
};

Post post_at(const FieldState& state, int i, int j) {
  const std::size_t at = static_cast<std::size_t>(j) * static_cast<std::size_t>(state.grid.nx) +
                         static_cast<std::size_t>(i);
  return {state.bottoms.empty() ? 0 : state.bottoms[at], state.heights[at]};
}

int cell_of(double place, double low, double cell, int count) {
  return static_cast<int>(std::clamp(std::floor((place - low) / cell), 0.0, count - 1.0));
}

/// Along a column: as high as it is.
void look_up(const FieldState& state, double x, double y, std::vector<dexel::Interval>& out) {
  const Grid& grid = state.grid;
  const Post post = post_at(state, cell_of(x, grid.box.low.x, grid.cell_x(), grid.nx),
                            cell_of(y, grid.box.low.y, grid.cell_y(), grid.ny));
  if (post.top <= post.bottom) return;
  const double z = grid.box.low.z;
  out.push_back({z + static_cast<double>(post.bottom),
                 z + static_cast<double>(post.top),
                 {0, 0, -1},
                 {0, 0, 1}});
}

/// Across a row of columns: those in a row that hold a height are one.
template <typename PostAt>
void look_across(int count, double low, double cell, Vec3 along, double height, PostAt&& post,
                 std::vector<dexel::Interval>& out) {
  int begin = -1;
  for (int i = 0; i <= count; ++i) {
    const bool holds = i < count && post(i).holds(height);
    if (holds && begin < 0) begin = i;
    if (holds || begin < 0) continue;
    out.push_back({low + begin * cell, low + i * cell, -1.0 * along, along});
    begin = -1;
  }
}

dexel::Shape shape_of(const FieldState& state, double volume_mm3) {
  const auto inside = [&state](int axis, double b, double c, std::vector<dexel::Interval>& out) {
    const Grid& grid = state.grid;
    const Bounds& box = grid.box;
    if (axis == 2) return look_up(state, b, c, out);
    if (axis == 0) {
      const int j = cell_of(b, box.low.y, grid.cell_y(), grid.ny);
      return look_across(
          grid.nx, box.low.x, grid.cell_x(), {1, 0, 0}, c - box.low.z,
          [&](int i) { return post_at(state, i, j); }, out);
    }
    const int i = cell_of(c, box.low.x, grid.cell_x(), grid.nx);
    look_across(
        grid.ny, box.low.y, grid.cell_y(), {0, 1, 0}, b - box.low.z,
        [&](int j) { return post_at(state, i, j); }, out);
  };
  return {state.grid.box, inside, volume_mm3};
}

/// Where a column of the turned grid was.
struct FieldTurn {
  QuarterTurn turn;
  Grid from;

  [[nodiscard]] Grid grid(const Placing& placing) const {
    const std::array<int, 2> counts{from.nx, from.ny};
    return {placed_box(from.box, placing), counts[static_cast<std::size_t>(turn.from(0))],
            counts[static_cast<std::size_t>(turn.from(1))]};
  }
  [[nodiscard]] Post post(const FieldState& state, int i, int j) const {
    std::array<int, 2> at{};
    at[static_cast<std::size_t>(turn.from(0))] = i;
    at[static_cast<std::size_t>(turn.from(1))] = j;
    if (turn.sign[0] < 0) at[0] = from.nx - 1 - at[0];
    if (turn.sign[1] < 0) at[1] = from.ny - 1 - at[1];
    const Post was = post_at(state, at[0], at[1]);
    return turn.sign[2] > 0 ? was : upside_down(was);
  }
  [[nodiscard]] Post upside_down(Post post) const {
    const double size = from.box.high.z - from.box.low.z;
    const auto under = [&](float height) {
      return static_cast<float>(std::max(0.0, size - static_cast<double>(height)));
    };
    return {under(post.top), under(post.bottom)};
  }
};

FieldState turned_state(const FieldState& state, const FieldTurn& turn, const Placing& placing) {
  FieldState out{turn.grid(placing), {}, {}};
  bool has_bottoms = false;
  for (int j = 0; j < out.grid.ny; ++j) {
    for (int i = 0; i < out.grid.nx; ++i) {
      const Post post = turn.post(state, i, j);
      out.heights.push_back(post.top);
      out.bottoms.push_back(post.bottom);
      has_bottoms = has_bottoms || post.bottom != 0;
    }
  }
  if (!has_bottoms) out.bottoms.clear();
  return out;
}

/// Those of the grid, and as many layers as there are of their size.
dexel::TriDexel::CellCounts cells_of(const SavedField& part) {
  const Grid& grid = part.state().grid;
  const double layers = std::ceil((grid.box.high.z - grid.box.low.z) / part.cell_mm() - 1e-9);
  return {grid.nx, grid.ny, static_cast<int>(std::max(1.0, layers))};
}

}  // namespace

double SavedField::cell_mm() const { return std::max(state_.grid.cell_x(), state_.grid.cell_y()); }

std::size_t SavedField::bytes() const {
  return (state_.heights.size() + state_.bottoms.size()) * sizeof(float);
}

std::unique_ptr<Model> SavedField::model(unsigned jobs) const {
  return std::make_unique<field::HeightField>(state_, jobs);
}

std::unique_ptr<Model> SavedField::dexels(unsigned jobs) const {
  return std::make_unique<dexel::TriDexel>(shape_of(state_, volume_mm3_), cells_of(*this), jobs);
}

MeshShape SavedField::solid() const {
  const field::Columns columns(state_);
  const surface::HeightSamples samples(columns);
  return mesh_shape(surface::Contouring(samples).surface(0).mesh, volume_mm3_);
}

std::shared_ptr<const SavedPart> SavedField::placed(const Placing& placing) const {
  const auto turn = QuarterTurn::of(placing);
  if (!turn) return nullptr;
  if (!turn->keeps_z()) {
    const dexel::TriDexel lying(shape_of(state_, volume_mm3_), cells_of(*this), 0);
    return SavedDexels(state_of(lying, volume_mm3_)).placed(placing);
  }
  return std::make_shared<const SavedField>(turned_state(state_, {*turn, state_.grid}, placing),
                                            volume_mm3_);
}

}  // namespace kerf::stock::saved
