#pragma once

#include <cstdint>
#include <vector>

#include "geometry/mesh/triangle_mesh.hpp"

namespace kerf::stock::surface {

/// The triangles of a closed surface by their corners: corner 3 t + k is that of triangle t at its
/// point k, and lies opposite to an edge, whose other triangle has a corner opposite to it, too.
/// Edges can be drawn together.
class CornerTable {
 public:
  using Corner = std::uint32_t;
  using Point = std::uint32_t;

  /// Every edge belongs to exactly two triangles, in opposite directions.
  CornerTable(std::vector<mesh::Triangle> triangles, std::size_t points);

  [[nodiscard]] static Corner next(Corner c) { return c % 3 == 2 ? c - 2 : c + 1; }
  [[nodiscard]] static Corner previous(Corner c) { return c % 3 == 0 ? c + 2 : c - 1; }
  [[nodiscard]] Point point(Corner c) const { return triangles_[c / 3][c % 3]; }
  [[nodiscard]] Corner opposite(Corner c) const { return opposite_[c]; }
  [[nodiscard]] bool is_there(std::uint32_t triangle) const { return is_there_[triangle]; }
  [[nodiscard]] std::size_t triangles() const { return count_; }
  [[nodiscard]] const mesh::Triangle& triangle(std::uint32_t t) const { return triangles_[t]; }

  /// act(corner at the point) of every triangle around it, in order. A point where several parts of
  /// the surface touch has only one of them here: is_whole() is false.
  template <class Act>
  void around(Point p, Act&& act) const {
    const Corner first = corner_of_[p];
    Corner c = first;
    do {
      act(c);
      c = next(opposite_[next(c)]);
    } while (c != first);
  }
  [[nodiscard]] bool is_whole(Point p) const { return is_whole_[p]; }

  /// Draws the edge opposite to a corner together: its end, the point of previous(c), becomes the
  /// one of next(c), and two triangles are gone. Precondition: can_collapse(c).
  void collapse(Corner c);
  /// What hangs together and how stays as it is: the ends have no neighbours in common but those of
  /// the two triangles.
  [[nodiscard]] bool can_collapse(Corner c);

 private:
  void link(Corner a, Corner b);
  void find_opposites();
  void find_whole();
  [[nodiscard]] std::size_t valence(Point p) const;

  std::vector<mesh::Triangle> triangles_;
  std::vector<Corner> opposite_;
  std::vector<Corner> corner_of_;  // of each point one
  std::vector<bool> is_there_;
  std::vector<bool> is_whole_;
  std::vector<std::uint32_t> seen_;  // of points: by which question
  std::uint32_t question_ = 0;
  std::size_t count_;
};

}  // namespace kerf::stock::surface
