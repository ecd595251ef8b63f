#include "stock/saved/saved_sheet.hpp"

#include <algorithm>
#include <map>

#include "geometry/contour/boolean.hpp"
#include "stock/saved/quarter_turn.hpp"
#include "stock/sheet/outline.hpp"
#include "stock/surface/plate_surface.hpp"

namespace kerf::stock::saved {
namespace {

using sheet::kTileCells;
using sheet::kTileSide;
using sheet::Trace;
using sheet::Vec2;

constexpr double kOutlineChord_mm = 0.001;

contour::Region whole(const sheet::Box& box) {
  return {{{.vertices = {{{box.low.u, box.low.v}},
                         {{box.high.u, box.low.v}},
                         {{box.high.u, box.high.v}},
                         {{box.low.u, box.high.v}}}}}};
}

/// Tiles of a grid that come to be as cells are put into them.
class SheetTiles {
 public:
  SheetTiles(const sheet::Grid& grid, bool has_energy) : grid_(grid), has_energy_(has_energy) {}

  /// The cell `from` of a tile comes to stand at i, j.
  void put(const SheetState::Tile& tile, std::size_t from, int i, int j) {
    SheetState::Tile& to = tile_at(i, j);
    const auto cell = static_cast<std::size_t>(j % kTileSide * kTileSide + i % kTileSide);
    to.coverage[cell] = tile.coverage[from];
    if (has_energy_ && tile.energy) (*to.energy)[cell] = (*tile.energy)[from];
  }
  std::vector<SheetState::Tile> take() {
    std::vector<SheetState::Tile> all;
    for (auto& [number, tile] : tiles_) all.push_back(std::move(tile));
    return all;
  }

 private:
  SheetState::Tile& tile_at(int i, int j) {
    const auto number = static_cast<std::uint32_t>(j / kTileSide * grid_.tiles_x() + i / kTileSide);
    const auto [place, is_new] = tiles_.try_emplace(number);
    if (is_new) {
      place->second.number = number;
      if (has_energy_) place->second.energy = std::make_unique<sheet::Sheet::Energy>();
    }
    return place->second;
  }

  const sheet::Grid& grid_;
  bool has_energy_;
  std::map<std::uint32_t, SheetState::Tile> tiles_;
};

/// A cell of the old grid as it lies in the new one.
struct CellTurn {
  QuarterTurn turn;
  const sheet::Grid& from;

  [[nodiscard]] std::array<int, 2> operator()(int i, int j) const {
    const int x = turn.sign[0] > 0 ? i : from.nx - 1 - i;
    const int y = turn.sign[1] > 0 ? j : from.ny - 1 - j;
    std::array<int, 2> at{};
    at[static_cast<std::size_t>(turn.to[0])] = x;
    at[static_cast<std::size_t>(turn.to[1])] = y;
    return at;
  }
};

std::vector<SheetState::Tile> turned_tiles_of(const SheetState& state, const sheet::Grid& to,
                                              const QuarterTurn& turn) {
  const bool has_energy = !state.tiles.empty() && state.tiles.front().energy != nullptr;
  SheetTiles tiles(to, has_energy);
  const CellTurn place{turn, state.grid};
  for (const SheetState::Tile& tile : state.tiles) {
    const int i0 = static_cast<int>(tile.number) % state.grid.tiles_x() * kTileSide;
    const int j0 = static_cast<int>(tile.number) / state.grid.tiles_x() * kTileSide;
    for (int cell = 0; cell < kTileCells; ++cell) {
      const int i = i0 + cell % kTileSide;
      const int j = j0 + cell / kTileSide;
      if (i >= state.grid.nx || j >= state.grid.ny) continue;
      const auto [to_i, to_j] = place(i, j);
      tiles.put(tile, static_cast<std::size_t>(cell), to_i, to_j);
    }
  }
  return tiles.take();
}

Trace turned_way(Trace way, const Placing& placing) {
  const auto point = [&](Vec2 p) -> Vec2 {
    const Vec3 q = placing({p.u, p.v, 0});
    return {q.x, q.y};
  };
  const Vec3 middle = placing.turned({way.middle.u, way.middle.v, 0});
  way.from = point(way.from);
  way.to = point(way.to);
  way.centre = point(way.centre);
  way.middle = {middle.x, middle.y};
  return way;
}

}  // namespace

contour::Region outline_of(std::span<const SheetCut> cuts) {
  std::vector<contour::Region> outlines;
  std::vector<Trace> ways;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    ways.push_back(cuts[i].way);
    if (i + 1 < cuts.size() && cuts[i + 1].kerf_mm == cuts[i].kerf_mm) continue;
    outlines.push_back(sheet::outline_of(ways, cuts[i].kerf_mm));
    ways.clear();
  }
  return contour::unite(outlines);
}

bool SavedSheet::restore(sheet::Sheet& sheet) const {
  return std::all_of(state_.tiles.begin(), state_.tiles.end(), [&](const SheetState::Tile& tile) {
    return sheet.restore_coverage(tile.number, &tile.coverage) &&
           sheet.restore_energy(tile.number, tile.energy.get());
  });
}

Bounds SavedSheet::box() const {
  const sheet::Box& box = state_.grid.box;
  return {{box.low.u, box.low.v, -state_.thickness_mm}, {box.high.u, box.high.v, 0}};
}

std::size_t SavedSheet::bytes() const {
  std::size_t sum = state_.cuts.size() * sizeof(SheetCut);
  for (const SheetState::Tile& tile : state_.tiles)
    sum += sizeof tile + (tile.energy ? sizeof *tile.energy : 0);
  return sum;
}

contour::Region SavedSheet::left() const {
  const contour::Region all = whole(state_.grid.box);
  return state_.cuts.empty() ? all : contour::subtract(all, outline_of(state_.cuts));
}

MeshShape SavedSheet::solid() const {
  return mesh_shape(surface::plate(left(), -state_.thickness_mm, 0, kOutlineChord_mm).mesh,
                    volume_mm3_);
}

std::shared_ptr<const SavedPart> SavedSheet::placed(const Placing& placing) const {
  const auto turn = QuarterTurn::of(placing);
  if (!turn || !turn->is_upright() || placing({0, 0, 0}).z != 0) return nullptr;
  const Bounds box = placed_box(this->box(), placing);
  const bool is_swapped = turn->to[0] == 1;
  SheetState out;
  out.grid = {{{box.low.x, box.low.y}, {box.high.x, box.high.y}},
              is_swapped ? state_.grid.ny : state_.grid.nx,
              is_swapped ? state_.grid.nx : state_.grid.ny};
  out.thickness_mm = state_.thickness_mm;
  out.tiles = turned_tiles_of(state_, out.grid, *turn);
  for (const SheetCut& cut : state_.cuts)
    out.cuts.push_back({turned_way(cut.way, placing), cut.kerf_mm});
  return std::make_shared<const SavedSheet>(std::move(out), volume_mm3_);
}

}  // namespace kerf::stock::saved
