#include "stock/cutting/thread_watch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/angle.hpp"
#include "math/math.hpp"
#include "stock/cutting/judge.hpp"

namespace kerf::stock {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSame_mm = 1e-3;
/// Depth of the basic profile inside and outside, of the pitch (ISO 68-1).
constexpr double kInside = 1.082531755 / 2;
constexpr double kOutside = 0.6134;
/// Width of its groove where it is narrowest, and of one inside where it is widest.
constexpr double kCrest = 0.125;
constexpr double kMouth = 0.75;
constexpr double kChamferOfTap = 2;  // pitches
constexpr double kLeastTurn = 2 * kPi * 0.95;
constexpr double kLeastLength = 0.5;  // pitches
constexpr int kLines = 8;             // round the thread, to look where material is

Vec3 across(Vec3 axis) {
  const Vec3 other = std::fabs(axis.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  return geometry::unit(geometry::cross(axis, other));
}

/// Far from the line through a point along the axis.
double off_axis(Vec3 from, Vec3 to, Vec3 axis) {
  return geometry::length(geometry::cross(to - from, axis));
}

/// Of a tooth of a mill: its depth, and how high the middle of its crest is above its foot.
struct Tooth {
  double depth;
  double middle;
};
Tooth tooth_of(const CuttingTool& tool) {
  const double depth = tool.diameter_mm() / 2 - tool.body.profile.radius_at(0);
  const double slope = math::tan(geometry::radians(tool.tool[Measure::profile_angle]) / 2);
  return {depth, depth * slope + kCrest / 2 * tool.tool[Measure::pitch]};
}

}  // namespace

void ThreadWatch::take(const ThreadMove& move) {
  if (move.spindle == Turning::stopped) return;
  if (move.tool.tool.kind == ToolKind::tap) take_tap(move);
  if (move.tool.tool.kind == ToolKind::thread_mill) take_mill(move);
}

ThreadWatch::Entry& ThreadWatch::entry_of(const Entry& like) {
  for (Entry& known : entries_) {
    if (known.thread.tool == like.thread.tool && known.axis == like.axis &&
        off_axis(known.centre, like.centre, like.axis) <= kSame_mm &&
        std::fabs(known.radius - like.radius) <= kSame_mm)
      return known;
  }
  entries_.push_back(like);
  return entries_.back();
}

void ThreadWatch::take_tap(const ThreadMove& move) {
  const double pitch = move.tool.tool[Measure::pitch];
  for (const Sweep& sweep : move.sweeps) {
    const auto* const way = std::get_if<StraightWay>(&sweep.way);
    if (way == nullptr || goes_across(sweep) || !(dot(way->to - way->from, sweep.axis) < 0))
      continue;
    Entry like;
    like.axis = sweep.axis;
    like.centre = way->to;
    like.thread = {.block = move.block,
                   .motion = static_cast<std::uint32_t>(move.motion),
                   .tool = move.tool.number(),
                   .from = {},
                   .to = {},
                   .major = 2 * kInside * pitch + move.tool.diameter_mm(),
                   .minor = move.tool.diameter_mm(),
                   .pitch = pitch,
                   .hand = move.spindle == Turning::right ? Hand::right : Hand::left};
    like.low = kChamferOfTap * pitch;
    like.high = dot(way->from - way->to, sweep.axis);
    Entry& entry = entry_of(like);
    const double lift = dot(way->to - entry.centre, sweep.axis);
    entry.low = std::min(entry.low, lift + like.low);
    entry.high = std::max(entry.high, lift + like.high);
  }
}

void ThreadWatch::take_mill(const ThreadMove& move) {
  for (std::size_t i = 0; i < move.sweeps.size(); ++i) {
    const auto* const arc = std::get_if<ArcWay>(&move.sweeps[i].way);
    if (arc != nullptr) take_turn(move, move.sweeps[i], *arc, move.outcomes[i]);
  }
}

void ThreadWatch::take_turn(const ThreadMove& move, const Sweep& sweep, const ArcWay& arc,
                            const Outcome& outcome) {
  const double sense = dot(geometry::cross(arc.e1, arc.e2), sweep.axis);
  if (std::fabs(sense) < 1 - kSame_mm || std::fabs(arc.radius_change) > kSame_mm) return;
  Entry like;
  like.axis = sweep.axis;
  like.centre = arc.centre;
  like.radius = std::fabs(arc.radius);
  like.thread.block = move.block;
  like.thread.motion = static_cast<std::uint32_t>(move.motion);
  like.thread.tool = move.tool.number();
  like.low = like.high = dot(point_at(arc, 0) - arc.centre, sweep.axis);
  Entry& entry = entry_of(like);
  for (const double t : {0.0, 1.0}) {
    const double height = dot(point_at(arc, t) - entry.centre, sweep.axis);
    entry.low = std::min(entry.low, height);
    entry.high = std::max(entry.high, height);
  }
  const double turn = sense * arc.turn_rad;
  const double rise = dot(arc.rise, sweep.axis);
  if (std::fabs(rise) > kSame_mm * std::fabs(turn)) {  // a level circle at the end has no lead
    entry.turn_rad += std::fabs(turn);
    entry.rise_mm += std::copysign(1.0, turn) * rise;
  }
  // Against the clock what lies left of the way is nearer to the centre.
  double right = 0;
  for (std::size_t k = 0; k < Outcome::kBins; ++k)
    right += (k < Outcome::kBins / 2 ? 1 : -1) * outcome.across[k].value();
  entry.outside_mm3 += std::copysign(right, right * turn);
  entry.thread.volume_mm3 += outcome.removed.value();
}

/// What its teeth have made of the ways of a mill; false: no thread.
bool ThreadWatch::complete(Entry& entry, const CuttingTool& tool) {
  CutThread& thread = entry.thread;
  if (tool.tool.kind != ToolKind::thread_mill) return true;
  if (entry.turn_rad < kLeastTurn) return false;
  const double lead = std::fabs(entry.rise_mm) / entry.turn_rad * 2 * kPi;
  const double own = tool.tool[Measure::pitch];
  if (!(lead > kSame_mm)) return false;
  thread.starts = static_cast<int>(std::clamp(std::round(lead / own), 1.0, 1000.0));
  thread.pitch = lead / thread.starts;
  thread.hand = entry.rise_mm > 0 ? Hand::right : Hand::left;
  thread.is_milled = true;
  thread.is_inside = entry.outside_mm3 > 0;
  const Tooth tooth = tooth_of(tool);
  const double reach = tool.diameter_mm() / 2;
  if (thread.is_inside) {
    thread.major = 2 * (entry.radius + reach);
    thread.minor = thread.major - 2 * std::min(tooth.depth, kInside * thread.pitch);
  } else {
    thread.minor = 2 * (entry.radius - reach);
    thread.major = thread.minor + 2 * std::min(tooth.depth, kOutside * thread.pitch);
  }
  entry.low += tooth.middle;
  entry.high += tooth.middle + (tool.tool[Measure::teeth] - 1) * own;
  return true;
}

/// What of it is in material; false: nothing that would hold a screw.
bool ThreadWatch::clip(Entry& entry, const Model& model) {
  CutThread& thread = entry.thread;
  const double aside = 0.05 * thread.pitch;
  const double radius = !thread.is_milled  ? (thread.major + thread.minor) / 4
                        : thread.is_inside ? thread.major / 2 + aside
                                           : thread.minor / 2 - aside;
  const Vec3 u = across(entry.axis);
  const Vec3 v = geometry::cross(entry.axis, u);
  const Vec3 top = entry.centre + entry.high * entry.axis;
  const Vec3 bottom = entry.centre + entry.low * entry.axis;
  Stretch met;
  for (int i = 0; i < kLines; ++i) {
    const auto [sine, cosine] = math::sine_cosine(2 * kPi * (i + 0.5) / kLines);
    const Vec3 off = radius * (cosine * u + sine * v);
    met.add(model.material_on({top + off, bottom + off}));
  }
  thread.from = point_at(StraightWay{top, bottom}, std::min(met.low, 1.0));
  thread.to = point_at(StraightWay{top, bottom}, std::max(met.high, 0.0));
  return !met.is_empty() &&
         geometry::length(thread.to - thread.from) >= kLeastLength * thread.pitch;
}

// A trapezoid: at the minor diameter 3/4 of the pitch wide, at the major one an eighth.
double ThreadWatch::groove_mm3(const CutThread& thread) {
  const double depth = (thread.major - thread.minor) / 2;
  const double area = (kMouth + kCrest) / 2 * thread.pitch * depth;
  const double centroid = depth / 3 * (kMouth + 2 * kCrest) / (kMouth + kCrest);
  const double turns = geometry::length(thread.to - thread.from) / thread.pitch;
  return area * 2 * kPi * (thread.minor / 2 + centroid) * turns;
}

std::vector<CutThread> ThreadWatch::threads(const Model& model, ToolRack& rack) const {
  std::vector<CutThread> out;
  for (Entry entry : entries_) {
    if (!complete(entry, rack.tool(entry.thread.tool)) || !clip(entry, model)) continue;
    if (!entry.thread.is_milled) entry.thread.volume_mm3 = groove_mm3(entry.thread);
    out.push_back(entry.thread);
  }
  return out;
}

}  // namespace kerf::stock
