#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/contour/internal/piece.hpp"

namespace kerf::contour {

/// Pieces that meet in their ends alone, each as two half-edges, 2i along piece i and 2i + 1 back;
/// round each point the half-edges that leave it, counterclockwise. That is all that is ever asked
/// of directions: what follows (faces, windings, loops) goes by this order and closes whatever it
/// is.
///
/// Half-edges are in order by where both would be at the length of the shorter one: pieces that do
/// not cross are there in the same order as where they begin, but farther from each other than
/// tangents and curvatures tell.
class PlanarMap {
 public:
  using HalfEdge = std::uint32_t;
  using Face = std::uint32_t;

  PlanarMap(std::vector<Piece> pieces, std::vector<Vec2> points);

  [[nodiscard]] std::span<const Piece> pieces() const { return pieces_; }
  [[nodiscard]] std::size_t half_edge_count() const { return 2 * pieces_.size(); }
  [[nodiscard]] std::size_t face_count() const { return face_begins_.size(); }

  [[nodiscard]] static HalfEdge twin(HalfEdge h) { return h ^ 1U; }
  [[nodiscard]] PointId origin(HalfEdge h) const {
    const Piece& piece = pieces_[h / 2];
    return (h & 1U) == 0 ? piece.from_id : piece.to_id;
  }
  [[nodiscard]] std::size_t point_count() const { return points_.size(); }
  [[nodiscard]] Vec2 point(PointId id) const { return points_[id]; }
  /// By how much the winding on the left is more than on the right.
  [[nodiscard]] Winding step(HalfEdge h) const {
    return (h & 1U) == 0 ? pieces_[h / 2].passes : -pieces_[h / 2].passes;
  }
  /// Half-edges that leave a point, counterclockwise, from the direction -x on; those of about that
  /// direction may all stand at one end.
  [[nodiscard]] std::span<const HalfEdge> ring(PointId id) const {
    return std::span(rings_).subspan(ring_begins_[id], ring_begins_[id + 1] - ring_begins_[id]);
  }
  /// The one clockwise of `h` round its origin.
  [[nodiscard]] HalfEdge clockwise_of(HalfEdge h) const {
    const PointId id = origin(h);
    const std::uint32_t place = places_[h];
    return rings_[place == ring_begins_[id] ? ring_begins_[id + 1] - 1 : place - 1];
  }
  /// Along the face on the left.
  [[nodiscard]] HalfEdge next(HalfEdge h) const { return clockwise_of(twin(h)); }
  [[nodiscard]] Face face(HalfEdge h) const { return faces_[h]; }
  /// A half-edge with this face on its left.
  [[nodiscard]] HalfEdge beginning(Face face) const { return face_begins_[face]; }

 private:
  void gather_rings();
  void sort_ring(PointId id);
  void walk_faces();
  [[nodiscard]] Vec2 tangent(HalfEdge h) const;
  [[nodiscard]] bool is_clockwise_of(HalfEdge a, HalfEdge b) const;

  std::vector<Piece> pieces_;
  std::vector<Vec2> points_;
  std::vector<std::uint32_t> ring_begins_;
  std::vector<HalfEdge> rings_;
  std::vector<std::uint32_t> places_;  ///< of each half-edge in rings_
  std::vector<Face> faces_;
  std::vector<HalfEdge> face_begins_;
};

}  // namespace kerf::contour
