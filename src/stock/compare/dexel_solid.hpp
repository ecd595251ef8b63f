#pragma once

#include <atomic>
#include <vector>

#include "stock/compare/near_tree.hpp"
#include "stock/compare/part.hpp"
#include "stock/dexel/tri_dexel.hpp"

namespace kerf::stock::compare {

/// What three grids of dexels have left. Its points are the ends of dexels, which are exact; its
/// surface a disc about each of them, across its normal and as wide as the cells are apart, which
/// ends where the planes of its neighbours cut it off: so edges are sharp, in and out. A place
/// nearer to the surface than a cell is on the side of it that the nearest disc says, others on
/// that which the dexels beside them say.
class DexelSolid final : public Part {
 public:
  /// The dexels outlive this and are not cut meanwhile.
  explicit DexelSolid(const dexel::TriDexel& dexels);

  /// About what it takes of dexels in this box that have two ends each.
  [[nodiscard]] static double bytes_for(const Bounds& box, double cell_mm);

  [[nodiscard]] Near near(Vec3 place, Hint& hint) const override;
  [[nodiscard]] Bounds bounds() const override { return bounds_; }
  [[nodiscard]] std::size_t rows() const override;
  void row(std::size_t number, Row& row) const override;
  void inside(int axis, double b, double c, std::vector<Stretch>& out) const override;
  [[nodiscard]] double cell_mm() const override { return cell_mm_; }

 private:
  struct Disc {
    Vec3 at;
    dexel::Octahedral normal;
    std::uint32_t motion;
  };
  struct Seen;
  /// Where a row is: a tile of a grid.
  struct Place {
    int grid;
    std::size_t tile;
  };

  /// Whether neighbours can cut a disc off: found out when it is first asked for. Most of a smooth
  /// face is asked often, and nothing cuts it.
  enum class Edge : std::uint8_t { unknown, none, near };
  [[nodiscard]] bool is_at_edge(std::uint32_t disc) const;
  [[nodiscard]] bool find_edge(std::uint32_t disc) const;
  /// As much of the way from the middle of a disc to a point of its plane as neighbours leave.
  [[nodiscard]] double share_left(std::uint32_t disc, Vec3 way) const;
  [[nodiscard]] Seen seen_from(Vec3 place, std::uint32_t disc, double most) const;
  [[nodiscard]] double height_beside_edge(Vec3 place, const Seen& nearest) const;
  [[nodiscard]] Place place_of(std::size_t row) const;
  [[nodiscard]] bool holds(Vec3 place) const;

  const dexel::TriDexel& dexels_;
  Bounds bounds_;
  double cell_mm_ = 0;
  double radius_mm_ = 0;
  std::vector<Disc> discs_;
  NearTree tree_;
  mutable std::vector<std::atomic<Edge>> edges_;  // of the discs; whoever finds one finds the same
};

}  // namespace kerf::stock::compare
