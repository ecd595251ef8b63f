#include "geometry/contour/internal/pieces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/contour/tolerance.hpp"
#include "math/math.hpp"

namespace kerf::contour {
namespace {

constexpr double kQuarter = std::numbers::pi / 2;

class Divider {
 public:
  Divider(PointPool& pool, std::size_t count) : pool_(pool) { pieces_.reserve(count); }

  void take(const Strand& strand, std::uint32_t source) {
    source_ = source;
    passes_ = strand.operand == Operand::first ? Winding{1, 0} : Winding{0, 1};
    if (strand.edge.bulge == 0) {
      add(strand.edge.from, strand.edge.to, 0);
    } else {
      take_arc(strand.edge);
    }
  }

  std::vector<Piece> release() && { return std::move(pieces_); }

 private:
  // Between ends nearer to each other than the tolerance only the long way round is something.
  void take_arc(const Edge& edge) {
    const Vec2 middle = centre(edge);
    const double r = radius(edge);
    const double sweep = sweep_rad(edge);
    if (!(r > kSame_mm / 2) || !std::isfinite(r)) return add(edge.from, edge.to, 0);
    const Vec2 arm = edge.from - middle;
    const double begin = math::atan2(arm.v, arm.u);
    const double sign = sweep > 0 ? 1 : -1;
    const double slack = 2 * kSame_mm / r;
    double done = 0;
    Vec2 from = edge.from;
    for (double quarter = first_quarter(begin, sign);; quarter += sign) {
      const double ahead = sign * (quarter * kQuarter - begin);
      if (ahead <= slack) continue;
      if (ahead >= std::fabs(sweep) - slack) break;
      const Vec2 to = middle + r * way_of(quarter);
      add(from, to, sign * math::tan((ahead - done) / 4));
      from = to;
      done = ahead;
    }
    const double rest = std::fabs(sweep) - done;
    add(from, edge.to, done == 0 ? edge.bulge : sign * math::tan(rest / 4));
  }

  static double first_quarter(double begin, double sign) {
    return sign > 0 ? std::floor(begin / kQuarter) : std::ceil(begin / kQuarter);
  }

  static Vec2 way_of(double quarter) {
    switch ((static_cast<int>(quarter) % 4 + 4) % 4) {
      case 0: return {1, 0};
      case 1: return {0, 1};
      case 2: return {-1, 0};
      default: return {0, -1};
    }
  }

  void add(Vec2 from, Vec2 to, double bulge) {
    const PointId from_id = id_of(from);
    const PointId to_id = id_of(to);
    if (from_id == to_id) return;
    Piece piece = piece_between(pool_[from_id], pool_[to_id], bulge);
    piece.from_id = from_id;
    piece.to_id = to_id;
    piece.source = source_;
    piece.passes = passes_;
    pieces_.push_back(piece);
  }

  // Most pieces begin where the one before ended.
  PointId id_of(Vec2 point) {
    if (!(point == last_)) {
      last_ = point;
      last_id_ = pool_.add(point);
    }
    return last_id_;
  }

  PointPool& pool_;
  std::vector<Piece> pieces_;
  std::uint32_t source_ = 0;
  Winding passes_;
  Vec2 last_{std::numeric_limits<double>::quiet_NaN(), 0};
  PointId last_id_ = 0;
};

// From the lesser point to the greater.
void put_in_order(Piece& piece) {
  if (piece.from_id < piece.to_id) return;
  std::swap(piece.from_id, piece.to_id);
  std::swap(piece.from, piece.to);
  piece.direction = -piece.direction;
  piece.bulge = -piece.bulge;
  piece.flexure = -piece.flexure;
  piece.passes = -piece.passes;
}

struct Key {
  std::uint64_t ends = 0;
  std::uint32_t index = 0;
};

std::vector<Key> sorted_keys(const std::vector<Piece>& pieces) {
  std::vector<Key> keys(pieces.size());
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    keys[i] = {std::uint64_t{pieces[i].from_id} << 32U | pieces[i].to_id, i};
  }
  std::sort(keys.begin(), keys.end(), [&](const Key& a, const Key& b) {
    if (a.ends != b.ends) return a.ends < b.ends;
    const double apex_a = pieces[a.index].apex();
    const double apex_b = pieces[b.index].apex();
    return apex_a != apex_b ? apex_a < apex_b : a.index < b.index;
  });
  return keys;
}

bool is_one(const Piece& a, const Piece& b) {
  return a.from_id == b.from_id && a.to_id == b.to_id &&
         std::fabs(a.apex() - b.apex()) <= 2 * kSame_mm;
}

}  // namespace

std::vector<Piece> pieces_of(std::span<const Strand> strands, PointPool& pool) {
  Divider divider(pool, strands.size());
  for (std::size_t i = 0; i < strands.size(); ++i) {
    divider.take(strands[i], static_cast<std::uint32_t>(i));
  }
  return std::move(divider).release();
}

void merge_equal(std::vector<Piece>& pieces) {
  for (Piece& piece : pieces) put_in_order(piece);
  std::vector<Piece> merged;
  merged.reserve(pieces.size());
  const auto drop_if_none = [&] {
    if (!merged.empty() && merged.back().passes == Winding{}) merged.pop_back();
  };
  for (const Key& key : sorted_keys(pieces)) {
    const Piece& piece = pieces[key.index];
    if (!merged.empty() && is_one(merged.back(), piece)) {
      merged.back().passes = merged.back().passes + piece.passes;
    } else {
      drop_if_none();
      merged.push_back(piece);
    }
  }
  drop_if_none();
  pieces = std::move(merged);
}

}  // namespace kerf::contour
