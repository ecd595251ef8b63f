#include "stock/dexel/pieces.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <tuple>

namespace kerf::stock::dexel {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Sets that grow together; each is known by its first member.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  [[nodiscard]] std::uint32_t of(std::uint32_t member) {
    while (parent_[member] != member) {
      parent_[member] = parent_[parent_[member]];
      member = parent_[member];
    }
    return member;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = of(a);
    b = of(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

class Search {
 public:
  Search(const TriDexel& dexels, int grid, double bottom_mm)
      : dexels_(dexels),
        grid_(grid),
        lattice_(dexels.lattice(grid)),
        bottom_mm_(bottom_mm),
        first_(number_intervals()),
        sets_(first_.back()) {}

  std::vector<Piece> run() {
    each_dexel([&](int column, int row) {
      if (column > 0) join(at(column, row), at(column - 1, row));
      if (row > 0) join(at(column, row), at(column, row - 1));
    });
    std::vector<std::uint32_t> piece_of(first_.back(), kNone);
    std::vector<Piece> pieces;
    each_dexel([&](int column, int row) { take(column, row, piece_of, pieces); });
    for (Piece& piece : pieces) finish(piece);
    std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
      return std::tuple(-a.volume_mm3, a.extents.low.x, a.extents.low.y, a.extents.low.z) <
             std::tuple(-b.volume_mm3, b.extents.low.x, b.extents.low.y, b.extents.low.z);
    });
    return pieces;
  }

 private:
  template <class Act>
  void each_dexel(const Act& act) const {
    for (int row = 0; row < lattice_.rows; ++row) {
      for (int column = 0; column < lattice_.columns; ++column) act(column, row);
    }
  }
  [[nodiscard]] std::size_t at(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(lattice_.columns) +
           static_cast<std::size_t>(column);
  }
  [[nodiscard]] std::span<const DexelEnd> ends(std::size_t dexel) const {
    const int column = static_cast<int>(dexel % static_cast<std::size_t>(lattice_.columns));
    const int row = static_cast<int>(dexel / static_cast<std::size_t>(lattice_.columns));
    const int tile = row / Lattice::kTile * lattice_.tiles_b() + column / Lattice::kTile;
    const Tile& tiles = dexels_.tile(grid_, static_cast<std::size_t>(tile));
    return tiles.ends(tiles.index(column % Lattice::kTile, row % Lattice::kTile));
  }

  /// Of each dexel the number of its first interval, and behind them of all.
  [[nodiscard]] std::vector<std::uint32_t> number_intervals() const {
    std::vector<std::uint32_t> first;
    first.reserve(
        static_cast<std::size_t>(lattice_.rows) * static_cast<std::size_t>(lattice_.columns) + 1);
    std::uint32_t count = 0;
    each_dexel([&](int column, int row) {
      first.push_back(count);
      count += static_cast<std::uint32_t>(ends(at(column, row)).size() / 2);
    });
    first.push_back(count);
    return first;
  }

  void join(std::size_t dexel, std::size_t neighbour) {
    const auto a = ends(dexel);
    const auto b = ends(neighbour);
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
      if (std::min(a[i + 1].at, b[j + 1].at) > std::max(a[i].at, b[j].at)) {
        sets_.join(first_[dexel] + static_cast<std::uint32_t>(i / 2),
                   first_[neighbour] + static_cast<std::uint32_t>(j / 2));
      }
      (a[i + 1].at < b[j + 1].at ? i : j) += 2;
    }
  }

  void take(int column, int row, std::vector<std::uint32_t>& piece_of, std::vector<Piece>& pieces) {
    const std::size_t dexel = at(column, row);
    const auto all = ends(dexel);
    const double b = lattice_.b_of(column);
    const double c = lattice_.c_of(row);
    for (std::size_t i = 0; i < all.size(); i += 2) {
      std::uint32_t& number = piece_of[sets_.of(first_[dexel] + static_cast<std::uint32_t>(i / 2))];
      if (number == kNone) {
        number = static_cast<std::uint32_t>(pieces.size());
        pieces.push_back(
            {0, {{kNowhere, kNowhere, kNowhere}, {-kNowhere, -kNowhere, -kNowhere}}, false, {}});
      }
      Piece& piece = pieces[number];
      piece.volume_mm3 += double{all[i + 1].at - all[i].at} * lattice_.cell_area();
      widen(along_axis(lattice_.axis, double{all[i].at}, b - lattice_.cell_b / 2,
                       c - lattice_.cell_c / 2),
            piece.extents);
      widen(along_axis(lattice_.axis, double{all[i + 1].at}, b + lattice_.cell_b / 2,
                       c + lattice_.cell_c / 2),
            piece.extents);
      for (const std::size_t end : {i, i + 1}) add_motion(all[end].motion, piece);
    }
  }

  static void widen(Vec3 place, Bounds& box) {
    box.low = {std::min(box.low.x, place.x), std::min(box.low.y, place.y),
               std::min(box.low.z, place.z)};
    box.high = {std::max(box.high.x, place.x), std::max(box.high.y, place.y),
                std::max(box.high.z, place.z)};
  }

  static void add_motion(std::uint32_t motion, Piece& piece) {
    if (motion == 0 || (!piece.cut_by.empty() && piece.cut_by.back() == motion)) return;
    piece.cut_by.push_back(motion);
    if (piece.cut_by.size() >= 2 * Piece::kMostCutBy + 4096) keep_latest(piece.cut_by);
  }

  static void keep_latest(std::vector<std::uint32_t>& motions) {
    std::sort(motions.begin(), motions.end());
    motions.erase(std::unique(motions.begin(), motions.end()), motions.end());
    if (motions.size() > Piece::kMostCutBy)
      motions.erase(motions.begin(), motions.end() - Piece::kMostCutBy);
  }

  void finish(Piece& piece) const {
    piece.extents.low = piece.extents.low + dexels_.middle();
    piece.extents.high = piece.extents.high + dexels_.middle();
    piece.held = piece.extents.low.z <= bottom_mm_ + dexels_.grain_mm();
    if (piece.held) {
      piece.cut_by.clear();
    } else {
      keep_latest(piece.cut_by);
    }
  }

  const TriDexel& dexels_;
  int grid_;
  const Lattice& lattice_;
  double bottom_mm_;
  std::vector<std::uint32_t> first_;
  Sets sets_;
};

}  // namespace

std::vector<Piece> pieces_of(const TriDexel& dexels, int grid, double bottom_mm) {
  return Search(dexels, grid, bottom_mm).run();
}

}  // namespace kerf::stock::dexel
