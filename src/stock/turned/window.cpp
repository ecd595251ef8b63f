#include "stock/turned/window.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "math/math.hpp"
#include "stock/turned/edge_box.hpp"

namespace kerf::stock::turned {
namespace {

using contour::Box;
using contour::Contour;
using contour::Edge;
using contour::Region;
using contour::Vec2;

/// Owner of the border; no motion has it.
constexpr std::uint32_t kBorder = ~0U;
/// Ends that belong together are no farther apart.
constexpr double kSameEnd_mm = 1e-7;
constexpr double kStraight_mm = 1e-11;
constexpr double kTurn = 2 * std::numbers::pi;

std::array<Vec2, 4> corners_of(const Box& box) {
  return {box.low, {box.high.u, box.low.v}, box.high, {box.low.u, box.high.v}};
}

Contour border_of(const Box& box, bool is_counterclockwise) {
  Contour border;
  for (const Vec2 corner : corners_of(box)) border.vertices.push_back({corner, 0, kBorder});
  return is_counterclockwise ? border : contour::reversed(border);
}

double angle_between(Vec2 a, Vec2 b) { return math::atan2(cross(a, b), dot(a, b)); }

void add_share(double share, std::vector<double>& shares) {
  if (share > 0 && share < 1) shares.push_back(share);
}

/// Where the line or circle of an edge meets u = at, or v = at with u and v exchanged.
void add_crossings(const Edge& edge, double at, bool along_v, std::vector<double>& shares) {
  const auto first = [&](Vec2 p) { return along_v ? p.v : p.u; };
  if (edge.bulge == 0) {
    add_share((at - first(edge.from)) / (first(edge.to) - first(edge.from)), shares);
    return;
  }
  const Vec2 middle = contour::centre(edge);
  const double r = contour::radius(edge);
  const double off = at - first(middle);
  if (std::fabs(off) >= r) return;
  const double half = std::sqrt((r - off) * (r + off));
  for (const double other : {half, -half}) {
    const Vec2 arm = along_v ? Vec2{other, off} : Vec2{off, other};
    const double sweep = contour::sweep_rad(edge);
    double turn = angle_between(edge.from - middle, arm);
    if (sweep > 0 && turn < 0) turn += kTurn;
    if (sweep < 0 && turn > 0) turn -= kTurn;
    add_share(turn / sweep, shares);
  }
}

/// Two parts of one edge are one again.
bool join(Edge& first, const Edge& second) {
  if (first.owner != second.owner || (first.bulge == 0) != (second.bulge == 0)) return false;
  if (first.bulge * second.bulge < 0) return false;
  const double bulge = (first.bulge + second.bulge) / (1 - first.bulge * second.bulge);
  if (std::fabs(bulge) > 4 || bulge * first.bulge < 0) return false;
  const Edge both{first.from, second.to, bulge, first.owner};
  if (!(dot(contour::tangent_at_end(first), contour::tangent_at_start(second)) > 0)) return false;
  if (contour::distance(both, first.to) > kStraight_mm ||
      contour::distance(both, contour::point_at(first, 0.5)) > kStraight_mm)
    return false;
  first = both;
  return true;
}

Contour loop_of(const std::vector<Edge>& edges) {
  std::vector<Edge> kept;
  for (const Edge& edge : edges) {
    if (kept.empty() || !join(kept.back(), edge)) kept.push_back(edge);
  }
  if (kept.size() > 2 && join(kept.back(), kept.front())) {
    kept.front() = kept.back();
    kept.pop_back();
  }
  Contour loop;
  for (const Edge& edge : kept) loop.vertices.push_back({edge.from, edge.bulge, edge.owner});
  return loop;
}

bool is_near(Vec2 a, Vec2 b) { return geometry::length(a - b) <= kSameEnd_mm; }

/// Edges of a loop that are not the border's, in rows that the border parts.
void add_rows(const Contour& loop, std::vector<std::vector<Edge>>& rows) {
  const std::size_t count = contour::edge_count(loop);
  std::size_t begin = 0;
  while (begin < count && loop.vertices[begin].owner != kBorder) ++begin;
  bool is_open = false;
  for (std::size_t i = 1; i <= count; ++i) {
    const Edge edge = contour::edge_of(loop, (begin + i) % count);
    if (edge.owner == kBorder) {
      is_open = false;
      continue;
    }
    if (!is_open) rows.emplace_back();
    rows.back().push_back(edge);
    is_open = true;
  }
}

bool has_border(const Contour& loop) {
  return std::any_of(loop.vertices.begin(), loop.vertices.end(),
                     [](const contour::Vertex& vertex) { return vertex.owner == kBorder; });
}

}  // namespace

Window::Window(const Region& region, const Box& box) : box_(box) {
  for (const Contour& loop : region.loops) take(loop);
}

bool Window::holds(Vec2 point) const {
  return point.u > box_.low.u && point.u < box_.high.u && point.v > box_.low.v &&
         point.v < box_.high.v;
}

void Window::take(const Contour& loop) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < contour::edge_count(loop); ++i)
    split(contour::edge_of(loop, i), pieces);
  const auto is_inside = [](const Piece& piece) { return piece.is_inside; };
  if (std::all_of(pieces.begin(), pieces.end(), is_inside)) {
    seen_.loops.push_back(loop);
  } else if (std::any_of(pieces.begin(), pieces.end(), is_inside)) {
    take_crossing(std::move(pieces));
  } else {
    const int winding = contour::winding(loop, box_.middle());
    if (winding != 0) seen_.loops.push_back(border_of(box_, winding > 0));
    apart_.push_back(loop);
  }
}

void Window::split(const Edge& edge, std::vector<Piece>& pieces) const {
  const Box box = quick_box(edge);
  if (!box.meets(box_)) return pieces.push_back({edge, false});
  if (holds(box.low) && holds(box.high)) return pieces.push_back({edge, true});
  std::vector<double> shares{0, 1};
  add_crossings(edge, box_.low.u, false, shares);
  add_crossings(edge, box_.high.u, false, shares);
  add_crossings(edge, box_.low.v, true, shares);
  add_crossings(edge, box_.high.v, true, shares);
  std::sort(shares.begin(), shares.end());
  double from = 0;
  for (std::size_t i = 1; i < shares.size(); ++i) {
    const bool is_inside = holds(contour::point_at(edge, (from + shares[i]) / 2));
    const bool goes_on =
        i + 1 < shares.size() &&
        is_inside == holds(contour::point_at(edge, (shares[i] + shares[i + 1]) / 2));
    if (goes_on || shares[i] == from) continue;
    const bool is_whole = from == 0 && shares[i] == 1;
    pieces.push_back({is_whole ? edge : contour::part(edge, from, shares[i]), is_inside});
    from = shares[i];
  }
}

void Window::take_crossing(std::vector<Piece> pieces) {
  // It begins where the loop comes in.
  std::size_t first = 0;
  while (!pieces[first].is_inside || pieces[(first + pieces.size() - 1) % pieces.size()].is_inside)
    ++first;
  std::rotate(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(first), pieces.end());
  Contour seen;
  Run run;
  for (const Piece& piece : pieces) {
    if (!piece.is_inside) {
      run.push_back(piece.edge);
      continue;
    }
    if (!run.empty()) go_round(run, seen);
    run.clear();
    seen.vertices.push_back({piece.edge.from, piece.edge.bulge, piece.edge.owner});
  }
  go_round(run, seen);
  seen_.loops.push_back(std::move(seen));
}

// An arc as chords that do not come near the middle.
double Window::angle_of(const Edge& edge) const {
  const Vec2 middle = box_.middle();
  double parts = 1;
  const Box box = quick_box(edge);
  if (edge.bulge != 0 && box.meets({middle, middle})) {
    const double clear = std::min(box_.high.u - middle.u, box_.high.v - middle.v);
    const double turn = std::fabs(contour::sweep_rad(edge));
    parts = std::clamp(std::ceil(turn * std::sqrt(contour::radius(edge) / clear)), 2.0, 1000.0);
  }
  double sum = 0;
  Vec2 from = edge.from;
  for (double i = 1; i <= parts; ++i) {
    const Vec2 to = i == parts ? edge.to : contour::point_at(edge, i / parts);
    sum += angle_between(from - middle, to - middle);
    from = to;
  }
  return sum;
}

void Window::go_round(const Run& run, Contour& seen) {
  double turn = 0;
  for (const Edge& edge : run) turn += angle_of(edge);
  is_good_ = is_good_ && std::fabs(turn) < kTurn;
  const double sign = turn < 0 ? -1 : 1;
  std::vector<std::pair<double, Vec2>> passed;
  for (const Vec2 corner : corners_of(box_)) {
    double angle = sign * angle_between(run.front().from - box_.middle(), corner - box_.middle());
    if (angle < 0) angle += kTurn;
    if (angle < std::fabs(turn)) passed.push_back({angle, corner});
  }
  std::sort(passed.begin(), passed.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  seen.vertices.push_back({run.front().from, 0, kBorder});
  for (const auto& [angle, corner] : passed) seen.vertices.push_back({corner, 0, kBorder});
  outside_.push_back(run);
}

std::optional<Region> Window::with(const Region& left) const {
  Region whole{apart_};
  std::vector<Run> rows;
  for (const Contour& loop : left.loops) {
    if (has_border(loop)) {
      add_rows(loop, rows);
    } else {
      whole.loops.push_back(loop);
    }
  }
  if (rows.size() != outside_.size()) return std::nullopt;
  std::vector<bool> is_used(rows.size(), false);
  std::vector<bool> is_done(rows.size(), false);
  for (std::size_t first = 0; first < outside_.size(); ++first) {
    if (is_done[first]) continue;
    Run loop;
    std::size_t at = first;
    do {
      is_done[at] = true;
      loop.insert(loop.end(), outside_[at].begin(), outside_[at].end());
      const Vec2 in = outside_[at].back().to;
      std::size_t row = 0;
      while (row < rows.size() && (is_used[row] || !is_near(rows[row].front().from, in))) ++row;
      if (row == rows.size()) return std::nullopt;
      is_used[row] = true;
      loop.insert(loop.end(), rows[row].begin(), rows[row].end());
      const Vec2 out = rows[row].back().to;
      at = 0;
      while (at < outside_.size() && !is_near(outside_[at].front().from, out)) ++at;
      if (at == outside_.size() || (is_done[at] && at != first)) return std::nullopt;
    } while (at != first);
    whole.loops.push_back(loop_of(loop));
  }
  return whole;
}

}  // namespace kerf::stock::turned
