#pragma once

#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "kinematics/make.hpp"

namespace kerf::test {

using kinematics::Joint;
using kinematics::Kind;
using kinematics::Kinematics;
using kinematics::Settings;

inline Joint linear(const std::string& name) { return {name, false}; }
inline Joint rotary(const std::string& name) { return {name, true}; }

inline std::unique_ptr<const Kinematics> make(const Settings& settings) {
  return std::move(*kinematics::make_kinematics(settings));
}

/// Links of 132 mm, joints without limits.
inline Settings arm_settings() {
  Settings settings;
  settings.kind = Kind::arm;
  settings.joints = {rotary("T1"), rotary("T2"), rotary("T3"), linear("Z")};
  return settings;
}

/// r_a 150 mm, r_c 80 mm, joints without limits.
inline Settings head_settings() {
  Settings settings;
  settings.kind = Kind::head_ac;
  settings.joints = {linear("X"), linear("Y"), linear("Z"), rotary("A"), rotary("C")};
  return settings;
}

/// X1 25 mm, θ0 10 degrees, Z0 5 mm, joints without limits.
inline Settings x_theta_z_settings() {
  Settings settings;
  settings.kind = Kind::x_theta_z;
  settings.joints = {linear("X"), rotary("T"), linear("Z")};
  settings.x_theta_z = {25, 10, 5};
  return settings;
}

inline Settings cartesian_settings() {
  Settings settings;
  settings.joints = {linear("X"), linear("Y"), linear("Z"), rotary("A")};
  return settings;
}

inline std::string text(const base::AxisVector& v) {
  std::ostringstream out;
  out.precision(17);
  for (const double value : v.values) out << value << ' ';
  return out.str();
}

}  // namespace kerf::test
