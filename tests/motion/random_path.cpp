#include "random_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include "motion/move_curves.hpp"

namespace kerf::test {
namespace {

using base::AxisVector;
using base::TipPoint;
using geometry::Vec3;
using motion::Motion;

// Of a piece at its feed: most paths are short, so that there can be many.
constexpr double kMostPeriods = 200;

class Writer {
 public:
  Writer(RandomPath& path, SeededRandom& random)
      : path_(path), random_(random), at_(path.axes.start) {}

  void write() {
    const int pieces = random_.count(1, 6);
    for (int i = 0; i < pieces; ++i) piece();
  }

 private:
  void piece() {
    feed_ = random_.size(100, 30000);
    const double most = kMostPeriods * path_.settings.period_s * feed_ / 60;  // mm
    switch (random_.count(0, 11)) {
      case 0: rapid(); break;
      case 1: add(motion::Dwell{random_.in(0.001, 0.02)}); break;
      case 2: lines(random_.count(1, 4), random_.size(0.001, 1) * most); break;
      case 3: lines(random_.count(2, 30), random_.size(0.0001, 0.1) * most); break;
      case 4: arc(random_.size(0.001, 0.3) * most); break;
      case 5: tangent_arcs(random_.count(2, 20), std::min(0.1, most / 20)); break;
      case 6: curve(random_.count(20, 200), most); break;
      case 7: five_axis(random_.count(1, 4), most); break;
      case 8: turn(); break;
      case 9: back_and_forth(random_.count(1, 4), most); break;
      case 10: tangent_arcs(random_.count(1, 3), random_.size(0.01, 0.3) * most); break;
      case 11: space_arc(random_.size(0.01, 0.3) * most); break;
    }
  }

  // False: it leaves the workspace.
  bool add(const Motion::Action& action) {
    Motion motion;
    motion.block.line = static_cast<std::uint32_t>(path_.motions.size() + 1);
    motion.action = action;
    if (!stays_in_workspace(motion)) return false;
    path_.motions.push_back(motion);
    if (const TipPoint* const to = motion::target_of(motion)) at_ = *to;
    return true;
  }
  [[nodiscard]] bool stays_in_workspace(const Motion& motion) const {
    if (!path_.machine) return true;
    constexpr int kPlaces = 100;
    motion::MoveCurves way(path_.axes);
    const auto curves = way.of(at_, motion);
    return std::all_of(curves.begin(), curves.end(), [&](const motion::Curve& curve) {
      for (int i = 0; i <= kPlaces; ++i) {
        if (!path_.machine->allows(curve.at(curve.length() * i / kPlaces))) return false;
      }
      return true;
    });
  }
  [[nodiscard]] motion::Feed feed() const { return {feed_, motion::FeedMode::per_minute}; }
  void line_to(const TipPoint& to) {
    if (to != at_) add(motion::Line{to, feed()});
  }
  TipPoint near(double distance) {
    TipPoint to = at_;
    for (std::size_t m = 0; m < 3; ++m) {
      if (random_.count(0, 3) > 0) to.values[m] += random_.in(-distance, distance);
    }
    return to;
  }

  void rapid() {
    const TipPoint to = near(random_.size(0.01, 50));
    if (to != at_) add(motion::Rapid{to, random_.coin()});
  }
  void lines(int count, double size) {
    for (int i = 0; i < count; ++i) line_to(near(size));
  }
  void back_and_forth(int count, double most) {
    const TipPoint there = near(random_.size(0.001, 0.5) * most);
    const TipPoint here = at_;
    for (int i = 0; i < count; ++i) {
      line_to(there);
      line_to(here);
    }
  }
  void turn() {
    TipPoint to = at_;
    for (std::size_t m = 3; m < path_.axes.count(); ++m) to.values[m] += random_.in(-90, 90);
    line_to(to);
  }
  void five_axis(int count, double most) {
    for (int i = 0; i < count; ++i) {
      TipPoint to = near(random_.size(0.01, 1) * most);
      for (std::size_t m = 3; m < path_.axes.count(); ++m)
        to.values[m] += random_.size(0.001, 60) * (random_.coin() ? 1 : -1);
      line_to(to);
    }
  }

  void arc(double radius) {
    const double begin = random_.in(0, 2 * std::numbers::pi);
    const double sweep = random_.size(0.001, 6.2);
    const bool clockwise = random_.coin();
    motion::Arc arc;
    arc.plane = static_cast<motion::Plane>(random_.count(0, 2));
    arc.direction = clockwise ? motion::Direction::clockwise : motion::Direction::counterclockwise;
    arc.feed = feed();
    arc.turns = static_cast<std::uint16_t>(random_.count(0, 9) == 0 ? 1 : 0);
    const std::size_t first = static_cast<std::size_t>(arc.plane) == 0   ? 0
                              : static_cast<std::size_t>(arc.plane) == 1 ? 2
                                                                         : 1;
    const std::size_t second = (first + 1) % 3;
    const double end = begin + (clockwise ? -sweep : sweep);
    arc.center = {at_.values[first] - radius * std::cos(begin),
                  at_.values[second] - radius * std::sin(begin)};
    arc.to = at_;
    arc.to.values[first] = arc.center[0] + radius * std::cos(end);
    arc.to.values[second] = arc.center[1] + radius * std::sin(end);
    if (random_.coin()) arc.to.values[(first + 2) % 3] += random_.in(-5, 5);
    add(arc);
  }

  // In any plane; the rotary axes turn at another rate behind the point on the way.
  void space_arc(double radius) {
    const Vec3 e1 = any_direction();
    const Vec3 e2 = geometry::unit(geometry::cross(e1, any_direction()));
    const Vec3 centre = Vec3{at_.values[0], at_.values[1], at_.values[2]} - radius * e1;
    const double sweep = random_.in(0.1, 6.1);
    const auto point = [&](double angle) {
      const Vec3 at = centre + radius * (std::cos(angle) * e1 + std::sin(angle) * e2);
      TipPoint to = at_;
      to.values[0] = at.x;
      to.values[1] = at.y;
      to.values[2] = at.z;
      for (std::size_t m = 3; m < path_.axes.count(); ++m) to.values[m] += random_.in(-20, 20);
      return to;
    };
    motion::SpaceArc arc;
    arc.via = point(random_.in(0.2, 0.8) * sweep);
    arc.to = point(sweep);
    arc.feed = feed();
    add(arc);
  }
  Vec3 any_direction() {
    for (;;) {
      const Vec3 v{random_.in(-1, 1), random_.in(-1, 1), random_.in(-1, 1)};
      if (geometry::length(v) > 0.1) return geometry::unit(v);
    }
  }

  // Arcs of the XY plane that go on from each other without a corner.
  void tangent_arcs(int count, double length) {
    double heading = random_.in(0, 2 * std::numbers::pi);
    for (int i = 0; i < count; ++i) {
      const double radius = random_.size(length / 3, 100 * length);
      const bool clockwise = random_.coin();
      const double side = clockwise ? -1 : 1;
      const double turned = side * length / radius;
      motion::Arc arc;
      arc.direction =
          clockwise ? motion::Direction::clockwise : motion::Direction::counterclockwise;
      arc.feed = feed();
      arc.center = {at_.values[0] - side * radius * std::sin(heading),
                    at_.values[1] + side * radius * std::cos(heading)};
      heading += turned;
      arc.to = at_;
      arc.to.values[0] = arc.center[0] + side * radius * std::sin(heading);
      arc.to.values[1] = arc.center[1] - side * radius * std::cos(heading);
      if (!add(arc)) return;
    }
  }

  // A wavy curve as a CAM system writes it: points with a rounded last digit.
  void curve(int points, double most) {
    const TipPoint from = at_;
    const double step = random_.size(0.01, 2) * most / points;
    const double wave = random_.size(20, 1000) * step;
    const double height = random_.in(0, 0.2) * wave;
    const double digit = std::pow(10.0, random_.count(2, 5));
    const double heading = random_.in(0, 2 * std::numbers::pi);
    for (int i = 1; i <= points; ++i) {
      const double x = i * step;
      const double y = height * std::sin(x / wave);
      TipPoint to = from;
      to.values[0] += x * std::cos(heading) - y * std::sin(heading);
      to.values[1] += x * std::sin(heading) + y * std::cos(heading);
      to.values[2] += y / 2;
      for (std::size_t m = 0; m < 3; ++m) to.values[m] = std::round(to.values[m] * digit) / digit;
      line_to(to);
    }
  }

  RandomPath& path_;
  SeededRandom& random_;
  TipPoint at_;
  double feed_ = 1000;
};

std::string_view letters_of(kinematics::Kind kind, SeededRandom& random) {
  switch (kind) {
    case kinematics::Kind::cartesian: return random.coin() ? "XYZ" : "XYZAC";
    case kinematics::Kind::x_theta_z: return "XYZ";
    case kinematics::Kind::head_ac: return "XYZAC";
    case kinematics::Kind::arm: return "XYZC";
  }
  return "";
}

}  // namespace

RandomPath random_path(unsigned seed, kinematics::Kind kind) {
  SeededRandom random(seed);
  RandomPath path;
  const std::string_view letters = letters_of(kind, random);
  for (const char letter : letters) {
    const bool rotary = letter == 'A' || letter == 'C';
    path.axes.axes.push_back({.letter = letter, .rotary = rotary, .rapid_per_min = 10000});
  }
  const bool jerk_limited = random.coin();
  for (std::size_t m = 0; m < letters.size(); ++m) {
    path.limits.velocity.values[m] = random.size(50, 1000);
    path.limits.acceleration.values[m] = random.size(200, 20000);
    path.limits.jerk.values[m] =
        jerk_limited ? random.size(1e4, 1e7) : std::numeric_limits<double>::infinity();
  }
  if (kind != kinematics::Kind::cartesian) {
    path.machine = random_machine(kind, random);
    path.axes.start = path.machine->start;
  }
  path.settings.period_s = random.count(0, 3) == 0 ? 0.008 : 0.001;
  path.settings.tolerance_mm = random.count(0, 3) == 0 ? 0 : random.size(0.0005, 0.2);
  path.settings.chord_tolerance_mm = random.size(0.0005, 0.01);
  Writer(path, random).write();
  return path;
}

}  // namespace kerf::test
