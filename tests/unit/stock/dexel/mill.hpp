#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "stock/dexel/tri_dexel.hpp"

namespace kerf::stock::dexel::test {

using std::numbers::pi;

inline const double kQuarter = std::tan(pi / 8);
inline constexpr double kTall = 200;

/// An outline made piece by piece, upwards.
class Outline {
 public:
  Outline& to(double r, double z, double bulge = 0) {
    const ProfilePoint next{r, z};
    edges_.push_back({at_, next, bulge, part_});
    at_ = next;
    return *this;
  }
  Outline& as(ToolPart part) {
    part_ = part;
    return *this;
  }
  [[nodiscard]] Body body() const { return {Profile(edges_)}; }

 private:
  std::vector<ProfileEdge> edges_;
  ProfilePoint at_;
  ToolPart part_ = ToolPart::edge;
};

inline Body flat(double d, double high = kTall) {
  return Outline().to(d / 2, 0).to(d / 2, high).body();
}
inline Body ball(double d, double high = kTall) {
  return Outline().to(d / 2, d / 2, kQuarter).to(d / 2, high).body();
}
inline Body bull(double d, double c) {
  return Outline().to(d / 2 - c, 0).to(d / 2, c, kQuarter).to(d / 2, kTall).body();
}
/// `angle`: from the axis to the flank, degrees.
inline Body pointed(double d, double angle, double tip = 0) {
  const double high = (d - tip) / 2 / std::tan(angle * pi / 180);
  return Outline().to(tip / 2, 0).to(d / 2, high).to(d / 2, kTall).body();
}
inline Body t_slot(double d, double width, double neck) {
  return Outline()
      .to(d / 2, 0)
      .to(d / 2, width)
      .to(neck / 2, width)
      .as(ToolPart::shank)
      .to(neck / 2, kTall)
      .body();
}
inline Body lollipop(double d, double neck) {
  const double r = d / 2;
  const double joint = r + std::sqrt(r * r - neck * neck / 4);
  const double angle = std::atan2(joint - r, neck / 2);
  return Outline()
      .to(r, r, kQuarter)
      .to(neck / 2, joint, std::tan(angle / 4))
      .as(ToolPart::shank)
      .to(neck / 2, kTall)
      .body();
}

/// A stock on a mill: moves of one tool, with what they did.
class Mill {
 public:
  Mill(const Bounds& box, double cell, unsigned jobs = 1) : Mill(box_shape(box), cell, jobs) {}
  Mill(const Shape& shape, double cell, unsigned jobs = 1) : model(shape, cell, jobs) {}

  Mill& tool(const Body& body) {
    body_ = model.add_body(body);
    return *this;
  }
  Mill& axis(Vec3 up) {
    axis_ = up;
    return *this;
  }
  Mill& at(Vec3 tip) {
    tip_ = tip;
    return *this;
  }
  Mill& line(Vec3 to) { return sweep(StraightWay{tip_, to}, to, SweepKind::cut); }
  Mill& rapid(Vec3 to) { return sweep(StraightWay{tip_, to}, to, SweepKind::rapid); }
  /// About a vertical axis.
  Mill& arc(double centre_x, double centre_y, double turn, double rise = 0) {
    const double x = tip_.x - centre_x;
    const double y = tip_.y - centre_y;
    const ArcWay way{{centre_x, centre_y, tip_.z},
                     {0, 0, rise},
                     {1, 0, 0},
                     {0, 1, 0},
                     std::hypot(x, y),
                     0,
                     std::atan2(y, x),
                     turn};
    return sweep(way, point_at(way, 1), SweepKind::cut);
  }
  Mill& sweep(const Way& way, Vec3 to, SweepKind kind) {
    sweeps.push_back({way, axis_, body_, kind, static_cast<std::uint32_t>(sweeps.size() + 1)});
    tip_ = to;
    return *this;
  }
  Mill& turn(Vec3 to, Vec3 to_axis) {
    sweep(TurningWay{tip_, to, to_axis}, to, SweepKind::cut);
    axis_ = to_axis;
    return *this;
  }
  /// What was not cut yet.
  Mill& run() {
    const std::size_t done = outcomes.size();
    outcomes.resize(sweeps.size());
    model.cut(std::span<const Sweep>(sweeps).subspan(done), std::span(outcomes).subspan(done));
    return *this;
  }
  [[nodiscard]] double removed() {
    run();
    return model.stock_mm3() - model.left_mm3();
  }
  [[nodiscard]] const Outcome& last() const { return outcomes.back(); }
  [[nodiscard]] bool has_contacts() const {
    for (const Outcome& outcome : outcomes) {
      for (const Contact& contact : outcome.contacts) {
        if (contact.is_one()) return true;
      }
    }
    return false;
  }

  TriDexel model;
  std::vector<Sweep> sweeps;
  std::vector<Outcome> outcomes;

 private:
  BodyId body_ = 0;
  Vec3 axis_{0, 0, 1};
  Vec3 tip_;
};

}  // namespace kerf::stock::dexel::test
