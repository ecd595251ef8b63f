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
};

Strip strip_of(const Link& link, double distance) {
  Strip strip{link.edge, link.corner_owner, {}, {}, {}, {}, {}, {}};
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

class RawOffset {
 public:
  RawOffset(std::vector<Strand>& strands, double distance)
      : strands_(strands), distance_(distance) {}

  void run(std::span<const Link> chain) {
    for (const Link& link : chain) strips_.push_back(strip_of(link, distance_));
    for (std::size_t i = 0; i < strips_.size(); ++i) smooth(strips_[i], after(i));
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

  void add(Vec2 from, Vec2 to, double bulge, std::uint32_t owner) {
    if (!(from == to)) strands_.push_back({{from, to, bulge, owner}, Operand::first});
  }

  void add_far_side(const Strip& strip) {
    add(strip.begin, strip.end, strip.edge.bulge, strip.edge.owner);
  }

  void add_corner(const Strip& first, const Strip& second) {
    const std::uint32_t owner = first.corner_owner;
    if (first.normal_to == second.normal_from) {
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

  // The bulge of the sector between the strips, 0 where the corner closes to this side.
  double opening(const Strip& first, const Strip& second) const {
    const double turn = cross(first.tangent_to, second.tangent_from);
    const double ahead = dot(first.tangent_to, second.tangent_from);
    if (ahead < 0 && std::fabs(turn) < 1e-9) return std::copysign(1.0, distance_);
    if (turn * distance_ <= 0) return 0;
    const double half = turn / (1 + ahead);
    return half / (1 + std::sqrt(1 + half * half));
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
