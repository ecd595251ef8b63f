#include "stock/saved/saved_dexels.hpp"

#include <algorithm>

#include "stock/saved/quarter_turn.hpp"
#include "stock/surface/contouring.hpp"
#include "stock/surface/dexel_samples.hpp"

namespace kerf::stock::saved {
namespace {

using dexel::DexelEnd;
using dexel::Lattice;
using State = dexel::TriDexel::State;
using TileState = dexel::TriDexel::TileState;

/// The dexels of one direction, and how their tiles lie.
struct GridLayout {
  int axis = 0;
  int columns = 0;
  int rows = 0;

  GridLayout(const dexel::TriDexel::CellCounts& cells, int along)
      : axis(along),
        columns(cells[static_cast<std::size_t>((along + 1) % 3)]),
        rows(cells[static_cast<std::size_t>((along + 2) % 3)]) {}

  [[nodiscard]] int tiles_across() const { return (columns + Lattice::kTile - 1) / Lattice::kTile; }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  /// act(column, row) for the dexels of a tile, in its order.
  template <typename Act>
  void each_of(std::size_t tile, Act&& act) const {
    const int c0 = static_cast<int>(tile) % tiles_across() * Lattice::kTile;
    const int r0 = static_cast<int>(tile) / tiles_across() * Lattice::kTile;
    for (int row = r0; row < std::min(rows, r0 + Lattice::kTile); ++row) {
      for (int column = c0; column < std::min(columns, c0 + Lattice::kTile); ++column)
        act(column, row);
    }
  }
};

/// The ends of every dexel of a grid, by its place.
std::vector<std::span<const DexelEnd>> dexels_of(const std::vector<TileState>& tiles,
                                                 const GridLayout& layout) {
  std::vector<std::span<const DexelEnd>> all(static_cast<std::size_t>(layout.columns) *
                                             static_cast<std::size_t>(layout.rows));
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    std::size_t dexel = 0;
    std::size_t end = 0;
    layout.each_of(t, [&](int column, int row) {
      const std::size_t count = tiles[t].counts[dexel++];
      all[layout.index(column, row)] = std::span(tiles[t].ends).subspan(end, count);
      end += count;
    });
  }
  return all;
}

/// Where the cells of a turned part were, and how its faces look now.
class DexelTurn {
 public:
  DexelTurn(const QuarterTurn& turn, const dexel::TriDexel::CellCounts& cells)
      : turn_(turn), cells_(cells) {}

  [[nodiscard]] dexel::TriDexel::CellCounts cells() const {
    dexel::TriDexel::CellCounts out{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      out[static_cast<std::size_t>(turn_.to[axis])] = cells_[axis];
    return out;
  }

  /// Number of the dexel that comes to stand in a column and a row of a turned grid.
  [[nodiscard]] std::size_t source(const GridLayout& to, int column, int row) const {
    std::array<int, 3> at{};
    put((to.axis + 1) % 3, column, at);
    put((to.axis + 2) % 3, row, at);
    const GridLayout from(cells_, turn_.from(to.axis));
    return from.index(at[static_cast<std::size_t>((from.axis + 1) % 3)],
                      at[static_cast<std::size_t>((from.axis + 2) % 3)]);
  }

  /// Appends a dexel that comes to lie along an axis.
  void append(std::span<const DexelEnd> ends, int axis, TileState& tile) const {
    tile.counts.push_back(static_cast<std::uint16_t>(ends.size()));
    const std::size_t begin = tile.ends.size();
    const bool is_turned = turn_.sign[static_cast<std::size_t>(turn_.from(axis))] < 0;
    for (const DexelEnd& end : ends)
      tile.ends.push_back({is_turned ? -end.at : end.at, turned(end.normal), 0, 0});
    if (is_turned)
      std::reverse(tile.ends.begin() + static_cast<std::ptrdiff_t>(begin), tile.ends.end());
  }

 private:
  void put(int axis, int number, std::array<int, 3>& at) const {
    const auto from = static_cast<std::size_t>(turn_.from(axis));
    at[from] = turn_.sign[from] > 0 ? number : cells_[from] - 1 - number;
  }

  [[nodiscard]] dexel::Octahedral turned(dexel::Octahedral normal) const {
    const Vec3 was = dexel::direction(normal);
    std::array<double, 3> is{};
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      is[static_cast<std::size_t>(turn_.to[a])] = turn_.sign[a] * dexel::on_axis(was, axis);
    }
    return dexel::octahedral({is[0], is[1], is[2]});
  }

  QuarterTurn turn_;
  dexel::TriDexel::CellCounts cells_;
};

std::vector<TileState> turned_tiles(const State& state, const DexelTurn& turn,
                                    const GridLayout& from, const GridLayout& to) {
  const auto dexels = dexels_of(state.tiles[static_cast<std::size_t>(from.axis)], from);
  const int tiles_down = (to.rows + Lattice::kTile - 1) / Lattice::kTile;
  std::vector<TileState> tiles(static_cast<std::size_t>(to.tiles_across() * tiles_down));
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    to.each_of(t, [&](int column, int row) {
      turn.append(dexels[turn.source(to, column, row)], to.axis, tiles[t]);
    });
  }
  return tiles;
}

}  // namespace

State state_of(const dexel::TriDexel& model, double volume_mm3) {
  State state{model.box(), model.cells(), {}, volume_mm3};
  for (int grid = 0; grid < 3; ++grid) {
    for (std::size_t t = 0; t < model.tiles(grid); ++t) {
      TileState tile = model.save(grid, t);
      for (DexelEnd& end : tile.ends) end.motion = 0;
      state.tiles[static_cast<std::size_t>(grid)].push_back(std::move(tile));
    }
  }
  return state;
}

double SavedDexels::cell_mm() const {
  const Vec3 size = state_.box.high - state_.box.low;
  return std::max({size.x / state_.cells[0], size.y / state_.cells[1], size.z / state_.cells[2]});
}

std::size_t SavedDexels::bytes() const {
  std::size_t sum = 0;
  for (const auto& tiles : state_.tiles) {
    for (const TileState& tile : tiles)
      sum += sizeof tile + tile.counts.size() * sizeof tile.counts[0] +
             tile.ends.size() * sizeof(DexelEnd);
  }
  return sum;
}

std::unique_ptr<Model> SavedDexels::model(unsigned jobs) const {
  return dexel::TriDexel::of(state_, jobs);
}

MeshShape SavedDexels::solid() const {
  const auto model = dexel::TriDexel::of(state_, 0);
  const surface::DexelSamples samples(*model);
  return mesh_shape(surface::Contouring(samples).surface(0).mesh, state_.volume_mm3);
}

std::shared_ptr<const SavedPart> SavedDexels::placed(const Placing& placing) const {
  const auto turn = QuarterTurn::of(placing);
  if (!turn) return nullptr;
  const DexelTurn turned(*turn, state_.cells);
  State out{placed_box(state_.box, placing), turned.cells(), {}, state_.volume_mm3};
  for (int axis = 0; axis < 3; ++axis) {
    out.tiles[static_cast<std::size_t>(axis)] = turned_tiles(
        state_, turned, GridLayout(state_.cells, turn->from(axis)), GridLayout(out.cells, axis));
  }
  return std::make_shared<const SavedDexels>(std::move(out));
}

}  // namespace kerf::stock::saved
