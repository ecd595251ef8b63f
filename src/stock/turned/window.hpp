#pragma once

#include <optional>
#include <vector>

#include "geometry/contour/region.hpp"

namespace kerf::stock::turned {

/// A region seen through a rectangle: what is cut inside of it needs no other edges.
///
/// Where a loop leaves the window it goes on along its border, as often round and in the sense that
/// the loop itself goes about the window; so each point inside is gone round as before. What was
/// outside is put back afterwards where the loop had left.
class Window {
 public:
  /// Nothing will be cut nearer to the border of `box` than contour::kSame_mm.
  Window(const contour::Region& region, const contour::Box& box);

  /// What of the region is in the window. False: it cannot be told safely.
  [[nodiscard]] bool is_good() const { return is_good_; }
  [[nodiscard]] const contour::Region& seen() const { return seen_; }

  /// The whole region with `left` in place of seen(); nothing where the ends do not fit.
  [[nodiscard]] std::optional<contour::Region> with(const contour::Region& left) const;

 private:
  /// Edges in a row.
  using Run = std::vector<contour::Edge>;
  struct Piece {
    contour::Edge edge;
    bool is_inside = false;
  };

  void take(const contour::Contour& loop);
  void split(const contour::Edge& edge, std::vector<Piece>& pieces) const;
  void take_crossing(std::vector<Piece> pieces);
  void go_round(const Run& run, contour::Contour& seen);
  [[nodiscard]] bool holds(contour::Vec2 point) const;
  [[nodiscard]] double angle_of(const contour::Edge& edge) const;

  contour::Box box_;
  bool is_good_ = true;
  contour::Region seen_;
  std::vector<contour::Contour> apart_;  ///< loops that the window does not meet
  std::vector<Run> outside_;
};

}  // namespace kerf::stock::turned
