#include "planner/chain.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::planner {
namespace {

using base::AxisVector;
using base::TipJet;
using base::TipPoint;

constexpr std::uint64_t kMostSpread = 32;
constexpr std::uint64_t kLongestPiece = 2 * kMostSpread;  // lines
constexpr std::uint64_t kLookAhead = kLongestPiece + kMostSpread;
constexpr std::size_t kPoints = 512;
constexpr std::uint64_t kShortestChain = 4;  // lines
// A corner that turns more is one that was meant.
constexpr double kSharpestTurn_rad = 0.35;

/// As many axes as are computed with at once; what lies beyond those of the machine is 0.
constexpr std::size_t kLanes = 4;
using Lanes = std::array<double, kLanes>;
static_assert(base::kMaxAxes % kLanes == 0);

Lanes lanes_of(const AxisVector& v, std::size_t first) {
  Lanes lanes;
  std::copy_n(v.values.begin() + static_cast<std::ptrdiff_t>(first), kLanes, lanes.begin());
  return lanes;
}

void add_times(Lanes& to, double factor, const Lanes& what) {
  for (std::size_t i = 0; i < kLanes; ++i) to[i] += factor * what[i];
}

/// Solves the symmetric positive system of four equations M_ij = moments[i + j] for each lane, in
/// place.
void solve(const std::array<double, 7>& moments, std::array<Lanes, 4>& right) {
  std::array<std::array<double, 4>, 4> m;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) m[i][j] = moments[i + j];
  }
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t i = k + 1; i < 4; ++i) {
      const double factor = m[i][k] / m[k][k];
      for (std::size_t j = k; j < 4; ++j) m[i][j] -= factor * m[k][j];
      add_times(right[i], -factor, right[k]);
    }
  }
  for (std::size_t k = 4; k-- > 0;) {
    for (std::size_t j = k + 1; j < 4; ++j) add_times(right[k], -m[k][j], right[j]);
    for (double& value : right[k]) value /= m[k][k];
  }
}

}  // namespace

ChainSmoother::ChainSmoother(double tolerance_mm, std::size_t axes,
                             const motion::LinearAxes& linear, Follower& follower)
    : tolerance_(tolerance_mm),
      axes_(axes),
      norms_{linear, axes},
      follower_(follower),
      points_(kPoints) {}

void ChainSmoother::start(const TipPoint& from) {
  points_.clear();
  points_.push({from, 0, {}, {}});
  at_ = origin_ = points_.begin();
  node_known_ = false;
}

// The arc that two lines may stand for: with a turn β its height above the shorter one is Lβ/8.
bool ChainSmoother::accepts(const TipPoint& to, double length) const {
  const Point& end = points_[points_.end() - 1];
  const Point& before = points_[points_.end() - 2];
  const double last_length = end.way - before.way;
  AxisVector turn;
  for (std::size_t m = 0; m < axes_; ++m) {
    turn.values[m] = (to.values[m] - end.at.values[m]) / length -
                     (end.at.values[m] - before.at.values[m]) / last_length;
  }
  const double angle = norms_.larger(turn);
  return angle < kSharpestTurn_rad && std::max(length, last_length) * angle / 8 < tolerance_;
}

void ChainSmoother::add(const TipPoint& to, double length, const Pace& pace,
                        const motion::Mark& mark) {
  const double way = points_.back().way + length;
  points_.push({to, way, pace, mark});
}

// Value and derivatives, at the point `at`, of the parabola through three points in their order.
TipJet ChainSmoother::parabola(std::uint64_t a, std::uint64_t b, std::uint64_t c,
                               std::uint64_t at) const {
  const Point& pa = points_[a];
  const Point& pb = points_[b];
  const Point& pc = points_[c];
  const double first = pb.way - pa.way;
  const double second = pc.way - pb.way;
  const double offset = points_[at].way - pb.way;
  TipJet jet;
  jet.value = points_[at].at;
  for (std::size_t m = 0; m < axes_; ++m) {
    const double d1 = (pb.at.values[m] - pa.at.values[m]) / first;
    const double d2 = (pc.at.values[m] - pb.at.values[m]) / second;
    const double bend = 2 * (d2 - d1) / (first + second);
    jet.second.values[m] = bend;
    jet.first.values[m] = (d1 * second + d2 * first) / (first + second) + offset * bend;
  }
  return jet;
}

// The cubic that is nearest to the points first to last (least squares), as seen from point `at`.
// Its coefficients solve M c = r with the moments M_ij = Σ σ^(i+j), r_i = Σ σ^i p, where σ =
// s/scale lies about in [-1, 1], so that the four equations are well conditioned.
TipJet ChainSmoother::cubic(std::uint64_t first, std::uint64_t last, std::uint64_t at) const {
  const double origin = points_[at].way;
  const double scale = std::max(points_[last].way - origin, origin - points_[first].way);
  TipJet jet;
  for (std::size_t lane = 0; lane < axes_; lane += kLanes) {
    const Lanes here = lanes_of(points_[at].at, lane);
    std::array<double, 7> moments{};
    std::array<Lanes, 4> sums{};
    for (std::uint64_t n = first; n <= last; ++n) {
      const double sigma = (points_[n].way - origin) / scale;
      Lanes offset = lanes_of(points_[n].at, lane);
      add_times(offset, -1, here);
      double power = 1;
      for (std::size_t k = 0; k < 7; ++k, power *= sigma) {
        moments[k] += power;
        if (k < 4) add_times(sums[k], power, offset);
      }
    }
    solve(moments, sums);
    for (std::size_t i = 0; i < kLanes; ++i) {
      const std::size_t m = lane + i;
      jet.value.values[m] = here[i] + sums[0][i];
      jet.first.values[m] = sums[1][i] / scale;
      jet.second.values[m] = 2 * sums[2][i] / (scale * scale);
      jet.third.values[m] = 6 * sums[3][i] / (scale * scale * scale);
    }
  }
  return jet;
}

bool ChainSmoother::fits(const TipJet& jet, std::uint64_t at, std::uint64_t first,
                         std::uint64_t last) const {
  for (std::uint64_t n = first; n <= last; ++n) {
    const double s = points_[n].way - points_[at].way;
    AxisVector difference;
    for (std::size_t m = 0; m < axes_; ++m) {
      const double bend = jet.second.values[m] / 2 + s * jet.third.values[m] / 6;
      difference.values[m] =
          jet.value.values[m] + s * (jet.first.values[m] + s * bend) - points_[n].at.values[m];
    }
    if (norms_.larger(difference) > tolerance_ / 2) return false;
  }
  return true;
}

// Direction and curvature of the widest cubic that lies near to all of its points; of three points
// it is a parabola. The chain's ends stay where they are.
ChainSmoother::Node ChainSmoother::node_at(std::uint64_t number, std::uint64_t last,
                                           std::uint64_t spread) const {
  const std::uint64_t before = number - origin_;
  const std::uint64_t behind = last - number;
  const bool at_begin = before == 0;
  const bool at_end = behind == 0;
  const std::uint64_t most = at_begin ? behind / 2 : at_end ? before / 2 : std::min(before, behind);
  for (spread = std::clamp<std::uint64_t>(spread, 1, std::max<std::uint64_t>(most, 1));;
       spread /= 2) {
    const std::uint64_t first = at_begin ? number : at_end ? number - 2 * spread : number - spread;
    const std::uint64_t end = first + 2 * spread;
    if (spread == 1) return {parabola(first, first + 1, end, number), spread};
    Node node{cubic(first, end, number), spread};
    if (!fits(node.jet, number, first, end)) continue;
    if (at_begin || at_end) node.jet.value = points_[number].at;
    return node;
  }
}

// A curve may end where the feed changes, but not go beyond.
std::uint64_t ChainSmoother::furthest(std::uint64_t last) const {
  const std::uint64_t most = std::min({at_ + kLongestPiece, last, at_ + 2 * node_.spread});
  const Point& first = points_[at_ + 1];
  for (std::uint64_t n = at_ + 2; n <= most; ++n) {
    if (points_[n].pace != first.pace) return n - 1;
  }
  return most;
}

bool ChainSmoother::follows(const motion::Curve& curve, std::uint64_t last) const {
  const double way = points_[at_].way;
  double longest = 0;
  for (std::uint64_t n = at_ + 1; n <= last; ++n) {
    longest = std::max(longest, points_[n].way - points_[n - 1].way);
    if (n < last && norms_.larger(curve.at(points_[n].way - way) - points_[n].at) > tolerance_ / 2)
      return false;
  }
  return norms_.larger(curve.bounds(0, curve.length()).second) * longest * longest / 8 <=
         tolerance_ / 2;
}

bool ChainSmoother::next(bool ended, Piece& piece) {
  forget(ended);
  const std::uint64_t last = points_.end() - 1;
  if (at_ >= last || (!ended && last - at_ < kLookAhead)) return false;
  piece.joined = node_known_;
  piece.first = at_;
  if (last - origin_ < kShortestChain) {
    line_piece(piece);
    return true;
  }
  if (!node_known_) node_ = node_at(at_, last, kMostSpread);
  for (std::uint64_t to = furthest(last);; to = at_ + (to - at_) / 2) {
    if (to == at_) {
      line_piece(piece);
      return true;
    }
    const Node node = node_at(to, last, std::min(2 * node_.spread, kMostSpread));
    piece.curve =
        motion::Curve::hermite(node_.jet, node.jet, points_[to].way - points_[at_].way, axes_);
    if (!follows(piece.curve, to) || !follower_.can_follow(piece.curve)) continue;
    piece.begin_off_mm = 0;
    piece.begin_turn = turn(node_.jet.first, at_ + 1);
    piece.end_turn = turn(node.jet.first, to);
    node_ = node;
    node_known_ = true;
    piece.last = at_ = to;
    return true;
  }
}

double ChainSmoother::turn(const AxisVector& direction, std::uint64_t line) const {
  const Point& from = points_[line - 1];
  const Point& to = points_[line];
  AxisVector difference = direction;
  for (std::size_t m = 0; m < axes_; ++m)
    difference.values[m] -= (to.at.values[m] - from.at.values[m]) / (to.way - from.way);
  return norms_.larger(difference);
}

// What no curve fits stays a line. It begins where the curve before has ended.
void ChainSmoother::line_piece(Piece& piece) {
  const Point& from = points_[at_];
  const Point& to = points_[at_ + 1];
  const TipPoint& begin = node_known_ ? node_.jet.value : from.at;
  piece.curve = motion::Curve::line(begin, to.at, to.way - from.way, axes_);
  piece.joined = false;
  piece.begin_off_mm = norms_.larger(begin - from.at);
  piece.begin_turn = piece.end_turn = 0;
  piece.last = origin_ = ++at_;
  node_known_ = false;
}

// Points that no parabola reaches any more.
void ChainSmoother::forget(bool ended) {
  const std::uint64_t last = points_.end() - 1;
  const std::uint64_t keep = ended && at_ == last ? at_ : at_ - std::min(at_, kMostSpread);
  while (points_.begin() < keep && points_.begin() < at_) points_.pop();
  origin_ = std::max(origin_, points_.begin());
}

}  // namespace kerf::planner
