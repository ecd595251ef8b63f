#include "geometry/contour/internal/breaking.hpp"

#include <algorithm>

#include "geometry/contour/internal/piece_tree.hpp"
#include "geometry/contour/internal/pieces.hpp"

namespace kerf::contour {
namespace {

struct Break {
  std::uint32_t piece = 0;
  PointId point = 0;
  double along = 0;

  friend bool operator<(const Break& a, const Break& b) {
    if (a.piece != b.piece) return a.piece < b.piece;
    return a.along != b.along ? a.along < b.along : a.point < b.point;
  }
};

class Breaker {
 public:
  Breaker(const std::vector<Piece>& pieces, PointPool& pool)
      : pieces_(pieces), pool_(pool), tree_(pieces), ends_(pool.size()) {}

  std::vector<Piece> run() {
    tree_.each_pair([&](std::uint32_t a, std::uint32_t b) { meet(a, b); });
    // Crossings of two are the concern of a third one that passes there.
    for (auto id = static_cast<PointId>(ends_); id < pool_.size(); ++id) {
      tree_.near_point(pool_[id], [&](std::uint32_t piece) { break_if_on(piece, id); });
    }
    std::sort(breaks_.begin(), breaks_.end());
    return parts();
  }

 private:
  void meet(std::uint32_t a, std::uint32_t b) {
    const Piece& first = pieces_[a];
    const Piece& second = pieces_[b];
    if (!may_meet(first, second) || is_plain_corner(first, second)) return;
    break_if_on(a, second.from_id);
    break_if_on(a, second.to_id);
    break_if_on(b, first.from_id);
    break_if_on(b, first.to_id);
    const Crossings found = crossings(first, second);
    for (std::size_t i = 0; i < found.count; ++i) {
      const PointId id = meeting_at(first, second, found.points[i]);
      add(a, id);
      add(b, id);
    }
  }

  // What is found behind an end, by rounding, is that end: a piece broken there would go back and
  // come again.
  PointId meeting_at(const Piece& a, const Piece& b, Vec2 point) {
    for (const Piece* const piece : {&a, &b}) {
      const double along = piece->in_frame(point).u;
      if (along <= 0) return piece->from_id;
      if (along >= piece->chord) return piece->to_id;
    }
    return pool_.add(point);
  }

  // Two lines that leave one point in directions that are not the same meet nowhere else.
  static bool is_plain_corner(const Piece& a, const Piece& b) {
    if (a.bulge != 0 || b.bulge != 0) return false;
    const double turn = cross(a.direction, b.direction);
    if (turn * turn < 1e-6) return false;
    const double shorter = std::min(a.chord, b.chord);
    if (shorter < 1e4 * kSame_mm) return false;
    return a.from_id == b.from_id || a.from_id == b.to_id || a.to_id == b.from_id ||
           a.to_id == b.to_id;
  }

  void break_if_on(std::uint32_t piece, PointId point) {
    if (is_end(piece, point)) return;
    if (lies_between_ends(pieces_[piece], pool_[point])) add(piece, point);
  }

  bool is_end(std::uint32_t piece, PointId point) const {
    return point == pieces_[piece].from_id || point == pieces_[piece].to_id;
  }

  void add(std::uint32_t piece, PointId point) {
    if (is_end(piece, point)) return;
    const double along = pieces_[piece].in_frame(pool_[point]).u;
    if (along > 0 && along < pieces_[piece].chord) breaks_.push_back({piece, point, along});
  }

  std::vector<Piece> parts() {
    std::vector<Piece> result;
    result.reserve(pieces_.size() + breaks_.size());
    std::size_t next = 0;
    for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
      const std::size_t begin = next;
      while (next < breaks_.size() && breaks_[next].piece == i) ++next;
      if (begin == next) {
        result.push_back(pieces_[i]);
      } else {
        add_parts(result, pieces_[i], begin, next);
      }
    }
    return result;
  }

  void add_parts(std::vector<Piece>& result, const Piece& whole, std::size_t begin,
                 std::size_t end) const {
    PointId from = whole.from_id;
    for (std::size_t i = begin; i <= end; ++i) {
      const PointId to = i == end ? whole.to_id : breaks_[i].point;
      if (to != from) result.push_back(part_of(whole, from, to));
      from = to;
    }
  }

  Piece part_of(const Piece& whole, PointId from, PointId to) const {
    const Vec2 begin = pool_[from];
    const Vec2 end = pool_[to];
    const double bulge =
        whole.bulge == 0 ? 0 : bulge_of_part(whole.flexure, geometry::length(end - begin));
    Piece piece = piece_between(begin, end, bulge);
    piece.from_id = from;
    piece.to_id = to;
    piece.source = whole.source;
    piece.passes = whole.passes;
    return piece;
  }

  const std::vector<Piece>& pieces_;
  PointPool& pool_;
  PieceTree tree_;
  std::size_t ends_;
  std::vector<Break> breaks_;
};

}  // namespace

std::vector<Piece> broken(std::vector<Piece> pieces, PointPool& pool) {
  merge_equal(pieces);
  std::vector<Piece> parts = Breaker(pieces, pool).run();
  merge_equal(parts);
  return parts;
}

}  // namespace kerf::contour
