#include "stock/tool/internal/cutting_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/decimal.hpp"
#include "math/math.hpp"
#include "stock/tool/internal/angles.hpp"
#include "stock/tool/internal/outline.hpp"

namespace kerf::stock {
namespace {

using M = Measure;
using enum ToolPart;

constexpr double kQuarter_rad = std::numbers::pi / 2;
constexpr double kPilotAngle = 118;

/// mm across for each mm along the axis, of a point of this included angle.
double flare(double angle) { return math::tan(radians(angle) / 2); }
bool is_level(double angle) { return angle >= 180; }

double radius(const Tool& tool) { return tool[M::diameter] / 2; }

/// "corner_radius, 7, is more than half of diameter, 6".
std::string value_of(M measure, double value) {
  return std::string(row_of(measure).name) + ", " + base::number_text(value) + ",";
}
tl::unexpected<std::string> refused(std::string sentence) {
  return tl::unexpected(std::move(sentence));
}

tl::unexpected<std::string> too_wide(const Tool& tool, M measure) {
  return refused(value_of(measure, tool[measure]) + " is not less than diameter, " +
                 base::number_text(tool[M::diameter]));
}

/// Ends where it cuts; what stands on it has the radius of the neck. Precondition: that is not
/// wider than the last edge.
CuttingShape necked(Outline& outline, double neck) {
  outline.out_to(neck, edge);
  return {.edges = outline.take(), .ends = true, .neck_mm = neck};
}

/// A cone of this included angle as far as the radius.
void flare_out(Outline& outline, double r, double angle) {
  if (is_level(angle)) return outline.out_to(r, edge);
  const auto [from, z] = outline.at();
  outline.to({r, z + (r - from) / flare(angle)}, edge);
}

}  // namespace

ShapeOutcome flat_shape(const Tool& tool) {
  const double r = radius(tool);
  const double corner = tool.value(M::corner_radius).value_or(0);
  const double ring = tool.value(M::width).value_or(0);
  if (corner > r)
    return refused(value_of(M::corner_radius, corner) + " is more than half of diameter, " +
                   base::number_text(2 * r));
  if (ring > r)
    return refused(value_of(M::width, ring) + " is more than half of diameter, " +
                   base::number_text(2 * r) + ": the ring crosses the axis");
  Outline outline;
  outline.out_to(r - corner, edge);
  if (corner > 0) outline.arc_to({r, corner}, {r - corner, corner}, kQuarter_rad, edge);
  return CuttingShape{.edges = outline.take()};
}

ShapeOutcome ball_shape(const Tool& tool) {
  const double r = radius(tool);
  Outline outline;
  outline.arc_to({r, r}, {0, r}, kQuarter_rad, edge);
  return CuttingShape{.edges = outline.take()};
}

ShapeOutcome cone_shape(const Tool& tool) {
  const double r = radius(tool);
  const double tip = tool[M::tip_diameter] / 2;
  const double ball = tool.value(M::tip_radius).value_or(0);
  if (tip >= r) return too_wide(tool, M::tip_diameter);
  if (tip > 0 && ball > 0) return refused("a tool has tip_radius or tip_diameter, not both");
  // The ball ends where the cone is its tangent.
  const double half = radians(tool[M::angle]) / 2;
  const double widest = ball * math::cos(half);
  if (widest > r)
    return refused(value_of(M::tip_radius, ball) + " makes a ball wider than diameter, " +
                   base::number_text(2 * r));
  Outline outline;
  outline.out_to(tip, edge);
  if (ball > 0 && !is_level(tool[M::angle]))
    outline.arc_to({widest, ball * (1 - math::sin(half))}, {0, ball}, kQuarter_rad - half, edge);
  flare_out(outline, r, tool[M::angle]);
  return CuttingShape{.edges = outline.take()};
}

ShapeOutcome drill_shape(const Tool& tool) {
  Outline outline;
  flare_out(outline, radius(tool), tool[M::angle]);
  return CuttingShape{.edges = outline.take()};
}

ShapeOutcome centre_drill_shape(const Tool& tool) {
  const double pilot = tool[M::pilot_diameter] / 2;
  if (pilot >= radius(tool)) return too_wide(tool, M::pilot_diameter);
  Outline outline;
  flare_out(outline, pilot, kPilotAngle);
  if (tool[M::pilot_length] < outline.at().z)
    return refused(value_of(M::pilot_length, tool[M::pilot_length]) +
                   " is shorter than its point of 118°, " + base::rounded_text(outline.at().z, 4));
  outline.up_to(tool[M::pilot_length], edge);
  flare_out(outline, radius(tool), tool[M::angle]);
  return CuttingShape{.edges = outline.take()};
}

ShapeOutcome reamer_shape(const Tool& tool) {
  const double r = radius(tool);
  const double lead = tool[M::lead];
  if (lead >= r)
    return refused(value_of(M::lead, lead) + " is not less than half of diameter, " +
                   base::number_text(2 * r));
  Outline outline;
  outline.out_to(r - lead, edge);
  outline.to({r, lead}, edge);
  return CuttingShape{.edges = outline.take()};
}

// The ridges of the thread are no body of revolution: what opens the hole is a bar of the minor
// diameter, the first two turns of which are ground down by the depth of the thread.
ShapeOutcome tap_shape(const Tool& tool) {
  const double pitch = tool[M::pitch];
  const double depth = 1.082531755 * pitch / 2;
  const double minor = radius(tool) - depth;
  if (minor - depth <= 0)
    return refused(value_of(M::pitch, pitch) + " leaves no core at diameter " +
                   base::number_text(tool[M::diameter]));
  Outline outline;
  outline.out_to(minor - depth, edge);
  outline.to({minor, 2 * pitch}, edge);
  return CuttingShape{.edges = outline.take()};
}

// Where neither ap_max nor flute_length is said nobody knows where the edges end, and they go on.
ShapeOutcome face_shape(const Tool& tool) {
  const double height = tool[M::ap_max];
  const bool is_right_angle = tool[M::entering_angle] >= 90;
  const double grows = is_right_angle ? 0 : height / math::tan(radians(tool[M::entering_angle]));
  Outline outline;
  outline.out_to(radius(tool), edge);
  outline.to({radius(tool) + grows, height}, edge);
  if (!tool.said(M::ap_max) && !tool.said(M::flute_length))
    return CuttingShape{.edges = outline.take()};
  outline.up_to(std::max(height, tool.said(M::flute_length).value_or(0)), edge);
  const auto body = tool.said(M::body_diameter);
  const double above = body ? *body / 2 : outline.at().r;
  return CuttingShape{.edges = outline.take(), .ends = true, .neck_mm = above};
}

ShapeOutcome disc_shape(const Tool& tool) {
  const double neck = tool[M::neck_diameter] / 2;
  if (neck >= radius(tool)) return too_wide(tool, M::neck_diameter);
  Outline outline;
  outline.out_to(radius(tool), edge);
  outline.up_to(tool[M::width], edge);
  return necked(outline, neck);
}

ShapeOutcome dovetail_shape(const Tool& tool) {
  const double neck = tool[M::neck_diameter] / 2;
  const double height = tool[M::height];
  if (neck >= radius(tool)) return too_wide(tool, M::neck_diameter);
  if (tool[M::angle] > 90) return refused("angle of a dovetail is at most 90");
  const bool is_right_angle = tool[M::angle] == 90;
  const double shrinks = is_right_angle ? 0 : height / math::tan(radians(tool[M::angle]));
  if (radius(tool) - shrinks < neck)
    return refused("the flank crosses the neck below height, " + base::number_text(height));
  Outline outline;
  outline.out_to(radius(tool), edge);
  outline.to({radius(tool) - shrinks, height}, edge);
  return necked(outline, neck);
}

ShapeOutcome lollipop_shape(const Tool& tool) {
  const double r = radius(tool);
  const double neck = tool[M::neck_diameter] / 2;
  if (neck >= r) return too_wide(tool, M::neck_diameter);
  Outline outline;
  outline.arc_to({r, r}, {0, r}, kQuarter_rad, edge);
  outline.arc_to({neck, r + std::sqrt(r * r - neck * neck)}, {0, r}, math::acos(neck / r), edge);
  return necked(outline, neck);
}

// Teeth as ISO 68-1 has the groove of a nut: depth 17/24 H, as wide as P/8 at the crest. Deeper
// ones are cut off where neighbouring flanks meet.
ShapeOutcome thread_mill_shape(const Tool& tool) {
  const double r = radius(tool);
  const double pitch = tool[M::pitch];
  const auto neck = tool.said(M::neck_diameter);
  if (neck && *neck / 2 >= r) return too_wide(tool, M::neck_diameter);
  const double slope = flare(tool[M::profile_angle]);  // along the axis, a mm of depth
  const double crest = pitch / 8;
  const double meet = (pitch - crest) / (2 * slope);
  const double wanted = neck ? r - *neck / 2 : 0.6134 * pitch;
  const double depth = tool[M::teeth] > 1 ? std::min(wanted, meet) : wanted;
  if (depth >= r)
    return refused(value_of(M::pitch, pitch) + " makes teeth that cross the axis at diameter " +
                   base::number_text(2 * r));
  Outline outline;
  for (double tooth = 0; tooth < tool[M::teeth]; ++tooth) {
    // Where flanks meet, rounding may have passed the next tooth's beginning.
    const double z = std::max(tooth * pitch, outline.at().z);
    outline.to({r - depth, z}, edge);
    outline.to({r, z + depth * slope}, edge);
    outline.to({r, z + depth * slope + crest}, edge);
    outline.to({r - depth, z + 2 * depth * slope + crest}, edge);
  }
  if (neck) return necked(outline, *neck / 2);
  return CuttingShape{.edges = outline.take(), .ends = true};
}

ShapeOutcome probe_shape(const Tool& tool) {
  if (tool.said(M::neck_diameter)) return lollipop_shape(tool);
  const double r = radius(tool);
  Outline outline;
  outline.arc_to({r, r}, {0, r}, kQuarter_rad, edge);
  outline.arc_to({0, 2 * r}, {0, r}, kQuarter_rad, edge);
  return CuttingShape{.edges = outline.take(), .ends = true};
}

}  // namespace kerf::stock
