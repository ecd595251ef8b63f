#include "stock/dexel/solid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/math.hpp"

namespace kerf::stock::dexel {
namespace {

constexpr double kLevel_mm = 1e-9;  // an edge that rises less is a face
constexpr double kMostCones = 4096;

Solid between(Solid solid, double low, double high) {
  solid.low = low;
  solid.high = high;
  return solid;
}

/// The same side, moved outwards by `by`.
Solid with_side(const Solid& solid, double by) {
  Solid moved = solid.is_ball
                    ? Solid::ball(std::max(0.0, solid.first + by), solid.second, 0, 0)
                    : Solid::cone(solid.first + by * std::sqrt(1 + solid.second * solid.second),
                                  solid.second, 0, 0);
  moved.part = solid.part;
  moved.ends_low = solid.ends_low;
  moved.ends_high = solid.ends_high;
  return moved;
}

/// Planes moved to where the side still has a radius.
std::optional<Solid> where_it_is(Solid solid) {
  if (solid.is_ball) {
    solid.low = std::max(solid.low, solid.second - solid.first);
    solid.high = std::min(solid.high, solid.second + solid.first);
  } else if (solid.second > 0) {
    solid.low = std::max(solid.low, -solid.first / solid.second);
  } else if (solid.second < 0) {
    solid.high = std::min(solid.high, -solid.first / solid.second);
  } else if (solid.first <= 0) {
    return std::nullopt;
  }
  if (solid.low >= solid.high) return std::nullopt;
  return solid;
}

std::optional<Solid> made_smaller(const Solid& solid, double by, bool low, bool high) {
  if (solid.is_ball && solid.first <= by) return std::nullopt;
  return where_it_is(
      between(with_side(solid, -by), solid.low + (low ? by : 0), solid.high - (high ? by : 0)));
}

/// The circle of an edge that is an arc.
struct Circle {
  double r;
  double z;
  double radius;
};
Circle circle_of(const ProfileEdge& edge) {
  const double dr = edge.to.r - edge.from.r;
  const double dz = edge.to.z - edge.from.z;
  const double reach = (1 - edge.bulge * edge.bulge) / (4 * edge.bulge);
  const Circle circle{(edge.from.r + edge.to.r) / 2 - dz * reach,
                      (edge.from.z + edge.to.z) / 2 + dr * reach, 0};
  return {circle.r, circle.z, math::hypot(edge.from.r - circle.r, edge.from.z - circle.z)};
}

Solid cone_between(ProfilePoint a, ProfilePoint b) {
  const double k = (b.r - a.r) / (b.z - a.z);
  return Solid::cone(a.r - k * a.z, k, a.z, b.z);
}

/// The stack as it grows.
class Stack {
 public:
  explicit Stack(double tolerance_mm) : tolerance_(tolerance_mm) {}

  void add(const ProfileEdge& edge) {
    if (edge.to.z - edge.from.z < kLevel_mm) {
      end_here();
      return;
    }
    if (!solids_.empty() && solids_.back().part != edge.part) end_here();
    part_ = edge.part;
    edge.bulge == 0 ? add_cone(edge.from, edge.to) : add_arc(edge);
  }
  std::vector<Solid> take() {
    end_here();
    complete_balls();
    return std::move(solids_);
  }

 private:
  void end_here() {
    ends_ = true;
    if (!solids_.empty()) solids_.back().ends_high = true;
  }
  void push(Solid solid) {
    solid.part = part_;
    solid.ends_low = std::exchange(ends_, false);
    solid.ends_high = false;
    solids_.push_back(solid);
  }
  void add_cone(ProfilePoint a, ProfilePoint b) {
    if (b.z - a.z >= kLevel_mm && std::max(a.r, b.r) > 0) push(cone_between(a, b));
  }
  void add_arc(const ProfileEdge& edge) {
    const Circle circle = circle_of(edge);
    if (edge.bulge > 0 && std::fabs(circle.r) < kLevel_mm) {
      push(Solid::ball(circle.radius, circle.z, edge.from.z, edge.to.z));
    } else {
      add_cones(edge, circle);
    }
  }
  /// Corners alternate with chords about the arc: those inside of it stand off by the tolerance.
  void add_cones(const ProfileEdge& edge, const Circle& circle) {
    const double turn = 4 * math::atan(edge.bulge);
    const double step = 4 * std::sqrt(tolerance_ / circle.radius);
    const double count = std::clamp(std::ceil(std::fabs(turn) / step), 1.0, kMostCones);
    const double from = math::atan2(edge.from.z - circle.z, edge.from.r - circle.r);
    ProfilePoint last = edge.from;
    for (double i = 1; i <= count; ++i) {
      const auto [sine, cosine] = math::sine_cosine(from + turn * i / count);
      const double radius = circle.radius + std::copysign(tolerance_, edge.bulge);
      const ProfilePoint next = i == count ? edge.to
                                           : ProfilePoint{std::max(0.0, circle.r + radius * cosine),
                                                          circle.z + radius * sine};
      if (next.z - last.z < kLevel_mm || next.z > edge.to.z) continue;
      add_cone(last, next);
      last = next;
    }
  }
  /// A ball that goes on as a cylinder of its own radius may be whole: its planes cost time.
  void complete_balls() {
    for (std::size_t i = 0; i + 1 < solids_.size(); ++i) {
      Solid& ball = solids_[i];
      const Solid& above = solids_[i + 1];
      const bool goes_on = !ball.ends_high && !above.is_ball && above.second == 0 &&
                           std::fabs(above.first - ball.first) < kLevel_mm &&
                           above.high - above.low >= ball.first;
      if (ball.is_ball && goes_on) ball.high = ball.second + ball.first;
    }
  }

  double tolerance_;
  std::vector<Solid> solids_;
  ToolPart part_ = ToolPart::edge;
  bool ends_ = true;
};

}  // namespace

Solid Solid::cone(double a, double k, double low, double high) {
  Solid solid;
  solid.square = a * a;
  solid.slope = a * k;
  solid.bend = k * k;
  solid.low = low;
  solid.high = high;
  solid.first = a;
  solid.second = k;
  return solid;
}

Solid Solid::ball(double radius, double centre, double low, double high) {
  Solid solid;
  solid.square = radius * radius - centre * centre;
  solid.slope = centre;
  solid.bend = -1;
  solid.low = low;
  solid.high = high;
  solid.first = radius;
  solid.second = centre;
  solid.is_ball = true;
  return solid;
}

double Solid::radius_at(double z) const {
  if (!is_ball) return std::max(0.0, first + second * z);
  return std::sqrt(std::max(0.0, first * first - (z - second) * (z - second)));
}

double Solid::widest() const {
  if (is_ball && low <= second && second <= high) return first;
  return std::max(radius_at(low), radius_at(high));
}

bool Solid::is_whole_ball() const {
  return is_ball && low <= second - first + kLevel_mm && high >= second + first - kLevel_mm;
}

double Solid::middle() const { return is_ball ? second : (low + high) / 2; }

double Solid::lever() const {
  if (is_whole_ball()) return 0;
  if (is_ball) return first;
  return math::hypot(std::max(radius_at(low), radius_at(high)), (high - low) / 2);
}

Solid grown(const Solid& solid, double by) {
  return between(with_side(solid, by), solid.low - by, solid.high + by);
}

std::optional<Solid> shrunk(const Solid& solid, double by) {
  return made_smaller(solid, by, true, true);
}

std::optional<Solid> shrunk_at_faces(const Solid& solid, double by) {
  return made_smaller(solid, by, solid.ends_low, solid.ends_high);
}

std::vector<Solid> solids_of(const Profile& profile, double tolerance_mm) {
  Stack stack(tolerance_mm);
  for (const ProfileEdge& edge : profile.edges()) stack.add(edge);
  return stack.take();
}

}  // namespace kerf::stock::dexel
