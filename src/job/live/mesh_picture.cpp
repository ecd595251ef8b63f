#include "job/live/mesh_picture.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::job {
namespace {

using stock::Bounds;
using stock::Vec3;
using stock::dexel::Lattice;
using stock::dexel::on_axis;
using stock::dexel::TriDexel;
using stock::surface::Place;

bool meet(const Bounds& a, const Bounds& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}

/// Of the dexels of a tile, frame of the stock.
Bounds box_of(const TriDexel& model, int grid, std::size_t tile) {
  const Lattice& lattice = model.lattice(grid);
  const auto across = static_cast<std::size_t>(lattice.tiles_b());
  const int b = static_cast<int>(tile % across) * Lattice::kTile;
  const int c = static_cast<int>(tile / across) * Lattice::kTile;
  const Vec3 low = stock::dexel::along_axis(grid, -lattice.half_s, lattice.b_of(b) - lattice.cell_b,
                                            lattice.c_of(c) - lattice.cell_c);
  const Vec3 high = stock::dexel::along_axis(grid, lattice.half_s, lattice.b_of(b + Lattice::kTile),
                                             lattice.c_of(c + Lattice::kTile));
  return {model.middle() + low, model.middle() + high};
}

Place place_of(std::size_t number, Place blocks) {
  const int n = static_cast<int>(number);
  return {n % blocks[0], n / blocks[0] % blocks[1], n / (blocks[0] * blocks[1])};
}

std::size_t count_of(Place blocks) {
  std::size_t count = 1;
  for (const int along : blocks) count *= static_cast<std::size_t>(along);
  return count;
}

}  // namespace

namespace {

/// Of the dexel that passes a place, from the middle of the stock, the end next to it.
std::optional<PartPlace> nearest_end(const TriDexel& model, int grid, Vec3 place) {
  const Lattice& lattice = model.lattice(grid);
  const double b = on_axis(place, (grid + 1) % 3) / lattice.cell_b + lattice.columns / 2.0;
  const double c = on_axis(place, (grid + 2) % 3) / lattice.cell_c + lattice.rows / 2.0;
  if (!(b >= 0 && b < lattice.columns && c >= 0 && c < lattice.rows)) return std::nullopt;
  const int column = static_cast<int>(b);
  const int row = static_cast<int>(c);
  const auto number =
      static_cast<std::size_t>(row / Lattice::kTile * lattice.tiles_b() + column / Lattice::kTile);
  const stock::dexel::Tile& tile = model.tile(grid, number);
  const double wanted = on_axis(place, grid);
  const auto ends = tile.ends(tile.index(column % Lattice::kTile, row % Lattice::kTile));
  const auto found = std::min_element(ends.begin(), ends.end(), [&](const auto& x, const auto& y) {
    return std::fabs(double{x.at} - wanted) < std::fabs(double{y.at} - wanted);
  });
  if (found == ends.end()) return std::nullopt;
  return PartPlace{
      stock::dexel::along_axis(grid, double{found->at}, lattice.b_of(column), lattice.c_of(row)),
      found->motion};
}

}  // namespace

std::optional<PartPlace> MeshPicture::nearest(Vec3 at) const {
  const Vec3 place = at - model_.middle();
  std::optional<PartPlace> best;
  double least = 0;
  for (int grid = 0; grid < 3; ++grid) {
    const auto end = nearest_end(model_, grid, place);
    if (!end) continue;
    const double far = geometry::length(end->at - place);
    if (best && far >= least) continue;
    least = far;
    best = end;
  }
  if (best) best->at = best->at + model_.middle();
  return best;
}

MeshPicture::MeshPicture(const TriDexel& model, const stock::replay::Tiles& tiles,
                         const OwnerTable& owners)
    : model_(model),
      tiles_(tiles),
      owners_(owners),
      samples_(model),
      contouring_(samples_),
      versions_(count_of(contouring_.blocks()), 1) {
  for (std::size_t i = 0; i < tiles.count(); ++i) seen_.push_back(tiles.version(i));
}

void MeshPicture::look() {
  const std::vector<Bounds> boxes = changed();
  if (boxes.empty()) return;
  for (std::size_t i = 0; i < versions_.size(); ++i) {
    const Bounds leans_on = contouring_.seen(place_of(i, contouring_.blocks()));
    const auto meets = [&](const Bounds& box) { return meet(leans_on, box); };
    if (std::any_of(boxes.begin(), boxes.end(), meets)) ++versions_[i];
  }
}

/// Boxes of the tiles that have changed. They count through the grids.
std::vector<Bounds> MeshPicture::changed() {
  std::vector<Bounds> boxes;
  std::size_t number = 0;
  for (int grid = 0; grid < 3; ++grid) {
    for (std::size_t tile = 0; tile < model_.tiles(grid); ++tile, ++number) {
      const std::uint64_t version = tiles_.version(number);
      if (version == seen_[number]) continue;
      seen_[number] = version;
      boxes.push_back(box_of(model_, grid, tile));
    }
  }
  return boxes;
}

Picture::Parts MeshPicture::parts(std::size_t tile) const {
  const Place block = place_of(tile, contouring_.blocks());
  const stock::surface::Patch patch = contouring_.patch(block);
  return {output::mesh_part(block, patch, owners_.numbers()), 1, patch.triangles.empty()};
}

std::vector<Picture::Places> MeshPicture::places(std::size_t tile) const {
  const Place block = place_of(tile, contouring_.blocks());
  return {{.part = block, .at = output::mesh_places(contouring_.patch(block), owners_.numbers())}};
}

}  // namespace kerf::job
