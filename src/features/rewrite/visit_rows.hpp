#pragma once

#include <cstdint>
#include <vector>

#include "features/rewrite/planned_row.hpp"
#include "features/tree/feature.hpp"

namespace kerf::features {

/// The rows of a visit to a layer as they come anew, one behind the other. Entries and retracts are
/// those of the old visit, moved to where they are needed.
class VisitRows {
 public:
  VisitRows(const Recording& recording, Span visit, double z);

  [[nodiscard]] Vec2 at() const { return {at_.x, at_.y}; }
  [[nodiscard]] bool is_empty() const { return rows_.empty(); }
  /// The rows before `first`, moved by as much as its start.
  void approach(std::uint32_t first, Vec2 start);
  /// Straight at the level, as row `like` is fed.
  void go_straight(Vec2 to, std::uint32_t like);
  /// Along a way at the level, from its first vertex, where the last row ends.
  void go_along(const Contour& way, std::uint32_t like);
  /// Up as behind row `last`, across, and in again as the old visit came to row `first`.
  void go_over(Vec2 start, std::uint32_t first, std::uint32_t last);
  /// As some old rows went from one point to another: where they met these they meet the new ones,
  /// and what they touched beside keeps its place from the end.
  void go_like(Span rows, Vec2 old_from, Vec2 old_to, Vec2 to);
  /// The rows behind `last`, moved by as much as its end.
  void retract(std::uint32_t last);
  void put_moved(std::uint32_t row, Vec2 by);

  /// Those that stay keep their blocks.
  [[nodiscard]] Stretch done();
  [[nodiscard]] const std::vector<PlannedRow>& rows() const { return rows_; }

 private:
  void put(PlannedRow row);

  const Recording& recording_;
  Span visit_;
  double z_;
  Vec3 at_;
  std::vector<PlannedRow> rows_{};
};

}  // namespace kerf::features
