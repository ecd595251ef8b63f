#include "stock/cutting/cutter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "math/math.hpp"

namespace kerf::stock {
namespace {

using base::Code;
using base::TipPoint;

constexpr std::array<std::string_view, kToolParts> kPartNames = {"cutting edges", "flutes' end",
                                                                 "shank", "holder"};
// What is removed below this is dust of rounding, mm³.
constexpr double kDust_mm3 = 1e-6;

/// A way is across the tool's axis where it leaves the direction of it by more than this.
constexpr double kAcross_mm = 1e-6;

bool goes_across(const Sweep& sweep) {
  if (const auto* const straight = std::get_if<StraightWay>(&sweep.way)) {
    const Vec3 way = straight->to - straight->from;
    return geometry::length(geometry::cross(way, sweep.axis)) > kAcross_mm;
  }
  return true;
}

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

/// Farthest point of the body from its tip.
double reach_of(const Body& body) {
  const double height = body.profile.height() < Profile::kEndless_mm ? body.profile.height()
                                                                     : body.profile.edge_height();
  return math::hypot(std::min(height, 1000.0), body.profile.widest());
}

/// The middle of a ball is its radius above the tip.
BallWay ball_of(const Sweep& sweep, double radius_mm) {
  const auto* const turning = std::get_if<TurningWay>(&sweep.way);
  const Vec3 axis_after = turning != nullptr ? turning->to_axis : sweep.axis;
  return {{point_at(sweep.way, 0) + radius_mm * sweep.axis,
           point_at(sweep.way, 1) + radius_mm * axis_after},
          radius_mm};
}

}  // namespace

Cutter::Cutter(const motion::AxisSetup& axes, const WorkFrame& frame, Model& model, ToolRack& rack,
               const Settings& settings)
    : frame_(frame),
      model_(model),
      rack_(rack),
      settings_(settings),
      curves_(axes),
      maker_(frame, settings.tolerance_mm),
      at_(axes.start),
      checks_(!settings.is_placed) {
  if (settings.has_tool) tool_ = &rack_.tool(0);
}

void Cutter::take(const motion::Motion& motion) {
  ++motions_;
  if (const auto* const change = std::get_if<motion::ToolChange>(&motion.action)) {
    change_tool(change->tool);
  } else if (const auto* const spindle = std::get_if<motion::Spindle>(&motion.action)) {
    turn(*spindle);
  } else if (const TipPoint* const to = motion::target_of(motion)) {
    move(motion, *to);
  }
}

void Cutter::turn(const motion::Spindle& spindle) {
  using motion::Spindle;
  if (spindle.name == motion::SpindleName::sub) return;
  if (settings_.turns_work && spindle.name == motion::SpindleName::live) return;
  // Of a surface speed without a limit only the tool's place tells the rpm.
  const double speed = spindle.follows_radius() ? spindle.speed : spindle.known_rpm();
  spindle_ = !spindle.turns() || !(speed > 0)                 ? Turning::stopped
             : spindle.turning == Spindle::Turning::clockwise ? Turning::right
                                                              : Turning::left;
}

void Cutter::change_tool(std::uint32_t number) {
  changed_tool_ = true;
  tool_ = &rack_.tool(number);
}

void Cutter::move(const motion::Motion& motion, const TipPoint& to) {
  const bool rapid = std::holds_alternative<motion::Rapid>(motion.action);
  checks_ = checks_ || !rapid;
  fed_ = fed_ || (!rapid && (tool_ == nullptr || !tool_->is_probe()));
  if (tool_ == nullptr) {
    fed_without_tool_ = fed_without_tool_ || !rapid;
  } else if (checks_) {
    add_sweeps(motion, rapid ? SweepKind::rapid : SweepKind::cut);
  }
  at_ = to;
  checks_ = checks_ || settings_.is_placed();
}

void Cutter::add_sweeps(const motion::Motion& motion, SweepKind kind) {
  const bool probes = std::holds_alternative<motion::Probe>(motion.action);
  if (stuck_ || (probes && tool_->is_probe())) return;
  Waiting of{.block = motion.block,
             .motion = motions_,
             .first = sweeps_.size(),
             .tool = tool_->number(),
             .kind = kind,
             .spindle = spindle_};
  Sweep like{.body = body_of(*tool_), .kind = kind, .motion = static_cast<std::uint32_t>(motions_)};
  if (const auto* const thread = std::get_if<motion::Thread>(&motion.action)) {
    like.lead_mm = std::fabs(thread->lead);
    like.start_deg = thread->angle_deg;
    threads_.emplace(like.motion, motion.block);
  }
  TipPoint from = at_;
  for (const motion::Curve& curve : curves_.of(at_, motion)) {
    maker_.add(from, curve, like, reach_of(tool_->body), sweeps_);
    from = curve.end();
  }
  of.end = sweeps_.size();
  for (std::size_t i = of.first; i < of.end && !stuck_; ++i) {
    of.length_mm += length(sweeps_[i].way);
    if (!model_.can_cut(sweeps_[i])) stuck_ = motion.block;
  }
  if (stuck_) {
    sweeps_.resize(of.first);
    return;
  }
  if (of.end > of.first) waiting_.push_back(of);
  if (sweeps_.size() >= kBatch) cut_batch();
}

BodyId Cutter::body_of(const CuttingTool& tool) {
  const auto known = bodies_.find(tool.number());
  if (known != bodies_.end()) return known->second;
  return bodies_.emplace(tool.number(), model_.add_body(tool.body)).first->second;
}

void Cutter::finish() { cut_batch(); }

// The middle of the ball goes straight wherever the tool does. A curve that turns is divided into
// equal shares.
std::optional<double> Cutter::touch(const TipPoint& from, const TipPoint& to) {
  cut_batch();
  const bool has_ball = tool_ != nullptr && tool_->is_probe();
  const double radius = has_ball ? tool_->diameter_mm() / 2 : 0;
  motion::Motion move;
  move.action = motion::Probe{.to = to, .feed = {}};
  std::vector<Sweep> sweeps;
  for (const motion::Curve& curve : curves_.of(from, move))
    maker_.add(from, curve, {}, radius, sweeps);
  const auto count = static_cast<double>(sweeps.size());
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    if (const auto t = first_touch(ball_of(sweeps[i], radius)))
      return (static_cast<double>(i) + *t) / count;
  }
  return std::nullopt;
}

std::optional<double> Cutter::first_touch(const BallWay& ball) const {
  std::optional<double> first = model_.first_touch(ball);
  for (const Obstacle* const obstacle : settings_.obstacles) {
    const auto t = obstacle->first_touch(ball);
    if (t && (!first || *t < *first)) first = t;
  }
  return first;
}

void Cutter::cut_batch() {
  outcomes_.assign(sweeps_.size(), Outcome{});
  model_.cut(sweeps_, outcomes_);
  for (const Waiting& of : waiting_) {
    Outcome sum;
    for (std::size_t i = of.first; i < of.end; ++i) sum.add(outcomes_[i]);
    judge(of, sum);
    record(of, sum);
  }
  waiting_.clear();
  sweeps_.clear();
}

void Cutter::judge(const Waiting& of, const Outcome& outcome) {
  removed_ += outcome.removed;
  visited_ += outcome.visited;
  judge_obstacles(of);
  if (of.kind == SweepKind::rapid) {
    judge_rapid(of, outcome);
  } else {
    judge_cut(of, outcome);
  }
}

void Cutter::judge_obstacles(const Waiting& of) {
  const std::span<const Sweep> sweeps(sweeps_.data() + of.first, of.end - of.first);
  for (Obstacle* const obstacle : settings_.obstacles) {
    const Obstacle::Contacts contacts = obstacle->meet(sweeps, rack_.tool(of.tool).body);
    const auto [worst, part] = deepest(contacts);
    if (!worst.is_one() || !rack_.tool(of.tool).knows_shape()) continue;
    find(Code::fixture_collision, of, worst,
         fmt::format("the {} of T{} {:.3f} mm deep in {}", kPartNames[part], of.tool,
                     worst.depth_mm, obstacle->name()));
  }
}

void Cutter::judge_rapid(const Waiting& of, const Outcome& outcome) {
  const auto [worst, part] = deepest(outcome.contacts);
  if (worst.is_one() && knows_collisions(rack_.tool(of.tool))) {
    find(Code::rapid_in_stock, of, worst,
         fmt::format("the {} of T{} {:.3f} mm deep", kPartNames[part], of.tool, worst.depth_mm));
  }
}

void Cutter::judge_cut(const Waiting& of, const Outcome& outcome) {
  const CuttingTool& tool = rack_.tool(of.tool);
  const auto& contacts = outcome.contacts;
  const auto told = [&](ToolPart part, Code code) {
    const Contact& contact = contacts[index(part)];
    if (contact.is_one() && knows_collisions(tool))
      find(code, of, contact, fmt::format("T{} {:.3f} mm deep", of.tool, contact.depth_mm));
  };
  if (tool.is_probe()) {
    told(ToolPart::edge, Code::probe_in_stock);
    return;
  }
  if (tool.tool.is_insert()) {
    judge_back(of, outcome);
  } else {
    told(ToolPart::flank, Code::flute_length);
    told(ToolPart::shank, Code::shank_collision);
    told(ToolPart::holder, Code::holder_collision);
  }
  if (outcome.removed.value() < kDust_mm3 && outcome.threaded.value() < kDust_mm3) return;
  judge_spindle(of, tool);
  if (outcome.core.value() > kDust_mm3) {
    find(Code::not_centre_cutting, of,
         fmt::format("T{} removes {:.3f} mm³ within its core", of.tool, outcome.core.value()));
  }
  const auto across = [&](std::size_t i) { return goes_across(sweeps_[i]); };
  if (!tool.is_axial()) return;
  for (std::size_t i = of.first; i < of.end; ++i) {
    if (!across(i) || outcomes_[i].removed.value() < kDust_mm3) continue;
    find(Code::axial_tool_sideways, of, fmt::format("T{} is a {}", of.tool, tool.tool.type_name()));
    return;
  }
}

// Of an insert nothing cuts but its edges, and the bar is behind them, too.
void Cutter::judge_back(const Waiting& of, const Outcome& outcome) {
  Contact contact;
  for (const ToolPart part : {ToolPart::flank, ToolPart::shank, ToolPart::holder})
    contact.add(outcome.contacts[index(part)]);
  if (!contact.is_one() || !knows_collisions(rack_.tool(of.tool))) return;
  find(Code::insert_collision, of, contact,
       fmt::format("T{} {:.3f} mm deep", of.tool, contact.depth_mm));
}

void Cutter::judge_spindle(const Waiting& of, const CuttingTool& tool) {
  const bool is_left = of.spindle == Turning::left;
  if (of.spindle == Turning::stopped) {
    find(Code::spindle_stopped, of, fmt::format("T{} cuts", of.tool));
  } else if (!tool.tool.is_insert() && tool.knows_hand() &&
             (tool.tool.hand == Hand::left) != is_left) {
    // Which way an insert wants the work to turn depends on how it is clamped.
    find(Code::spindle_direction, of,
         fmt::format("T{} cuts with {}", of.tool, is_left ? "M04" : "M03"));
  }
}

void Cutter::find(Code code, const Waiting& of, const Contact& contact, std::string detail) {
  findings_.add({.code = code,
                 .detail = std::move(detail),
                 .block = of.block,
                 .tool = of.tool,
                 .motion = of.motion,
                 .at = contact.at,
                 .depth_mm = contact.depth_mm,
                 .volume_mm3 = contact.volume.value()});
}

// Of what has no depth the place is where the tip goes.
void Cutter::find(Code code, const Waiting& of, const std::string& detail) {
  Contact contact;
  contact.at = point_at(sweeps_[of.end - 1].way, 1);
  find(code, of, contact, detail);
}

void Cutter::record(const Waiting& of, const Outcome& outcome) {
  const auto same = [&](const ToolRecord& record) { return record.tool == of.tool; };
  auto place = std::find_if(tools_.begin(), tools_.end(), same);
  if (place == tools_.end()) place = tools_.insert(place, ToolRecord{.tool = of.tool});
  const bool removes = outcome.removed.value() > kDust_mm3 || outcome.threaded.value() > kDust_mm3;
  place->removed_mm3 += outcome.removed.value();
  if (of.kind == SweepKind::rapid) return;
  (removes ? place->cut_mm : place->air_mm) += of.length_mm;
  bool& axial = axial_tools_.try_emplace(of.tool, true).first->second;
  for (std::size_t i = of.first; axial && i < of.end; ++i) axial = !goes_across(sweeps_[i]);
  has_cut_ = has_cut_ || removes;
  for (std::size_t i = of.first; removes && i < of.end; ++i) {
    if (outcomes_[i].removed.value() + outcomes_[i].threaded.value() > kDust_mm3)
      place->lowest = std::min(place->lowest, bounds(sweeps_[i].way).low.z);
  }
}

}  // namespace kerf::stock
