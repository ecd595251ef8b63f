#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "stock/tool/insert.hpp"
#include "stock/tool/tool_maker.hpp"
#include "stock/turned/turned_part.hpp"

namespace kerf::stock::turned {

using M = Measure;

inline Body body_of(const Tool& tool) {
  Body body;
  if (tool.is_insert()) {
    body.insert = insert_of(tool);
  } else {
    body.profile = profile_of(tool);
  }
  return body;
}

/// A turning insert C of an inscribed circle of 40, so that one pass is enough.
inline Body turning(double nose_radius, int tip = 3, double ic = 40) {
  Tool tool = test::tool_of(
      "turning", {{M::nose_radius, nose_radius}, {M::ic, ic}, {M::kapr, 95}, {M::tip, tip}});
  tool.insert = "CNMG120408";
  return body_of(tool);
}
inline Body blade(double width, int tip = 3, double corner = 0) {
  return body_of(
      test::tool_of("grooving", {{M::width, width}, {M::tip, tip}, {M::corner_radius, corner}}));
}
inline Body drill(double diameter, double angle = 118) {
  return body_of(test::tool_of("drill", {{M::diameter, diameter}, {M::angle, angle}}));
}

/// Moves of tools over a bar as a program would write them: X diameters.
class Job {
 public:
  explicit Job(const contour::Region& region) : part_(region) {}
  Job(double diameter, double from, double to) : part_(bar(diameter, from, to)) {}

  Job& with(const Body& body) {
    body_ = part_.add_body(body);
    return *this;
  }
  Job& at(double x, double z) {
    place_ = {x / 2, 0, z};
    return *this;
  }
  Job& to(double x, double z) { return straight(x, z, SweepKind::cut); }
  Job& rapid(double x, double z) { return straight(x, z, SweepKind::rapid); }
  /// Round a centre (X a diameter), counterclockwise in the plane (Z, X) > 0.
  Job& turn(double centre_x, double centre_z, double turn_rad) {
    const Vec3 centre{centre_x / 2, 0, centre_z};
    const Vec3 arm = place_ - centre;
    const ArcWay way{
        centre,  {}, {0, 0, 1}, {1, 0, 0}, std::hypot(arm.x, arm.z), 0, std::atan2(arm.x, arm.z),
        turn_rad};
    place_ = point_at(way, 1);
    return make({.way = way});
  }
  Job& thread(double x, double z, double lead, double start_deg = 0) {
    const Vec3 from = place_;
    place_ = {x / 2, 0, z};
    return make({.way = StraightWay{from, place_}, .lead_mm = lead, .start_deg = start_deg});
  }
  Job& make(Sweep sweep) {
    sweep.body = body_;
    sweep.motion = static_cast<std::uint32_t>(sweeps_.size() + 1);
    sweeps_.push_back(sweep);
    outcomes_.emplace_back();
    part_.cut({&sweeps_.back(), 1}, {&outcomes_.back(), 1});
    return *this;
  }

  [[nodiscard]] TurnedPart& part() { return part_; }
  [[nodiscard]] const Outcome& last() const { return outcomes_.back(); }
  [[nodiscard]] const std::vector<Sweep>& sweeps() const { return sweeps_; }
  [[nodiscard]] Vec3 place() const { return place_; }
  [[nodiscard]] double removed() const { return sum().removed.value(); }
  [[nodiscard]] Outcome sum() const {
    Outcome all;
    for (const Outcome& one : outcomes_) all.add(one);
    return all;
  }
  [[nodiscard]] bool met_nothing() const {
    for (const Contact& contact : sum().contacts) {
      if (contact.is_one()) return false;
    }
    return true;
  }

 private:
  Job& straight(double x, double z, SweepKind kind) {
    const Vec3 from = place_;
    place_ = {x / 2, 0, z};
    return make({.way = StraightWay{from, place_}, .kind = kind});
  }

  TurnedPart part_;
  BodyId body_ = 0;
  Vec3 place_;
  std::vector<Sweep> sweeps_;
  std::vector<Outcome> outcomes_;
};

}  // namespace kerf::stock::turned
