#include "stock/cutting/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "geometry/angle.hpp"
#include "math/math.hpp"

namespace kerf::stock {
namespace {

using base::Code;

constexpr std::array<std::string_view, kToolParts> kPartNames = {"cutting edges", "flutes' end",
                                                                 "shank", "holder"};
constexpr double kAcross_mm = 1e-6;
/// A hole of so much of the minor diameter is one to tap.
constexpr double kLeastHole = 0.95;
/// What rounding leaves of the steepness of a ramp.
constexpr double kSameAngle_deg = 1e-6;

/// All contacts as one, and the part of the deepest.
std::pair<Contact, std::size_t> deepest(const std::array<Contact, kToolParts>& contacts) {
  Contact all;
  std::size_t part = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (contacts[i].depth_mm > all.depth_mm) part = i;
    all.add(contacts[i]);
  }
  return {all, part};
}

/// How steeply a way goes down along the tool: from 0 to 90 degrees, of an arc on the whole.
double steepness_deg(const Sweep& sweep) {
  const Vec3 way = point_at(sweep.way, 1) - point_at(sweep.way, 0);
  const double down = -dot(way, sweep.axis);
  const double whole = length(sweep.way);
  if (!(down > 0) || !(whole > 0)) return 0;
  return geometry::degrees(math::asin(std::min(1.0, down / whole)));
}

}  // namespace

bool goes_across(const Sweep& sweep) {
  if (const auto* const straight = std::get_if<StraightWay>(&sweep.way)) {
    const Vec3 way = straight->to - straight->from;
    return geometry::length(geometry::cross(way, sweep.axis)) > kAcross_mm;
  }
  return true;
}

bool Judge::judge(const JudgedMotion& of, const CuttingTool& tool, const Outcome& sum) {
  has_found_ = false;
  judge_obstacles(of, tool);
  if (of.kind == SweepKind::rapid) {
    judge_rapid(of, tool, sum);
  } else {
    judge_cut(of, tool, sum);
  }
  return has_found_;
}

bool Judge::add(const Finding& finding) {
  const auto& out = settings_.left_out;
  if (std::find(out.begin(), out.end(), finding.code) != out.end()) return false;
  findings_.add(finding);
  return true;
}

void Judge::judge_obstacles(const JudgedMotion& of, const CuttingTool& tool) {
  for (Obstacle* const obstacle : settings_.obstacles) {
    const Obstacle::Contacts contacts = obstacle->meet(of.sweeps, tool.body);
    const auto [worst, part] = deepest(contacts);
    if (!worst.is_one() || !tool.knows_shape()) continue;
    find(Code::fixture_collision, of, tool, worst,
         fmt::format("the {} of T{} {:.3f} mm deep in {}", kPartNames[part], tool.number(),
                     worst.depth_mm, obstacle->name()));
  }
}

void Judge::judge_rapid(const JudgedMotion& of, const CuttingTool& tool, const Outcome& sum) {
  const auto [worst, part] = deepest(sum.contacts);
  if (!worst.is_one() || !knows_collisions(tool)) return;
  find(
      Code::rapid_in_stock, of, tool, worst,
      fmt::format("the {} of T{} {:.3f} mm deep", kPartNames[part], tool.number(), worst.depth_mm));
}

void Judge::judge_cut(const JudgedMotion& of, const CuttingTool& tool, const Outcome& sum) {
  judge_parts(of, tool, sum);
  if (tool.is_probe()) return;
  if (sum.removed.value() < kDust_mm3 && sum.threaded.value() < kDust_mm3) return;
  judge_spindle(of, tool);
  judge_core(of, tool, sum);
  if (tool.is_axial()) judge_sideways(of, tool);
  if (tool.tool.kind == ToolKind::tap) judge_tap(of, tool, sum);
}

void Judge::judge_parts(const JudgedMotion& of, const CuttingTool& tool, const Outcome& sum) {
  const auto told = [&](ToolPart part, Code code) {
    const Contact& contact = sum.contacts[index(part)];
    if (!contact.is_one() || !knows_collisions(tool)) return;
    find(code, of, tool, contact,
         fmt::format("T{} {:.3f} mm deep", tool.number(), contact.depth_mm));
  };
  if (tool.is_probe()) {
    told(ToolPart::edge, Code::probe_in_stock);
  } else if (tool.tool.is_insert()) {
    judge_back(of, tool, sum);
  } else {
    told(ToolPart::flank, Code::flute_length);
    told(ToolPart::shank, Code::shank_collision);
    told(ToolPart::holder, Code::holder_collision);
  }
}

// Of an insert nothing cuts but its edges, and the bar is behind them, too.
void Judge::judge_back(const JudgedMotion& of, const CuttingTool& tool, const Outcome& sum) {
  Contact contact;
  for (const ToolPart part : {ToolPart::flank, ToolPart::shank, ToolPart::holder})
    contact.add(sum.contacts[index(part)]);
  if (!contact.is_one() || !knows_collisions(tool)) return;
  find(Code::insert_collision, of, tool, contact,
       fmt::format("T{} {:.3f} mm deep", tool.number(), contact.depth_mm));
}

void Judge::judge_spindle(const JudgedMotion& of, const CuttingTool& tool) {
  const bool is_left = of.spindle == Turning::left;
  if (of.spindle == Turning::stopped) {
    find(Code::spindle_stopped, of, tool, fmt::format("T{} cuts", tool.number()));
  } else if (!tool.tool.is_insert() && tool.knows_hand() &&
             (tool.tool.hand == Hand::left) != is_left) {
    // Which way an insert wants the work to turn depends on how it is clamped.
    find(Code::spindle_direction, of, tool,
         fmt::format("T{} cuts with {}", tool.number(), is_left ? "M04" : "M03"));
  }
}

// A ramp that the tool is made for is none, though it passes over what lies under the middle.
void Judge::judge_core(const JudgedMotion& of, const CuttingTool& tool, const Outcome& sum) {
  if (sum.core.value() <= kDust_mm3) return;
  double steepest = 0;
  for (std::size_t i = 0; i < of.sweeps.size(); ++i) {
    if (of.outcomes[i].core.value() > kDust_mm3)
      steepest = std::max(steepest, steepness_deg(of.sweeps[i]));
  }
  const auto& ramp = tool.tool.limits.ramp_deg;
  if (ramp && steepest <= *ramp + kSameAngle_deg) return;
  std::string detail =
      fmt::format("T{} removes {:.3f} mm³ within its core", tool.number(), sum.core.value());
  if (ramp) detail += fmt::format(", going down at {:.1f}°: {}° are allowed", steepest, *ramp);
  find(Code::not_centre_cutting, of, tool, detail);
}

void Judge::judge_sideways(const JudgedMotion& of, const CuttingTool& tool) {
  for (std::size_t i = 0; i < of.sweeps.size(); ++i) {
    if (!goes_across(of.sweeps[i]) || of.outcomes[i].removed.value() < kDust_mm3) continue;
    find(Code::axial_tool_sideways, of, tool,
         fmt::format("T{} is a {}", tool.number(), tool.tool.type_name()));
    return;
  }
}

// The tap as it is in the model has its minor diameter: in a hole of that it removes nothing.
void Judge::judge_tap(const JudgedMotion& of, const CuttingTool& tool, const Outcome& sum) {
  double way = 0;
  for (const Sweep& sweep : of.sweeps) way += length(sweep.way);
  const double minor = tool.diameter_mm();
  const double ring = std::numbers::pi / 4 * minor * minor * (1 - kLeastHole * kLeastHole) * way;
  if (sum.removed.value() <= ring) return;
  find(Code::tap_without_hole, of, tool,
       fmt::format("T{} removes {:.3f} mm³, in a hole of its minor diameter {:.3f} it removes none",
                   tool.number(), sum.removed.value(), minor));
}

void Judge::find(Code code, const JudgedMotion& of, const CuttingTool& tool, const Contact& contact,
                 std::string detail) {
  const bool is_new = add({.code = code,
                           .detail = std::move(detail),
                           .block = of.block,
                           .tool = tool.number(),
                           .motion = of.motion,
                           .at = contact.at,
                           .depth_mm = contact.depth_mm,
                           .volume_mm3 = contact.volume.value()});
  has_found_ = has_found_ || is_new;
}

// Of what has no depth the place is where the tip goes.
void Judge::find(Code code, const JudgedMotion& of, const CuttingTool& tool,
                 const std::string& detail) {
  Contact contact;
  contact.at = point_at(of.sweeps.back().way, 1);
  find(code, of, tool, contact, detail);
}

}  // namespace kerf::stock
