#include "stock/cutting/cutting_data.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/angle.hpp"
#include "math/math.hpp"
#include "motion/feed.hpp"

namespace kerf::stock {
namespace {

constexpr double kMillimetresPerMetre = 1000;
constexpr double kDrillLips = 2;  // of a drill whose lips nobody has counted
constexpr double kLeastSine = 0.01;

double sine_deg(double degrees) {
  return std::max(kLeastSine, std::fabs(geometry::sine_cosine_deg(degrees).sine));
}

double surface_speed(double diameter_mm, double rpm) {
  return std::numbers::pi * diameter_mm * rpm / kMillimetresPerMetre;
}

double feed_per_minute(const CutFacts& facts) {
  return facts.has_feed ? motion::feed_per_minute(facts.feed, facts.length_mm, facts.rpm) : 0;
}

double feed_per_turn(const CutFacts& facts) {
  if (!facts.has_feed) return 0;
  if (facts.feed.mode == motion::FeedMode::per_revolution) return facts.feed.value;
  return facts.rpm > 0 ? feed_per_minute(facts) / facts.rpm : 0;
}

/// sin κ of a mill that goes across its axis, κ from the way to the edge.
double sine_across(const Tool& tool) {
  switch (tool.kind) {
    case ToolKind::face: return sine_deg(tool.value(Measure::entering_angle).value_or(90));
    case ToolKind::chamfer:
    case ToolKind::engrave: return sine_deg(90 - tool.value(Measure::angle).value_or(0) / 2);
    default: return 1;
  }
}

/// Of a tool that goes along its axis: half the included angle of its point.
double sine_along(const Tool& tool) {
  const bool is_pointed = tool.kind == ToolKind::drill || tool.kind == ToolKind::chamfer ||
                          tool.kind == ToolKind::centre_drill;
  return is_pointed ? sine_deg(tool.value(Measure::angle).value_or(180) / 2) : 1;
}

void take_mill(const CutFacts& facts, CuttingData& data) {
  const Tool& tool = facts.tool.tool;
  const double diameter = facts.tool.diameter_mm();
  data.engagement = engagement_of(facts.outcome, {.radius_mm = diameter / 2,
                                                  .length_mm = facts.length_mm,
                                                  .grain_mm = facts.grain_mm,
                                                  .turns_left = facts.turns_left});
  const Engagement& engaged = data.engagement;
  data.is_fine = facts.outcome.aside.length() < facts.grain_mm * (1 - 1e-6);
  if (engaged.ae_mm > 0) {
    data.told_mm3 = std::min(data.told_mm3, engaged.ae_mm * engaged.ap_mm * facts.length_mm);
  }
  if (!(data.fz_mm > 0) || !(engaged.phi_rad > 0)) return;
  data.hm_mm = mean_chip_mm({.sin_kappa = sine_across(tool),
                             .ae_mm = engaged.ae_mm,
                             .fz_mm = data.fz_mm,
                             .diameter_mm = diameter,
                             .phi_rad = engaged.phi_rad});
  if (facts.material) data.kc = specific_force(*facts.material, data.hm_mm);
}

/// Section of the ring that a tool cuts along its axis, mm².
double ring_mm2(const CutFacts& facts) {
  if (facts.outcome.aside.is_empty()) return 0;
  const double inside =
      std::max(0.0, facts.outcome.aside.low - facts.grain_mm / 2 * std::numbers::sqrt2);
  const double outside =
      std::min(facts.tool.diameter_mm() / 2, facts.outcome.aside.high + facts.grain_mm / 2);
  return std::numbers::pi * (outside * outside - inside * inside);
}

void take_axial(const CutFacts& facts, CuttingData& data) {
  const Tool& tool = facts.tool.tool;
  const bool is_drill = tool.kind == ToolKind::drill;
  const double teeth = tool.said(Measure::flutes).value_or(is_drill ? kDrillLips : 0);
  const double turn = feed_per_turn(facts);
  if (!(teeth > 0) || !(turn > 0)) return;
  data.hm_mm = turn / teeth * sine_along(tool);
  if (!facts.material || tool.kind == ToolKind::tap) return;
  data.feed_kw = removal_kw(turn * facts.rpm / motion::kSecondsPerMinute * ring_mm2(facts),
                            specific_force(*facts.material, data.hm_mm));
}

/// Facing goes along the minor edge of the insert: κ there is that of the corner's other side.
double sine_of_insert(const CutFacts& facts) {
  const Tool& tool = facts.tool.tool;
  const double kappa = tool.value(Measure::kapr).value_or(90);
  if (!facts.is_facing || tool.kind == ToolKind::grooving || tool.kind == ToolKind::parting)
    return sine_deg(kappa);
  return sine_deg(kappa + tool.value(Measure::tip_angle).value_or(90) - 90);
}

void take_insert(const CutFacts& facts, CuttingData& data) {
  const double section = facts.outcome.section.value();
  if (facts.length_mm > 0) data.engagement.ap_mm = section / facts.length_mm;
  const double turn = feed_per_turn(facts);
  if (!(turn > 0)) return;
  data.fz_mm = turn;
  const double sine = sine_of_insert(facts);
  data.hm_mm = turn * sine;
  if (!facts.material || !(data.engagement.ap_mm > 0)) return;
  data.feed_kw =
      force_kw(turning_force_n(*facts.material, data.engagement.ap_mm, turn, sine), data.vc_m_min);
}

}  // namespace

CuttingData cutting_data(const CutFacts& facts) {
  CuttingData data;
  const Tool& tool = facts.tool.tool;
  const bool is_insert = tool.is_insert() && facts.turns_work;
  data.rpm = facts.rpm;
  data.told_mm3 = facts.outcome.removed.value();
  if (facts.rpm > 0) {
    data.vc_m_min =
        surface_speed(is_insert ? 2 * facts.radius_mm : facts.tool.diameter_mm(), facts.rpm);
  }
  if (is_insert) {
    take_insert(facts, data);
    return data;
  }
  if (const auto teeth = tool.said(Measure::flutes); teeth && *teeth > 0)
    data.fz_mm = feed_per_turn(facts) / *teeth;
  if (facts.is_axial) {
    take_axial(facts, data);
  } else {
    take_mill(facts, data);
  }
  return data;
}

}  // namespace kerf::stock
