#include "geometry/contour/internal/arrangement.hpp"

#include "geometry/contour/internal/breaking.hpp"
#include "geometry/contour/internal/loops.hpp"
#include "geometry/contour/internal/pieces.hpp"

namespace kerf::contour {
namespace {

PlanarMap map_of(std::span<const Strand> strands) {
  PointPool pool(strands.size() * 5 / 4);
  std::vector<Piece> pieces = pieces_of(strands, pool);
  pieces = broken(std::move(pieces), pool);
  return {std::move(pieces), std::move(pool).release()};
}

// Points that moved to others may have carried pieces over third ones: those meet in a next round.
PlanarMap broken_again(const PlanarMap& map) {
  PointPool pool(map.half_edge_count());
  std::vector<Piece> pieces(map.pieces().begin(), map.pieces().end());
  for (Piece& piece : pieces) {
    piece.from_id = pool.add(piece.from);
    piece.to_id = pool.add(piece.to);
  }
  pieces = broken(std::move(pieces), pool);
  return {std::move(pieces), std::move(pool).release()};
}

constexpr int kMostRounds = 4;

}  // namespace

Arrangement::Arrangement(std::vector<Strand> strands)
    : strands_(std::move(strands)), map_(map_of(strands_)), windings_(face_windings(map_)) {
  for (int round = 1; round < kMostRounds && !windings_.agree; ++round) {
    map_ = broken_again(map_);
    windings_ = face_windings(map_);
  }
}

std::vector<bool> Arrangement::taken(const Takes& takes) const {
  std::vector<bool> result(windings_.of_face.size());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = takes(windings_.of_face[i]);
  return result;
}

std::vector<Contour> Arrangement::loops_of_strands(const Takes& takes) const {
  return joined_loops(map_, taken(takes), strands_);
}

std::vector<Contour> Arrangement::loops(const Takes& takes) const {
  std::vector<Contour> result = loops_of_strands(takes);
  for (Contour& loop : result) give_owners(loop, strands_);
  return result;
}

}  // namespace kerf::contour
