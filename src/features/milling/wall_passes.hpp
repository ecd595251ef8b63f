#pragma once

#include <memory>
#include <optional>
#include <set>

#include "features/milling/wall_row.hpp"
#include "features/tree/feature.hpp"
#include "geometry/contour/box_tree.hpp"

namespace kerf::features {

/// The rows of a layer by the walls they leave. Where passes end at a wall that another row goes
/// along, rounded words let them stand out by some thousandths, or hide that row altogether: the
/// wall is the one of the few rows that go farthest beside it.
class WallPasses {
 public:
  /// Both must outlive this.
  WallPasses(const Recording& recording, const Layer& layer)
      : recording_(recording), layer_(layer) {}

  /// The wall as those rows leave it. Nothing: no pass ends at it, or they leave another one.
  [[nodiscard]] std::optional<contour::Contour> cleaned(const contour::Contour& wall);

 private:
  [[nodiscard]] bool is_end_of_pass(const contour::Contour& wall, std::size_t edge) const;
  [[nodiscard]] bool has_ends_of_passes(const contour::Contour& wall) const;
  void index_rows();
  [[nodiscard]] std::optional<WallRow> longest_beside(const contour::Edge& edge) const;
  [[nodiscard]] std::set<std::uint32_t> rows_along(const contour::Contour& wall) const;
  [[nodiscard]] std::vector<contour::Region> swept(const std::set<std::uint32_t>& rows) const;

  const Recording& recording_;
  const Layer& layer_;
  std::vector<std::uint32_t> rows_;
  std::unique_ptr<contour::BoxTree> tree_;
};

}  // namespace kerf::features
