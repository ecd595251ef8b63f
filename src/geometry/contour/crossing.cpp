#include "geometry/contour/crossing.hpp"

#include <cmath>
#include <tuple>

#include "geometry/contour/boolean.hpp"
#include "geometry/contour/internal/piece_tree.hpp"
#include "geometry/contour/internal/pieces.hpp"

namespace kerf::contour {
namespace {

// By how much areas and lengths differ that are equal but for rounding, here that of a program's
// digits: where edges lead on they may overlap by as much.
constexpr double kSameArea_mm2 = 1e-3;
constexpr double kSameLength_mm = 1e-2;
constexpr double kSameWay = 1e-7;  // sine of the angle between two edges that do not cross

// How many meetings are looked at: so many, and so many for each edge.
constexpr std::size_t kMostMeetings = 10000;
constexpr std::size_t kMostOfEdge = 8;

bool are_near(Vec2 a, Vec2 b, double tolerance) { return geometry::length(a - b) <= tolerance; }

Vec2 way_at(const Edge& edge, Vec2 point) {
  if (edge.bulge == 0) return geometry::unit(edge.to - edge.from);
  return geometry::unit(geometry::left_of(point - centre(edge)));
}

class MeetingSearch {
 public:
  MeetingSearch(std::span<const Contour> contours, double tolerance)
      : contours_(contours), tolerance_(tolerance) {
    std::vector<Strand> strands;
    for (std::size_t c = 0; c < contours.size(); ++c) {
      for (std::size_t i = 0; i < edge_count(contours[c]); ++i) {
        strands.push_back({edge_of(contours[c], i)});
        names_.push_back({c, i});
      }
    }
    PointPool pool(strands.size());
    pieces_ = pieces_of(strands, pool);
    left_ = kMostMeetings + kMostOfEdge * strands.size();
  }

  std::optional<Meeting> best() {
    PieceTree(pieces_).each_pair_while([&](std::uint32_t a, std::uint32_t b) {
      take_pair(pieces_[a], pieces_[b]);
      return left_ > 0;
    });
    return best_;
  }

 private:
  void take_pair(const Piece& a, const Piece& b) {
    if (a.source == b.source || !may_meet(a, b)) return;
    const bool in_order = names_[a.source] < names_[b.source];
    const Piece& first = in_order ? a : b;
    const Piece& second = in_order ? b : a;
    const Crossings found = crossings(first, second);
    for (std::size_t i = 0; i < found.count; ++i) take(first, second, found.points[i]);
    for (const Vec2 end : {first.from, first.to}) {
      if (lies_on(second, end)) take(first, second, end);
    }
    for (const Vec2 end : {second.from, second.to}) {
      if (lies_on(first, end)) take(first, second, end);
    }
  }

  void take(const Piece& a, const Piece& b, Vec2 point) {
    const Edge first = edge(a);
    const Edge second = edge(b);
    if (left_ == 0 || leads_on(a, b, point)) return;
    --left_;
    const Meeting here{names_[a.source], names_[b.source], point, crosses_at(first, second, point)};
    if (!best_ || rank(here) < rank(*best_)) best_ = here;
  }

  [[nodiscard]] bool crosses_at(const Edge& a, const Edge& b, Vec2 point) const {
    for (const Vec2 end : {a.from, a.to, b.from, b.to}) {
      if (are_near(end, point, tolerance_)) return false;
    }
    return std::fabs(cross(way_at(a, point), way_at(b, point))) > kSameWay;
  }

  // Whether the point is where one of the edges ends and the other one begins.
  [[nodiscard]] bool leads_on(const Piece& a, const Piece& b, Vec2 point) const {
    return leads_to(a, b, point) || leads_to(b, a, point);
  }
  [[nodiscard]] bool leads_to(const Piece& a, const Piece& b, Vec2 point) const {
    const EdgeName from = names_[a.source];
    const EdgeName to = names_[b.source];
    return from.contour == to.contour &&
           (from.edge + 1) % edge_count(contours_[from.contour]) == to.edge &&
           are_near(edge(a).to, point, tolerance_);
  }

  [[nodiscard]] Edge edge(const Piece& piece) const {
    const EdgeName name = names_[piece.source];
    return edge_of(contours_[name.contour], name.edge);
  }

  static std::tuple<bool, EdgeName, EdgeName, double, double> rank(const Meeting& meeting) {
    return {!meeting.is_crossing, meeting.first, meeting.second, meeting.point.u, meeting.point.v};
  }

  std::span<const Contour> contours_;
  double tolerance_ = 0;
  std::vector<EdgeName> names_;  // by source of a piece
  std::vector<Piece> pieces_;
  std::size_t left_ = 0;
  std::optional<Meeting> best_;
};

}  // namespace

std::optional<Meeting> meeting_of(std::span<const Contour> contours, double tolerance) {
  return MeetingSearch(contours, tolerance).best();
}

bool bound_one_area(const Contour& outer, std::span<const Contour> holes) {
  double area_mm2 = std::fabs(area(outer));
  double length_mm = length(outer);
  for (const Contour& hole : holes) {
    area_mm2 -= std::fabs(area(hole));
    length_mm += length(hole);
  }
  const Region inside =
      subtract(region_of(outer), region_of(std::vector<Contour>(holes.begin(), holes.end())));
  return std::fabs(area(inside) - area_mm2) <= kSameArea_mm2 &&
         std::fabs(length(inside) - length_mm) <= kSameLength_mm;
}

}  // namespace kerf::contour
