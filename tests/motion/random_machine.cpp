#include "random_machine.hpp"

#include <cmath>
#include <numbers>

#include "geometry/angle.hpp"
#include "kinematics_machines.hpp"

namespace kerf::test {
namespace {

double any_length(SeededRandom& random, double most) {
  return random.size(most / 20, most) * (random.coin() ? 1 : -1);
}

// Distance of the tip from the shoulder when the elbow stands at an angle.
double radius_mm(const kinematics::ArmLinks& links, double elbow_deg) {
  const double angle = geometry::radians(elbow_deg);
  return std::hypot(links.upper_arm_mm + links.forearm_mm * std::cos(angle),
                    links.forearm_mm * std::sin(angle));
}

Settings random_settings(kinematics::Kind kind, SeededRandom& random) {
  switch (kind) {
    case Kind::cartesian: break;
    case Kind::x_theta_z: {
      Settings settings = x_theta_z_settings();
      settings.x_theta_z = {any_length(random, 50), random.in(-180, 180), any_length(random, 10)};
      return settings;
    }
    case Kind::head_ac: {
      Settings settings = head_settings();
      settings.head = {any_length(random, 200), any_length(random, 100)};
      return settings;
    }
    case Kind::arm: {
      Settings settings = arm_settings();
      const double upper_mm = random.in(50, 300);
      settings.arm = {upper_mm, random.coin() ? upper_mm : random.in(50, 300), random.coin()};
      return settings;
    }
  }
  return cartesian_settings();
}

}  // namespace

bool RandomMachine::allows(const base::TipPoint& tip) const {
  if (most_radius_mm == 0) return true;
  const double radius = std::hypot(tip.values[0], tip.values[1]);
  return radius > least_radius_mm && radius < most_radius_mm;
}

RandomMachine random_machine(kinematics::Kind kind, SeededRandom& random) {
  const Settings settings = random_settings(kind, random);
  RandomMachine machine;
  machine.kinematics = make(settings);
  if (kind == Kind::x_theta_z) {
    machine.least_radius_mm = random.size(0.5, 20);
    machine.most_radius_mm = 400;
  } else if (kind == Kind::arm) {
    machine.least_radius_mm = radius_mm(settings.arm, 180 - random.size(3, 30));
    machine.most_radius_mm = radius_mm(settings.arm, random.size(3, 30));
  }
  const double most = machine.most_radius_mm == 0 ? 100 : machine.most_radius_mm;
  const double radius = random.in(machine.least_radius_mm, most);
  const double bearing = random.in(-std::numbers::pi, std::numbers::pi);
  machine.start = {{radius * std::cos(bearing), radius * std::sin(bearing), random.in(-50, 50)}};
  if (kind != Kind::x_theta_z) machine.start.values[3] = random.in(-90, 90);
  if (kind == Kind::head_ac) machine.start.values[4] = random.in(-180, 180);
  machine.joints = *machine.kinematics->inverse(machine.start, {});
  return machine;
}

}  // namespace kerf::test
