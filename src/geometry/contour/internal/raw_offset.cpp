#include "geometry/contour/internal/raw_offset.hpp"

#include <cmath>

#include "geometry/contour/tolerance.hpp"

namespace kerf::contour {
namespace {

using geometry::left_of;

Vec2 right_of(Vec2 a) { return -left_of(a); }

// One edge of the chain beside its strip: the strip's far side from `begin` to `end`, between the
// far ends of the normals.
struct Strip {
  Edge edge;
  std::uint32_t corner_owner = 0;
  Vec2 tangent_from;
  Vec2 tangent_to;
  Vec2 normal_from;  // ends of the normals at the edge's ends
  Vec2 normal_to;
  Vec2 begin;
  Vec2 end;
  bool is_cut_from = false;  // along the bisector of the corner before
  bool is_cut_to = false;
  bool is_buried = false;  // both ends are one point well within the distance
};

Strip strip_of(const Link& link, double distance) {
  Strip strip;
  strip.edge = link.edge;
  strip.corner_owner = link.corner_owner;
  strip.tangent_from = geometry::unit(tangent_at_start(link.edge));
  strip.tangent_to = geometry::unit(tangent_at_end(link.edge));
  strip.normal_from = link.edge.from + distance * right_of(strip.tangent_from);
  strip.normal_to = link.edge.to + distance * right_of(strip.tangent_to);
  strip.begin = strip.normal_from;
  strip.end = strip.normal_to;
  const double bulge = link.edge.bulge;
  if (bulge != 0 && radius(link.edge) + std::copysign(distance, distance * bulge) <= kSame_mm) {
    strip.begin = strip.end = centre(link.edge);
  }
  return strip;
}

bool is_line(const Strip& strip) { return strip.edge.bulge == 0; }

// The nearest point of a grid at most as wide as `room`.
Vec2 on_grid(Vec2 point, double room) {
  const double width = std::ldexp(1.0, std::ilogb(room));
  return {width * std::nearbyint(point.u / width), width * std::nearbyint(point.v / width)};
}

// Cuts the strip of a line between two others. Where lines close to this side, what is beyond the
// bisector of the corner is nearer to the other line, and need not be in this strip; so neighbours
// meet in one point instead of crossing, and a line that is too short for its strip ends in the
// point where its bisectors meet. This holds as far as the other line reaches: what is beyond the
// bisector and nearer to the other line is convex (a half plane, then a parabola about its end), so
// it is enough that the corners of what is cut off are nearer.
class StripCutter {
 public:
  StripCutter(const Strip& before, Strip& strip, const Strip& after, double distance)
      : before_(before.edge),
        strip_(strip),
        after_(after.edge),
        distance_(distance),
        depth_(std::fabs(distance)),
        length_(geometry::length(strip.edge.to - strip.edge.from)),
        slope_from_(closing(before, strip)),
        slope_to_(closing(strip, after)) {}

  void cut() {
    if (depth_ * (slope_from_ + slope_to_) <= length_) {
      cut_sides();
    } else if (slope_from_ > 0 && slope_to_ > 0) {
      cut_to_point(length_ * slope_from_ / (slope_from_ + slope_to_), true, true);
    } else {
      cut_to_point(slope_from_ > 0 ? length_ : 0, slope_from_ > 0, slope_to_ > 0);
    }
  }

 private:
  // How far the bisector goes along the lines for each mm away from them; 0 if the corner does not
  // close to this side, or is none of lines.
  double closing(const Strip& first, const Strip& second) const {
    if (!is_line(first) || !is_line(second) || first.normal_to == second.normal_from) return 0;
    const double turn =
        -std::copysign(1.0, distance_) * cross(first.tangent_to, second.tangent_from);
    const double ahead = dot(first.tangent_to, second.tangent_from);
    return turn > 0 && ahead > -0.9 ? turn / (1 + ahead) : 0;
  }

  Vec2 at(double along, double away) const {
    return strip_.edge.from + along * strip_.tangent_from +
           std::copysign(away, distance_) * right_of(strip_.tangent_from);
  }

  void cut_sides() {
    const double from = depth_ * slope_from_;
    const double to = depth_ * slope_to_;
    if (from > 0 && from <= length(before_)) {
      strip_.begin = at(from, depth_);
      strip_.is_cut_from = true;
    }
    if (to > 0 && to <= length(after_)) {
      strip_.end = at(length_ - to, depth_);
      strip_.is_cut_to = true;
    }
  }

  void cut_to_point(double along, bool from, bool to) {
    const Vec2 above = at(along, depth_);
    if (from && (along > length(before_) || distance(before_, above) > depth_)) return;
    if (to && (length_ - along > length(after_) || distance(after_, above) > depth_)) return;
    const double away = from ? along / slope_from_ : (length_ - along) / slope_to_;
    const double room = std::min(away, depth_ - away) / 16;
    strip_.is_buried = room > kSame_mm;
    strip_.begin = strip_.end = strip_.is_buried ? on_grid(at(along, away), room) : at(along, away);
    strip_.is_cut_from = from;
    strip_.is_cut_to = to;
  }

  const Edge& before_;
  Strip& strip_;
  const Edge& after_;
  double distance_;
  double depth_;
  double length_;
  double slope_from_;
  double slope_to_;
};

class RawOffset {
 public:
  RawOffset(std::vector<Strand>& strands, double distance)
      : strands_(strands), distance_(distance) {}

  void run(std::span<const Link> chain) {
    for (const Link& link : chain) strips_.push_back(strip_of(link, distance_));
    for (std::size_t i = 0; i < strips_.size(); ++i) smooth(strips_[i], after(i));
    for (std::size_t i = 0; i < strips_.size(); ++i) {
      Strip& before = strips_[i == 0 ? strips_.size() - 1 : i - 1];
      if (is_line(strips_[i])) StripCutter(before, strips_[i], after(i), distance_).cut();
    }
    for (std::size_t i = 0; i < strips_.size(); ++i) {
      add_far_side(strips_[i]);
      add_corner(strips_[i], after(i));
    }
  }

 private:
  Strip& after(std::size_t i) { return strips_[i + 1 == strips_.size() ? 0 : i + 1]; }

  // Normals that end in one point end in the same one.
  static void smooth(const Strip& first, Strip& second) {
    if (geometry::length(first.normal_to - second.normal_from) > kSame_mm / 2) return;
    if (second.begin == second.normal_from) second.begin = first.normal_to;
    second.normal_from = first.normal_to;
  }

  void add(Vec2 from, Vec2 to, double bulge, std::uint32_t owner, bool is_buried = false) {
    if (from == to) return;
    strands_.push_back({{from, to, bulge, owner}, Operand::first, is_buried});
  }

  void add_far_side(const Strip& strip) {
    add(strip.begin, strip.end, strip.edge.bulge, strip.edge.owner);
  }

  void add_corner(const Strip& first, const Strip& second) {
    const std::uint32_t owner = first.corner_owner;
    if (first.is_cut_to && second.is_cut_from) {
      add(first.end, second.begin, 0, owner, first.is_buried && second.is_buried);
    } else if (first.normal_to == second.normal_from) {
      add(first.end, second.begin, 0, owner);
    } else if (const double bulge = opening(first, second); bulge != 0) {
      add(first.end, first.normal_to, 0, owner);
      add(first.normal_to, second.normal_from, bulge, owner);
      add(second.normal_from, second.begin, 0, owner);
    } else {
      add(first.end, first.edge.to, 0, owner);
      add(first.edge.to, second.begin, 0, owner);
    }
  }

  // The bulge of the sector between the strips, 0 where the corner closes to this side. A sector
  // does no harm where none is needed: so the tip of a spike, of which rounding leaves no more than
  // that it turns back, always has one.
  double opening(const Strip& first, const Strip& second) const {
    const double sign = std::copysign(1.0, distance_);
    const double turn = sign * cross(first.tangent_to, second.tangent_from);
    const double ahead = dot(first.tangent_to, second.tangent_from);
    if (turn <= 0 && ahead > -0.99) return 0;
    const double cotangent = ahead < 0 ? turn / (1 - ahead) : (1 + ahead) / turn;
    const double root = std::sqrt(1 + cotangent * cotangent);
    return sign * (cotangent > 0 ? 1 / (root + cotangent) : root - cotangent);
  }

  std::vector<Strand>& strands_;
  double distance_;
  std::vector<Strip> strips_;
};

}  // namespace

void add_raw_offset(std::vector<Strand>& strands, std::span<const Link> chain, double distance) {
  RawOffset(strands, distance).run(chain);
}

}  // namespace kerf::contour
