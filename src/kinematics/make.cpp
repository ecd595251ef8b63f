#include "kinematics/make.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "kinematics/internal/arm.hpp"
#include "kinematics/internal/cartesian.hpp"
#include "kinematics/internal/head.hpp"
#include "kinematics/internal/x_theta_z.hpp"

namespace kerf::kinematics {
namespace {

/// The joints of a kind: L linear, R rotary. Empty: any.
std::string_view joints_of(Kind kind) {
  switch (kind) {
    case Kind::cartesian: return "";
    case Kind::x_theta_z: return "LRL";
    case Kind::head_ac: return "LLLRR";
    case Kind::arm: return "RRRL";
  }
  return "";
}

std::string in_words(std::string_view joints) {
  std::string words;
  for (const char joint : joints) {
    if (!words.empty()) words += ", ";
    words += joint == 'R' ? "rotary" : "linear";
  }
  return words;
}

std::string joints_objection(const Settings& settings) {
  const std::string_view expected = joints_of(settings.kind);
  std::string found;
  for (const Joint& joint : settings.joints) found += joint.rotary ? 'R' : 'L';
  if (found.empty() || found.size() > base::kMaxAxes) {
    return "a machine has 1 to " + std::to_string(base::kMaxAxes) + " axes, not " +
           std::to_string(found.size());
  }
  if (expected.empty() || found == expected) return {};
  return "this kinematics has the axes " + in_words(expected) + ", not " + in_words(found);
}

std::string range_objection(const Settings& settings) {
  for (const Joint& joint : settings.joints) {
    if (!(joint.low <= joint.high)) return "the range of " + joint.name + " is empty";
  }
  return {};
}

template <std::size_t N>
bool all_finite(const std::array<double, N>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

std::string length_objection(const Settings& settings) {
  const XThetaZOffsets& offsets = settings.x_theta_z;
  const ArmLinks& arm = settings.arm;
  const std::array lengths{offsets.x1_mm,        offsets.theta0_deg,   offsets.z0_mm,
                           settings.head.r_a_mm, settings.head.r_c_mm, arm.upper_arm_mm,
                           arm.forearm_mm};
  if (!all_finite(lengths)) return "a length or angle of the kinematics is not a finite number";
  if (arm.upper_arm_mm > 0 && arm.forearm_mm > 0) return {};
  return "the upper arm and the forearm need lengths above 0";
}

std::string objection(const Settings& settings) {
  if (std::string text = joints_objection(settings); !text.empty()) return text;
  if (std::string text = range_objection(settings); !text.empty()) return text;
  return length_objection(settings);
}

}  // namespace

std::optional<Kind> kind_named(std::string_view word) {
  if (word == "cartesian" || word == "cartesian-step") return Kind::cartesian;
  if (word == "x-theta-z") return Kind::x_theta_z;
  if (word == "head-ac") return Kind::head_ac;
  if (word == "arm") return Kind::arm;
  return {};
}

base::Outcome<std::unique_ptr<const Kinematics>> make_kinematics(const Settings& settings) {
  if (std::string text = objection(settings); !text.empty()) {
    return base::unexpected(base::Failure{base::Failure::Kind::input, std::move(text)});
  }
  switch (settings.kind) {
    case Kind::cartesian: return std::make_unique<const Cartesian>(settings.joints);
    case Kind::x_theta_z:
      return std::make_unique<const XThetaZ>(settings.joints, settings.x_theta_z);
    case Kind::head_ac: return std::make_unique<const Head>(settings.joints, settings.head);
    case Kind::arm: return std::make_unique<const Arm>(settings.joints, settings.arm);
  }
  return base::unexpected(base::Failure{base::Failure::Kind::input, "unknown kinematics"});
}

}  // namespace kerf::kinematics
