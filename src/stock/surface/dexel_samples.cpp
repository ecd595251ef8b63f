#include "stock/surface/dexel_samples.hpp"

#include <algorithm>
#include <cmath>

#include "stock/surface/internal/bits.hpp"
#include "stock/surface/internal/places.hpp"

namespace kerf::stock::surface {
namespace {

using dexel::DexelEnd;
using dexel::Lattice;
using dexel::on_axis;

}  // namespace

DexelSamples::DexelSamples(const dexel::TriDexel& model, int stride) : model_(model) {
  std::array<std::vector<double>, 3> points;
  double smallest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Lattice& across = model.lattice((axis + 2) % 3);  // its columns count along `axis`
    numbers_[index(axis)] = chosen(across.columns, stride);
    const double middle = on_axis(model.middle(), axis);
    const double beyond = model.lattice(axis).half_s + across.cell_b / 2;
    for (const int number : numbers_[index(axis)]) {
      points[index(axis)].push_back(middle + (number < 0 ? beyond : across.b_of(number)));
    }
    points[index(axis)].front() = middle - beyond;
    smallest = axis == 0 ? across.cell_b : std::min(smallest, across.cell_b);
  }
  const Vec3 m = model.middle();
  const double far = std::max({model.lattice(0).half_s, model.lattice(1).half_s,
                               model.lattice(2).half_s, std::fabs(m.x) + std::fabs(m.y)});
  set_points(std::move(points), std::max(kSlack * smallest, 4e-7 * far));
}

std::span<const DexelEnd> DexelSamples::ends(int axis, int b, int c) const {
  const auto numbers_b = std::span(numbers_[index((axis + 1) % 3)]);
  const auto numbers_c = std::span(numbers_[index((axis + 2) % 3)]);
  if (b < 0 || c < 0 || index(b) >= numbers_b.size() || index(c) >= numbers_c.size()) return {};
  const int column = numbers_b[index(b)];
  const int row = numbers_c[index(c)];
  if (column < 0 || row < 0) return {};
  const Lattice& lattice = model_.lattice(axis);
  const int tile = (row / Lattice::kTile) * lattice.tiles_b() + column / Lattice::kTile;
  const dexel::Tile& dexels = model_.tile(axis, index(tile));
  return dexels.ends(dexels.index(column % Lattice::kTile, row % Lattice::kTile));
}

/// Words of the dexels along `axis`, b first.
void DexelSamples::fill_along(int axis, const Signs& box, std::vector<std::uint64_t>& inside,
                              std::vector<std::uint64_t>& at_end) const {
  const std::size_t b = index((axis + 1) % 3);
  const std::size_t c = index((axis + 2) % 3);
  const std::size_t a = index(axis);
  const PointRange along(points(axis), box.first()[a], box.count()[a]);
  const double middle = on_axis(model_.middle(), axis);
  std::size_t word = 0;
  for (int row = 0; row < box.count()[c]; ++row) {
    for (int column = 0; column < box.count()[b]; ++column, ++word) {
      const auto faces = ends(axis, box.first()[b] + column, box.first()[c] + row);
      for (std::size_t i = 0; i < faces.size(); i += 2) {
        along.add(middle + double{faces[i].at}, middle + double{faces[i + 1].at}, slack_mm(),
                  inside[word], at_end[word]);
      }
    }
  }
}

void DexelSamples::fill(Signs& signs) const {
  const Place n = signs.count();
  const auto size = [&](int b, int c) { return index(n[index(b)]) * index(n[index(c)]); };
  std::array<std::vector<std::uint64_t>, 3> inside;
  std::array<std::vector<std::uint64_t>, 3> at_end;
  for (int axis = 0; axis < 3; ++axis) {
    inside[index(axis)].resize(size((axis + 1) % 3, (axis + 2) % 3));
    at_end[index(axis)].resize(inside[index(axis)].size());
    fill_along(axis, signs, inside[index(axis)], at_end[index(axis)]);
  }
  // Words along X and Y become words along Z.
  std::array<std::vector<std::uint64_t>, 2> x{turned_from_x(inside[0], n),
                                              turned_from_x(at_end[0], n)};
  std::array<std::vector<std::uint64_t>, 2> y{turned_from_y(inside[1], n),
                                              turned_from_y(at_end[1], n)};
  for (int j = 0; j < n[1]; ++j) {
    for (int i = 0; i < n[0]; ++i) {
      const std::size_t at = index(j) * index(n[0]) + index(i);
      const std::uint64_t z = inside[2][at];
      const std::uint64_t most = (x[0][at] & y[0][at]) | (y[0][at] & z) | (z & x[0][at]);
      signs.word(i, j) = most & ~(x[1][at] | y[1][at] | at_end[2][at]);
    }
  }
}

Crossing DexelSamples::crossing(int axis, Place from, bool from_inside) const {
  const std::size_t a = index(axis);
  const double low = points(axis)[index(from[a])];
  const double high = points(axis)[index(from[a] + 1)];
  const auto faces = ends(axis, from[index((axis + 1) % 3)], from[index((axis + 2) % 3)]);
  const double middle = on_axis(model_.middle(), axis);
  // The face of the piece that the inside point lies in.
  const DexelEnd* face = nullptr;
  for (std::size_t i = from_inside ? 1 : 0; i < faces.size(); i += 2) {
    const double at = middle + double{faces[i].at};
    if (at < low - slack_mm() || at > high + slack_mm()) continue;
    if (from_inside && face != nullptr) break;
    face = &faces[i];
  }
  // Dexels that only touch a face do not agree about it: those across it say where it lies.
  if (face == nullptr) return {(low + high) / 2, false, {}, 0};
  return {middle + double{face->at}, true, dexel::direction(face->normal), face->motion};
}

}  // namespace kerf::stock::surface
