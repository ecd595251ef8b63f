#include "stock/field/field_jobs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/math.hpp"

namespace kerf::stock::field {
namespace {

const double kQuarter = std::sqrt(2.0) - 1;

Body body_of(std::vector<ProfileEdge> edges) { return {.profile = Profile(std::move(edges))}; }

}  // namespace

Body flat(double diameter, double flutes) {
  const double r = diameter / 2;
  return body_of({{{0, 0}, {r, 0}}, {{r, 0}, {r, flutes}}});
}

Body ball(double diameter, double flutes) {
  const double r = diameter / 2;
  return body_of({{{0, 0}, {r, r}, kQuarter}, {{r, r}, {r, flutes}}});
}

Body bull(double diameter, double corner, double flutes) {
  const double r = diameter / 2;
  return body_of({{{0, 0}, {r - corner, 0}},
                  {{r - corner, 0}, {r, corner}, kQuarter},
                  {{r, corner}, {r, flutes}}});
}

Body cone(double diameter, double angle_deg, double tip_diameter, double flutes) {
  const double r = diameter / 2;
  const double tip = tip_diameter / 2;
  const double height = (r - tip) / math::tan(angle_deg / 360 * std::numbers::pi);
  return body_of({{{0, 0}, {tip, 0}}, {{tip, 0}, {r, height}}, {{r, height}, {r, flutes}}});
}

Body with(Body body, ToolPart part, double diameter, double height) {
  std::vector<ProfileEdge> edges(body.profile.edges().begin(), body.profile.edges().end());
  const ProfilePoint end = edges.back().to;
  const double r = diameter / 2;
  if (r != end.r) edges.push_back({end, {r, end.z}, 0, part});
  edges.push_back({{r, end.z}, {r, end.z + height}, 0, part});
  body.profile = Profile(std::move(edges));
  return body;
}

ArcWay around(Vec3 centre, Vec3 from, double turn_rad, double rise, double radius_change) {
  ArcWay way{centre, {0, 0, rise}, {1, 0, 0}, {0, 1, 0}};
  way.centre.z = from.z;
  way.radius = math::hypot(from.x - centre.x, from.y - centre.y);
  way.radius_change = radius_change;
  way.angle_rad = math::atan2(from.y - centre.y, from.x - centre.x);
  way.turn_rad = turn_rad;
  return way;
}

Job::Job(const Bounds& box, double cell_mm, const Body& body, unsigned jobs)
    : field_(grid_of(box, cell_mm), jobs), body_(field_.add_body(body)) {}

Job& Job::at(Vec3 place) {
  place_ = place;
  return *this;
}

Job& Job::to(Vec3 place) { return make(StraightWay{place_, place}, SweepKind::cut); }
Job& Job::rapid(Vec3 place) { return make(StraightWay{place_, place}, SweepKind::rapid); }

Job& Job::turn(Vec3 centre, double turn_rad, double rise, double radius_change) {
  return make(around(centre, place_, turn_rad, rise, radius_change), SweepKind::cut);
}

Job& Job::with_tool(const Body& body) {
  body_ = field_.add_body(body);
  return *this;
}

Job& Job::make(const Way& way, SweepKind kind) {
  Sweep sweep{.way = way, .body = body_, .kind = kind};
  sweep.motion = static_cast<std::uint32_t>(sweeps_.size() + 1);
  sweeps_.push_back(sweep);
  outcomes_.emplace_back();
  field_.cut({&sweeps_.back(), 1}, {&outcomes_.back(), 1});
  place_ = point_at(way, 1);
  return *this;
}

double Job::removed() const {
  Exact sum;
  for (const Outcome& outcome : outcomes_) sum += outcome.removed;
  return sum.value();
}

bool Job::met_nothing() const {
  return std::all_of(outcomes_.begin(), outcomes_.end(), [](const Outcome& outcome) {
    return std::none_of(outcome.contacts.begin(), outcome.contacts.end(),
                        [](const Contact& contact) { return contact.is_one(); });
  });
}

}  // namespace kerf::stock::field
