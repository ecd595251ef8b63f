#include "features/rewrite/followed_contour.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "features/path/tolerance.hpp"
#include "features/rewrite/element_map.hpp"
#include "geometry/arc.hpp"
#include "geometry/contour/edit.hpp"

namespace kerf::features {
namespace {

using contour::Contour;
using contour::Edge;

constexpr double kOn_mm = 2.5e-3;     // beside an element, as words are rounded
constexpr double kLeastRunIn = 0.5;   // of the way before an element that must be left of it
constexpr double kCorner_rad = 0.01;  // less than that goes on smoothly
constexpr double kTurn_rad = 2 * std::numbers::pi;

/// A line, or an arc of any angle.
struct Track {
  Vec2 from{};
  Vec2 to{};
  std::optional<ArcRow> arc{};
};

Vec2 way_at_start(const Edge& edge) { return geometry::unit(contour::tangent_at_start(edge)); }
Vec2 way_at_end(const Edge& edge) { return geometry::unit(contour::tangent_at_end(edge)); }
double turned_rad(Vec2 was, Vec2 is) {
  return math::atan2(geometry::cross(was, is), geometry::dot(was, is));
}
bool is_near(Vec2 a, Vec2 b) { return geometry::length(a - b) <= kOn_mm; }

bool is_on_line(const Edge& line, Vec2 point) {
  return line.bulge == 0 &&
         std::fabs(geometry::cross(way_at_start(line), point - line.from)) <= kOn_mm;
}

/// The point of a line at the same place along the axis that it runs more along.
Vec2 at_same_place(const Edge& line, Vec2 point) {
  const Vec2 way = line.to - line.from;
  const bool is_upright = std::fabs(way.u) < std::fabs(way.v);
  const double share =
      is_upright ? (point.v - line.from.v) / way.v : (point.u - line.from.u) / way.u;
  return line.from + share * way;
}

/// Where rows begin that began at `old` along or before an element that has become another.
Vec2 new_begin(const Edge& was, const Edge& is, Vec2 old) {
  if (is_near(old, was.from)) return is.from;
  const double before = -geometry::dot(way_at_start(was), old - was.from);
  const bool runs_in = was.bulge == 0 && before > 0 && is_on_line(was, old);
  if (!runs_in) return contour::point_at(is, contour::nearest_share(is, old));
  const double least = kLeastRunIn * before;
  if (is_on_line(is, old) && geometry::dot(way_at_start(is), is.from - old) >= least) return old;
  if (is.bulge == 0) {
    const Vec2 there = at_same_place(is, old);
    const double run = geometry::dot(way_at_start(is), is.from - there);
    if (run >= least && run <= before / kLeastRunIn) return there;
  }
  return is.from - before * way_at_start(is);
}

Vec2 new_end(const Edge& was, const Edge& is, Vec2 old) {
  return new_begin(contour::reversed(was), contour::reversed(is), old);
}

double angle_of(Vec2 arm) { return math::atan2(arm.v, arm.u); }

/// All of a contour as one circle.
std::optional<Edge> circle_of(const Contour& contour) {
  if (!contour.is_closed || contour::edge_count(contour) != 2) return std::nullopt;
  const Edge a = contour::edge_of(contour, 0);
  const Edge b = contour::edge_of(contour, 1);
  if (a.bulge == 0 || b.bulge == 0 || !is_near(contour::centre(a), contour::centre(b)))
    return std::nullopt;
  return a;
}

/// Makes the way along the new contour.
class Follower {
 public:
  Follower(const Recording& recording, const ContourChain& chain, const Contour& now)
      : recording_(recording),
        chain_(chain),
        now_(chain.is_reversed ? contour::reversed(now) : now),
        olds_(contour::edge_count(chain.contour)),
        news_(contour::edge_count(now_)) {
    for (std::uint32_t row = chain.rows.first; row <= chain.rows.last; ++row) {
      if (recording.goes_across(row)) rows_.push_back(row);
    }
  }

  [[nodiscard]] std::optional<FollowedContour> follow(NamedEnds named) {
    const auto was = circle_of(chain_.contour);
    const auto is = circle_of(now_);
    if (was && is) return round(*was, *is);
    if (!find_ends()) return std::nullopt;
    const Edge old_first = contour::edge_of(chain_.contour, chain_.first);
    const Edge new_first = contour::edge_of(now_, first_);
    const Edge old_last = contour::edge_of(chain_.contour, chain_.last());
    const Edge new_last = contour::edge_of(now_, (first_ + steps_) % news_);
    made_.begin = {chain_.begin, new_begin(old_first, new_first, chain_.begin),
                   turned_rad(way_at_start(old_first), way_at_start(new_first))};
    made_.end = {chain_.end, new_end(old_last, new_last, chain_.end),
                 turned_rad(way_at_end(old_last), way_at_end(new_last))};
    run_out(old_first, old_last, new_first, new_last);
    go_along();
    for (const Track& track : tracks_) divide(track);
    if (made_.rows.empty() || !pair(named)) return std::nullopt;
    return std::move(made_);
  }

 private:
  // Where the contour closed smoothly and does so in a corner now, it is left as far beyond that as
  // it is run into before it: else something stands in the corner.
  void run_out(const Edge& old_first, const Edge& old_last, const Edge& new_first,
               const Edge& new_last) {
    const double run_in = geometry::dot(way_at_start(new_first), new_first.from - made_.begin.is);
    const auto turns = [](const Edge& a, const Edge& b) {
      return std::fabs(turned_rad(way_at_end(a), way_at_start(b))) > kCorner_rad;
    };
    const bool closes = is_near(new_last.to, new_first.from) && is_near(made_.end.is, new_last.to);
    if (run_in > kOn_mm && closes && !turns(old_last, old_first) && turns(new_last, new_first))
      made_.end.is = made_.end.is + run_in * way_at_end(new_last);
  }

  // A circle: every block ends at the angle at which it did.
  [[nodiscard]] FollowedContour round(const Edge& was, const Edge& is) {
    const Vec2 centre = contour::centre(was);
    const auto place = [&](Vec2 point) {
      return contour::centre(is) + contour::radius(is) * geometry::unit(point - centre);
    };
    made_.begin = {chain_.begin, place(chain_.begin)};
    made_.end = {chain_.end, place(chain_.end)};
    for (const std::uint32_t row : rows_) {
      PlannedRow planned = as_it_is(recording_, row);
      planned.to = lifted(place(recording_.flat_to(row)));
      planned.arc->centre = contour::centre(is);
      made_.rows.push_back(planned);
    }
    return std::move(made_);
  }

  // Elements that the chain begins and ends along now.
  [[nodiscard]] bool find_ends() {
    if (news_ == 0) return false;
    const auto map = mapped_elements(chain_.contour, now_);
    const std::size_t last = chain_.last();
    if (!chain_.contour.is_closed) {
      const auto first = chain_.first == 0 ? std::optional<std::size_t>(0) : map[chain_.first];
      const auto end = last + 1 == olds_ ? std::optional(news_ - 1) : map[last];
      if (!first || !end || *end < *first) return false;
      first_ = *first;
      steps_ = *end - *first;
      return true;
    }
    const std::size_t rounds = chain_.steps / olds_;
    const std::size_t rest = chain_.steps % olds_;
    const bool is_whole = rest + 1 == olds_ || (rest == 0 && rounds > 0);
    if (!map[chain_.first] && !is_whole) return false;
    first_ = map[chain_.first]
                 ? *map[chain_.first]
                 : nearest_element(contour::edge_of(chain_.contour, chain_.first), now_);
    std::size_t new_rest = 0;
    if (rest + 1 == olds_) {
      new_rest = news_ - 1;
    } else if (rest > 0) {
      if (!map[last]) return false;
      new_rest = (*map[last] + news_ - first_) % news_;
    }
    steps_ = rounds * news_ + new_rest;
    return true;
  }

  void go_along() {
    for (std::size_t i = 0; i <= steps_; ++i) {
      const Edge whole = contour::edge_of(now_, (first_ + i) % news_);
      Edge edge = whole;
      if (i == 0) edge = begun(edge);
      if (i == steps_) edge = ended(edge);
      add(edge);
      if (i == steps_ && !is_near(edge.to, made_.end.is)) add({edge.to, made_.end.is});
    }
  }
  [[nodiscard]] Edge begun(const Edge& edge) {
    if (edge.bulge == 0) return {made_.begin.is, edge.to};
    if (contour::distance(edge, made_.begin.is) <= kOn_mm)
      return contour::with_start(edge, made_.begin.is);
    add({made_.begin.is, edge.from});
    return edge;
  }
  [[nodiscard]] Edge ended(const Edge& edge) const {
    if (edge.bulge == 0) return {edge.from, made_.end.is};
    if (is_near(edge.from, made_.end.is)) return {edge.from, edge.from};
    if (contour::distance(edge, made_.end.is) > kOn_mm) return edge;
    return contour::with_end(edge, made_.end.is);
  }

  // What goes on along one line or circle is one track.
  void add(const Edge& edge) {
    if (geometry::length(edge.to - edge.from) <= kSamePoint_mm) return;
    Track track{.from = edge.from, .to = edge.to};
    if (edge.bulge != 0) track.arc = ArcRow{contour::centre(edge), contour::sweep_rad(edge)};
    if (!tracks_.empty() && goes_on(tracks_.back(), track)) {
      tracks_.back().to = track.to;
      if (track.arc) tracks_.back().arc->sweep_rad += track.arc->sweep_rad;
    } else {
      tracks_.push_back(track);
    }
  }
  [[nodiscard]] static bool goes_on(const Track& a, const Track& b) {
    if (a.arc.has_value() != b.arc.has_value()) return false;
    if (!a.arc) {
      return is_on_line({a.from, a.to}, b.to) && geometry::dot(a.to - a.from, b.to - b.from) > 0;
    }
    return is_near(a.arc->centre, b.arc->centre) && a.arc->sweep_rad * b.arc->sweep_rad > 0 &&
           std::fabs(a.arc->sweep_rad + b.arc->sweep_rad) <= kTurn_rad + 1e-9;
  }

  // A row for each block that shared its element with the one before it, as far as they are on it.
  void divide(const Track& track) {
    std::vector<double> shares;
    for (std::size_t i = 1; i < rows_.size(); ++i) {
      const auto share = share_of(track, recording_.flat_from(rows_[i]));
      if (share && goes_on(track_of(rows_[i - 1]), track_of(rows_[i]))) shares.push_back(*share);
    }
    std::sort(shares.begin(), shares.end());
    double done = 0;
    for (const double share : shares) {
      if (share <= done) continue;
      put(track, done, share);
      done = share;
    }
    put(track, done, 1);
  }
  [[nodiscard]] Track track_of(std::uint32_t row) const {
    const PlannedRow planned = as_it_is(recording_, row);
    return {recording_.flat_from(row), recording_.flat_to(row), planned.arc};
  }
  /// Of a point on a track, but for its ends.
  [[nodiscard]] static std::optional<double> share_of(const Track& track, Vec2 point) {
    if (is_near(point, track.from) || is_near(point, track.to)) return std::nullopt;
    double share = 0;
    if (!track.arc) {
      if (!is_on_line({track.from, track.to}, point)) return std::nullopt;
      const Vec2 way = track.to - track.from;
      share = geometry::dot(point - track.from, way) / geometry::dot(way, way);
    } else {
      const Vec2 arm = point - track.arc->centre;
      const double off = geometry::length(arm) - geometry::length(track.from - track.arc->centre);
      if (std::fabs(off) > kOn_mm) return std::nullopt;
      const double angle =
          geometry::sweep_rad(track.from, point, track.arc->centre, track.arc->sweep_rad < 0);
      share = angle / std::fabs(track.arc->sweep_rad);
    }
    return share > 0 && share < 1 ? std::optional(share) : std::nullopt;
  }
  void put(const Track& track, double from, double to) {
    PlannedRow row{.to = lifted(track.to)};
    if (track.arc) {
      row.arc = ArcRow{track.arc->centre, (to - from) * track.arc->sweep_rad};
      const Vec2 arm = track.from - track.arc->centre;
      const double angle = angle_of(arm) + to * track.arc->sweep_rad;
      const auto [sine, cosine] = math::sine_cosine(angle);
      if (to < 1) row.to = lifted(track.arc->centre + geometry::length(arm) * Vec2{cosine, sine});
    } else if (to < 1) {
      row.to = lifted(track.from + to * (track.to - track.from));
    }
    made_.rows.push_back(row);
  }

  [[nodiscard]] Vec3 lifted(Vec2 point) const {
    return recording_.turns ? Vec3{point.v, 0, point.u} : Vec3{point.u, point.v, chain_.height};
  }

  // Which blocks stay. What comes in is fed as what comes before it.
  [[nodiscard]] bool pair(NamedEnds named) {
    std::vector<PlannedRow>& rows = made_.rows;
    align_along(recording_, rows_, lifted(made_.begin.is), rows);
    if (named.first && !pin(rows.front(), rows_.front())) return false;
    if (named.last && !pin(rows.back(), rows_.back())) return false;
    std::uint32_t like = rows_.front();
    for (PlannedRow& row : rows) {
      like = row.was.value_or(like);
      row.like = like;
    }
    return true;
  }
  [[nodiscard]] bool pin(PlannedRow& row, std::uint32_t old) {
    if (row.was == old) return true;
    for (PlannedRow& other : made_.rows) {
      if (other.was == old) other.was.reset();
    }
    row.was = old;
    const bool was_arc = recording_.moves[old].shape == Move::Shape::arc;
    return was_arc == row.arc.has_value();
  }

  const Recording& recording_;
  const ContourChain& chain_;
  Contour now_;
  std::size_t olds_;
  std::size_t news_;
  std::vector<std::uint32_t> rows_{};  // of the chain, that go somewhere
  std::size_t first_ = 0;              // element that the new ones begin along
  std::size_t steps_ = 0;
  std::vector<Track> tracks_{};
  FollowedContour made_{};
};

}  // namespace

std::optional<FollowedContour> followed(const Recording& recording, const ContourChain& chain,
                                        const Contour& now, NamedEnds named) {
  return Follower(recording, chain, now).follow(named);
}

}  // namespace kerf::features
