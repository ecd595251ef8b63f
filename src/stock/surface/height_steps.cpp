#include "stock/surface/height_steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "stock/surface/internal/cell_cycles.hpp"
#include "stock/surface/internal/places.hpp"

namespace kerf::stock::surface {
namespace {

constexpr double kAside = 1e-3;  // of a cell

/// From where to where a post is solid, in steps; low >= high: it is not there.
struct Post {
  std::int32_t low = 0;
  std::int32_t high = 0;
  std::uint32_t owner = 0;

  [[nodiscard]] bool is_one() const { return low < high; }
  [[nodiscard]] bool is_solid_above(std::int32_t z) const { return low <= z && z < high; }
};

/// The posts around the vertical lines between them. Where a post begins or ends, the four lines
/// around it have a knot there. A knot sees four posts below it and four above, as a cell of a
/// lattice sees its corners: the surface runs through it in one line or several (CellCycles), each
/// of which has a point.
class Steps {
 public:
  explicit Steps(const field::Columns& columns)
      : columns_(columns), grid_(columns.grid()), nx_(grid_.nx + 1), ny_(grid_.ny + 1) {
    const Bounds& box = grid_.box;
    const double far =
        std::max({std::fabs(box.low.x), std::fabs(box.high.x), std::fabs(box.low.y),
                  std::fabs(box.high.y), std::fabs(box.low.z), std::fabs(box.high.z)});
    step_ = 1.0 / 65536;
    while (step_ < 16 * far * 1.2e-7) step_ *= 2;
    aside_ = std::max(kAside * std::min(grid_.cell_x(), grid_.cell_y()), 8 * step_);
  }

  Surface make() {
    find_knots();
    find_turned();
    add_points();
    for (int j = 0; j < grid_.ny; ++j) {
      for (int i = 0; i < grid_.nx; ++i) add_ends(i, j);
    }
    for (int j = 0; j < ny_; ++j) {
      for (int i = 0; i < nx_; ++i) {
        add_walls(0, i, j);
        add_walls(1, i, j);
      }
    }
    return std::move(surface_);
  }

 private:
  struct Knot {
    std::int32_t z = 0;
    std::uint8_t form = 0;
    std::uint8_t turned = 0;
    std::uint32_t point = 0;  ///< of its first line
  };

  [[nodiscard]] Post post(int i, int j) const {
    if (i < 0 || j < 0 || i >= grid_.nx || j >= grid_.ny) return {};
    return {steps(columns_.bottom(i, j)), steps(columns_.height(i, j)), columns_.owner(i, j)};
  }
  [[nodiscard]] std::int32_t steps(float height) const {
    return static_cast<std::int32_t>(std::nearbyint(double{height} / step_));
  }

  [[nodiscard]] std::size_t line(int i, int j) const { return index(j) * index(nx_) + index(i); }
  [[nodiscard]] std::span<Knot> knots(int i, int j) {
    const std::size_t at = line(i, j);
    return std::span(knots_).subspan(first_[at], first_[at + 1] - first_[at]);
  }
  [[nodiscard]] Knot& knot(int i, int j, std::int32_t z) {
    const auto all = knots(i, j);
    return *std::lower_bound(all.begin(), all.end(), z,
                             [](const Knot& k, std::int32_t at) { return k.z < at; });
  }

  void find_knots() {
    for (int j = 0; j < ny_; ++j) {
      for (int i = 0; i < nx_; ++i) {
        first_.push_back(knots_.size());
        find_knots(i, j);
      }
    }
    first_.push_back(knots_.size());
  }

  void find_knots(int i, int j) {
    const std::array<Post, 4> around{post(i - 1, j - 1), post(i, j - 1), post(i - 1, j),
                                     post(i, j)};
    std::vector<std::int32_t> heights;
    for (const Post& each : around) {
      if (each.is_one()) heights.insert(heights.end(), {each.low, each.high});
    }
    std::sort(heights.begin(), heights.end());
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
    for (const std::int32_t z : heights) {
      unsigned form = 0;
      for (std::size_t q = 0; q < 4; ++q) {
        if (around[q].is_solid_above(z - 1)) form |= 1U << q;
        if (around[q].is_solid_above(z)) form |= 16U << q;
      }
      knots_.push_back({z, static_cast<std::uint8_t>(form)});
    }
  }

  static bool doubles(const Knot& knot, int face) {
    return ((cycles_of(knot.form).doubled >> face) & 1) != 0;
  }

  /// Where two knots would share an edge of four faces.
  void find_turned() {
    for (int j = 0; j < ny_; ++j) {
      for (int i = 0; i < nx_; ++i) {
        const auto all = knots(i, j);
        for (std::size_t k = 0; k < all.size(); ++k) {
          if (k + 1 < all.size()) turn(all[k], all[k + 1], 2);
          if (doubles(all[k], 1)) turn(all[k], knot(i + 1, j, all[k].z), 0);
          if (doubles(all[k], 3)) turn(all[k], knot(i, j + 1, all[k].z), 1);
        }
      }
    }
  }
  static void turn(Knot& before, Knot& behind, int axis) {
    if (!doubles(before, 2 * axis + 1) || !doubles(behind, 2 * axis)) return;
    before.turned = static_cast<std::uint8_t>(before.turned | 2U << (2 * axis));
    behind.turned = static_cast<std::uint8_t>(behind.turned | 1U << (2 * axis));
  }

  [[nodiscard]] static CellCycles cycles(const Knot& knot) {
    return knot.turned == 0 ? cycles_of(knot.form) : make_cycles(knot.form, knot.turned);
  }

  void add_points() {
    for (int j = 0; j < ny_; ++j) {
      for (int i = 0; i < nx_; ++i) {
        const Vec3 foot{grid_.box.low.x + i * grid_.cell_x(), grid_.box.low.y + j * grid_.cell_y(),
                        grid_.box.low.z};
        const std::uint32_t owner = std::max({post(i - 1, j - 1).owner, post(i, j - 1).owner,
                                              post(i - 1, j).owner, post(i, j).owner});
        for (Knot& each : knots(i, j)) {
          each.point = static_cast<std::uint32_t>(surface_.mesh.points.size());
          const CellCycles through = cycles(each);
          for (std::uint8_t k = 0; k < through.count; ++k) {
            Vec3 place = foot + Vec3{0, 0, each.z * step_};
            if (through.count > 1) place = place + aside_ * outwards(through, k);
            surface_.mesh.points.push_back(place);
            surface_.point_owners.push_back(owner);
          }
        }
      }
    }
  }

  /// From a knot to the middle of the edges that a line crosses; of no two lines the same.
  [[nodiscard]] static Vec3 outwards(const CellCycles& through, std::uint8_t line) {
    Vec3 sum;
    double count = 0;
    for (int edge = 0; edge < kCellEdges; ++edge) {
      if (through.of_edge[index(edge)] != line) continue;
      const auto at = edge_begin(edge);
      Vec3 middle{at[0] - 0.5, at[1] - 0.5, at[2] - 0.5};
      (edge / 4 == 0 ? middle.x : edge / 4 == 1 ? middle.y : middle.z) = 0;
      sum = sum + middle;
      ++count;
    }
    return (1 / count) * sum;
  }

  [[nodiscard]] static std::uint32_t point(const Knot& knot, int edge) {
    return knot.point + cycles(knot).of_edge[index(edge)];
  }

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t owner) {
    surface_.mesh.triangles.push_back({a, b, c});
    surface_.owners.push_back(owner);
  }

  /// Top and bottom of a post.
  void add_ends(int i, int j) {
    const Post here = post(i, j);
    if (!here.is_one()) return;
    for (const std::int32_t z : {here.low, here.high}) {
      const auto at = [&](int x, int y) {
        return point(knot(i + x, j + y, z), edge_number(2, 1 - x, 1 - y));
      };
      const std::uint32_t a = at(0, 0), b = at(1, 0), c = at(1, 1), d = at(0, 1);
      if (z == here.high) {
        add(a, b, c, here.owner), add(a, c, d, here.owner);
      } else {
        add(a, c, b, 0), add(a, d, c, 0);
      }
    }
  }

  /// Between the line (i, j) and the next one across `axis`: where of the posts before and behind
  /// it one is solid and the other is not.
  void add_walls(int axis, int i, int j) {
    const bool is_x = axis == 0;
    if (is_x ? j == grid_.ny : i == grid_.nx) return;
    const Post before = is_x ? post(i - 1, j) : post(i, j - 1);
    const Post behind = post(i, j);
    if (before.is_one()) add_differences(axis, i, j, before, behind, true);
    if (behind.is_one()) add_differences(axis, i, j, behind, before, false);
  }

  void add_differences(int axis, int i, int j, const Post& solid, const Post& empty,
                       bool faces_on) {
    const std::uint32_t owner = empty.is_one() && empty.owner != 0 ? empty.owner : solid.owner;
    if (!empty.is_one() || empty.high <= solid.low || empty.low >= solid.high) {
      add_wall(axis, i, j, {solid.low, solid.high, owner}, faces_on);
      return;
    }
    if (solid.low < empty.low) add_wall(axis, i, j, {solid.low, empty.low, owner}, faces_on);
    if (empty.high < solid.high) add_wall(axis, i, j, {empty.high, solid.high, owner}, faces_on);
  }

  /// `piece`: from where to where. Both sides of it may have knots in between.
  void add_wall(int axis, int i, int j, const Post& piece, bool faces_on) {
    const bool is_x = axis == 0;
    const auto left = side(axis, i, j, true, piece);
    const auto right =
        is_x ? side(axis, i, j + 1, false, piece) : side(axis, i + 1, j, false, piece);
    // Seen from where it faces, Y leads to the right of X, and Z X to the left of Y.
    const bool is_turned = is_x != faces_on;
    std::size_t a = 0;
    std::size_t b = 0;
    while (a + 1 < left.size() || b + 1 < right.size()) {
      const bool takes_left =
          b + 1 == right.size() || (a + 1 < left.size() && left[a + 1].z <= right[b + 1].z);
      const std::uint32_t next = takes_left ? left[a + 1].point : right[b + 1].point;
      if (is_turned) {
        add(left[a].point, next, right[b].point, piece.owner);
      } else {
        add(left[a].point, right[b].point, next, piece.owner);
      }
      (takes_left ? a : b) += 1;
    }
  }

  struct OnSide {
    std::int32_t z;
    std::uint32_t point;
  };
  /// Knots of a line along a piece of wall. `is_first`: the wall lies behind the line.
  std::vector<OnSide> side(int axis, int i, int j, bool is_first, const Post& piece) {
    std::vector<OnSide> out;
    const int place = is_first ? 1 : 0;
    for (const Knot& each : knots(i, j)) {
      if (each.z < piece.low || each.z > piece.high) continue;
      const int level = each.z < piece.high ? 1 : 0;  // the wall above it, or at its top below it
      const int edge = axis == 0 ? edge_number(0, place, level) : edge_number(1, level, place);
      out.push_back({each.z, point(each, edge)});
    }
    return out;
  }

  const field::Columns& columns_;
  const field::Grid& grid_;
  int nx_;
  int ny_;
  double step_ = 0;
  double aside_ = 0;
  std::vector<std::size_t> first_;  // of each line in knots_
  std::vector<Knot> knots_;
  Surface surface_;
};

}  // namespace

Surface height_steps(const field::Columns& columns) { return Steps(columns).make(); }

}  // namespace kerf::stock::surface
