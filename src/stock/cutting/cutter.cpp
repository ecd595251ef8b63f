#include "stock/cutting/cutter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/math.hpp"
#include "motion/feed.hpp"
#include "motion/spindle_speed.hpp"
#include "stock/sweep/shorten.hpp"

namespace kerf::stock {
namespace {

using base::Code;
using base::TipPoint;

/// Lengths of a tool that differ by less are the same.
constexpr double kSameLength_mm = 0.001;
/// Likewise the lead of a thread and the pitch of its tool.
constexpr double kSamePitch = 0.005;

/// A line between two set-points has at least this length.
constexpr double kShortest_mm = 1e-9;

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

MoveName name_of(const motion::Motion& motion) {
  if (std::holds_alternative<motion::Rapid>(motion.action)) return MoveName::rapid;
  if (std::holds_alternative<motion::Arc>(motion.action)) return MoveName::arc;
  if (std::holds_alternative<motion::SpaceArc>(motion.action)) return MoveName::space_arc;
  if (std::holds_alternative<motion::Thread>(motion.action)) return MoveName::thread;
  if (std::holds_alternative<motion::Probe>(motion.action)) return MoveName::probe;
  const auto* const surface = std::get_if<motion::SurfaceMove>(&motion.action);
  return surface != nullptr && surface->is_arc ? MoveName::arc : MoveName::line;
}

const motion::Feed* feed_of(const motion::Motion& motion) {
  return std::visit(
      [](const auto& action) -> const motion::Feed* {
        if constexpr (requires { action.feed; }) {
          return &action.feed;
        } else {
          return nullptr;
        }
      },
      motion.action);
}

/// The tool stands so much lower where its way begins, and where it ends; what is not straight is
/// lowered as its end.
void lower(Sweep& sweep, double from_mm, double to_mm) {
  if (auto* const straight = std::get_if<StraightWay>(&sweep.way)) {
    straight->from = straight->from - from_mm * sweep.axis;
    straight->to = straight->to - to_mm * sweep.axis;
  } else if (auto* const arc = std::get_if<ArcWay>(&sweep.way)) {
    arc->centre = arc->centre - to_mm * sweep.axis;
  } else {
    auto& turning = std::get<TurningWay>(sweep.way);
    turning.from = turning.from - from_mm * sweep.axis;
    turning.to = turning.to - to_mm * turning.to_axis;
  }
}

bool is_within(Vec3 place, const Bounds& box) {
  return place.x >= box.low.x && place.x <= box.high.x && place.y >= box.low.y &&
         place.y <= box.high.y && place.z < box.high.z;
}

}  // namespace

Cutter::Cutter(const motion::AxisSetup& axes, const WorkFrame& frame, Model& model, ToolRack& rack,
               const Settings& settings)
    : frame_(frame),
      still_(frame.still()),
      model_(model),
      rack_(rack),
      settings_(settings),
      curves_(axes),
      maker_(frame, settings.tolerance_mm),
      still_maker_(still_, settings.tolerance_mm),
      judge_(findings_, settings.judge),
      spindles_(axes, settings.turns_work),
      at_(axes.start),
      axis_count_(axes.count()),
      checks_(!settings.is_placed) {
  if (settings.has_tool) tool_ = &rack_.tool(0);
}

void Cutter::take(const motion::Motion& motion) {
  ++motions_;
  if (settings_.end && motions_ > settings_.end->motion) return;
  if (const auto* const change = std::get_if<motion::ToolChange>(&motion.action)) {
    change_tool(change->tool);
  } else if (const auto* const spindle = std::get_if<motion::Spindle>(&motion.action)) {
    spindles_.take(*spindle);
  } else if (const TipPoint* const to = motion::target_of(motion)) {
    move(motion, *to);
  }
}

void Cutter::take_along(const motion::Motion& motion, std::span<const TipPoint> tips) {
  along_ = &tips;
  take(motion);
  along_ = nullptr;
}

void Cutter::change_tool(std::uint32_t number) {
  changed_tool_ = true;
  tool_ = &rack_.tool(number);
  lowered_mm_ = 0;
}

void Cutter::move(const motion::Motion& motion, const TipPoint& to) {
  const bool rapid = std::holds_alternative<motion::Rapid>(motion.action);
  spindles_.move(at_, to);
  checks_ = checks_ || !rapid;
  fed_ = fed_ || (!rapid && (tool_ == nullptr || !tool_->is_probe()));
  fed_without_tool_ = fed_without_tool_ || (tool_ == nullptr && !rapid);
  Waiting of = waiting_of(motion, to);
  if (tool_ != nullptr && checks_) add_sweeps(motion, of);
  of.end = now_.sweeps.size();
  if (!stuck_) now_.waiting.push_back(of);
  if (along_ == nullptr) at_ = to;
  if (along_ != nullptr && !along_->empty()) at_ = along_->back();
  checks_ = checks_ || settings_.is_placed();
  const bool looks = next_look_ < settings_.looks.size() && settings_.looks[next_look_] == motions_;
  const std::size_t most = settings_.batch;
  if (looks) {
    finish();
    ++next_look_;
    settings_.look(of.cut);
  } else if (now_.sweeps.size() >= most || now_.waiting.size() >= most) {
    cut_batch();
  }
}

// What is driven is so where its spindle turns, or where that of the work stands.
bool Cutter::is_turned() const {
  if (!settings_.turns_work) return false;
  if (tool_ == nullptr || tool_->tool.is_insert() || !tool_->driven) return true;
  return !spindles_.drive_tool() && spindles_.turning(Spindles::Of::work) != Turning::stopped;
}

Cutter::Waiting Cutter::waiting_of(const motion::Motion& motion, const TipPoint& to) const {
  Waiting of;
  of.cut = {.block = motion.block,
            .motion = motions_,
            .tool = tool_ == nullptr ? 0 : tool_->number(),
            .move = name_of(motion)};
  of.is_turned = is_turned();
  const WorkFrame& frame = frame_of(of);
  const Vec3 from = frame.pose(at_).tip;
  of.cut.to = frame.pose(to).tip;
  if (along_ != nullptr) of.cut.to = frame.pose(along_->empty() ? at_ : along_->back()).tip;
  of.first = now_.sweeps.size();
  of.kind = of.cut.move == MoveName::rapid ? SweepKind::rapid : SweepKind::cut;
  const Spindles::Of spindle = of.is_turned ? Spindles::Of::work : Spindles::Of::tool;
  of.spindle = spindles_.turning(spindle);
  const motion::Feed* const feed = feed_of(motion);
  of.has_feed = feed != nullptr;
  if (of.has_feed) of.feed = *feed;
  // Where the tip is widest the speed of the surface is highest, and a turn is slowest.
  of.radius_mm = std::max(std::fabs(from.x), std::fabs(of.cut.to.x));
  const bool begins_wide = of.is_turned && std::fabs(from.x) > std::fabs(of.cut.to.x);
  if (of.spindle != Turning::stopped)
    of.rpm = motion::rpm_at(spindles_.told(spindle), begins_wide ? at_ : to);
  of.is_facing = std::fabs(of.cut.to.x - from.x) > std::fabs(of.cut.to.z - from.z);
  return of;
}

void Cutter::add_sweeps(const motion::Motion& motion, Waiting& of) {
  if (stuck_ || (of.cut.move == MoveName::probe && tool_->is_probe())) return;
  Sweep like{.axis = of.is_turned ? Vec3{0, 0, 1} : tool_->axis(),
             .body = body_of(*tool_),
             .kind = of.kind,
             .motion = static_cast<std::uint32_t>(motions_),
             .is_turned = of.is_turned};
  if (const auto* const thread = std::get_if<motion::Thread>(&motion.action)) {
    like.lead_mm = of.lead_mm = std::fabs(thread->lead);
    like.start_deg = thread->angle_deg;
    threads_.emplace(like.motion, ThreadBegin{motion.block, of.spindle});
  }
  add_ways(motion, like);
  if (settings_.end && motions_ == settings_.end->motion)
    shorten(now_.sweeps, of.first, settings_.end->share);
  const double longer = settings_.has_real_lengths ? too_long_mm(motion) : 0;
  for (std::size_t i = of.first; i < now_.sweeps.size() && !stuck_; ++i) {
    if (longer != 0 || lowered_mm_ != 0)
      lower(now_.sweeps[i], i == of.first ? lowered_mm_ : longer, longer);
    of.cut.length_mm += length(now_.sweeps[i].way);
    if (!model_.can_cut(now_.sweeps[i])) stuck_ = motion.block;
  }
  lowered_mm_ = longer;
  if (stuck_) return now_.sweeps.resize(of.first);
  of.cut.is_looked_at = true;
  if (tool_spans_.empty() || tool_spans_.back().tool != of.cut.tool)
    tool_spans_.push_back({like.motion, of.cut.tool});
  if (of.kind == SweepKind::cut) check_length(motion, of);
  if (of.kind == SweepKind::cut) check_pitch(of);
}

void Cutter::add_ways(const motion::Motion& motion, const Sweep& like) {
  const double reach = reach_of(tool_->body);
  const SweepMaker& maker = like.is_turned ? still_maker_ : maker_;
  TipPoint from = at_;
  if (along_ != nullptr) {
    for (const TipPoint& tip : *along_) {
      const double way = geometry::length(frame_.in_space(tip - from));
      const motion::Curve line =
          motion::Curve::line(from, tip, std::max(way, kShortest_mm), axis_count_);
      maker.add(from, line, like, reach, now_.sweeps);
      from = tip;
    }
    return;
  }
  for (const motion::Curve& curve : curves_.of(at_, motion)) {
    maker.add(from, curve, like, reach, now_.sweeps);
    from = curve.end();
  }
}

double Cutter::too_long_mm(const motion::Motion& motion) const {
  const auto length = tool_->tool.said(Measure::length);
  return length && !settings_.turns_work ? *length - motion.length.mm : 0;
}

void Cutter::check_length(const motion::Motion& motion, const Waiting& of) {
  const double longer = too_long_mm(motion);
  if (std::fabs(longer) <= kSameLength_mm || !wrong_lengths_.insert(of.cut.tool).second) return;
  const std::string offset = motion.length.mm == 0 && motion.length.offset == 0
                                 ? "no length offset is in force"
                                 : fmt::format("the length offset in force is {:.4g} mm (H{})",
                                               motion.length.mm, motion.length.offset);
  judge_.add({.code = Code::tool_length,
              .detail = fmt::format("T{} is {:.4g} mm long, and {}: its tip is {:.4g} mm {}",
                                    of.cut.tool, motion.length.mm + longer, offset,
                                    std::fabs(longer), longer > 0 ? "deeper" : "higher"),
              .block = motion.block,
              .tool = of.cut.tool,
              .motion = motions_,
              .at = of.cut.to,
              .depth_mm = std::max(0.0, longer)});
}

// A tap is judged where it stands in the stock: on its way there it may be fed as one likes.
void Cutter::check_pitch(const Waiting& of) {
  const auto pitch = tool_->tool.said(Measure::pitch);
  if (!pitch) return;
  double lead = of.lead_mm;
  double starts = 1;
  if (tool_->tool.kind == ToolKind::threading) {
    if (lead == 0) return;
    starts = std::max(1.0, std::round(lead / *pitch));  // each start has the pitch of the insert
  } else if (tool_->tool.kind == ToolKind::tap) {
    if (lead == 0 && of.rpm > 0 && of.has_feed && is_within(of.cut.to, settings_.stock)) {
      lead = motion::feed_per_minute(of.feed, of.cut.length_mm, of.rpm) / of.rpm;
    }
    if (lead == 0) return;
  } else {
    return;
  }
  if (std::fabs(lead - starts * *pitch) <= kSamePitch * starts * *pitch) return;
  judge_.add({.code = Code::thread_pitch,
              .detail = fmt::format("{:.4g} mm a turn, and T{} is for {:.4g} mm", lead, of.cut.tool,
                                    *pitch),
              .block = of.cut.block,
              .tool = of.cut.tool,
              .motion = of.cut.motion,
              .at = of.cut.to});
}

BodyId Cutter::body_of(const CuttingTool& tool) {
  const auto known = bodies_.find(tool.number());
  if (known != bodies_.end()) return known->second;
  beside_.await();
  if (settings_.watch != nullptr) settings_.watch->added(tool.body);
  return bodies_.emplace(tool.number(), model_.add_body(tool.body)).first->second;
}

void Cutter::finish() {
  cut_batch();
  beside_.await();
  settle_batch(before_);
}

// The middle of the ball goes straight wherever the tool does. A curve that turns is divided into
// equal shares.
std::optional<double> Cutter::touch(const TipPoint& from, const TipPoint& to) {
  finish();
  const bool has_ball = tool_ != nullptr && tool_->is_probe();
  const double radius = has_ball ? tool_->diameter_mm() / 2 : 0;
  motion::Motion move;
  move.action = motion::Probe{.to = to, .feed = {}};
  std::vector<Sweep> sweeps;
  Sweep like;
  if (tool_ != nullptr) like.axis = tool_->axis();
  for (const motion::Curve& curve : curves_.of(from, move))
    maker_.add(from, curve, like, radius, sweeps);
  const auto count = static_cast<double>(sweeps.size());
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    if (const auto t = first_touch(ball_of(sweeps[i], radius)))
      return (static_cast<double>(i) + *t) / count;
  }
  return std::nullopt;
}

std::optional<double> Cutter::first_touch(const BallWay& ball) const {
  std::optional<double> first = model_.first_touch(ball);
  for (const Obstacle* const obstacle : settings_.judge.obstacles) {
    const auto t = obstacle->first_touch(ball);
    if (t && (!first || *t < *first)) first = t;
  }
  return first;
}

void Cutter::cut_batch() {
  beside_.await();
  std::swap(now_, before_);
  before_.outcomes.assign(before_.sweeps.size(), Outcome{});
  if (settings_.cuts_beside) {
    beside_.begin(model_, before_.sweeps, before_.outcomes);
    settle_batch(now_);
    return;
  }
  model_.cut(before_.sweeps, before_.outcomes);
  if (settings_.watch != nullptr) settings_.watch->cut(before_.sweeps);
  settle_batch(before_);
}

void Cutter::settle_batch(Batch& batch) {
  for (const Waiting& of : batch.waiting) {
    if (of.end == of.first + 1) {  // nearly always; an outcome is large
      settle(batch, of, batch.outcomes[of.first]);
      continue;
    }
    Outcome sum;
    for (std::size_t i = of.first; i < of.end; ++i) sum.add(batch.outcomes[i]);
    settle(batch, of, sum);
  }
  batch.waiting.clear();
  batch.sweeps.clear();
  batch.outcomes.clear();
}

void Cutter::settle(const Batch& batch, const Waiting& waiting, const Outcome& outcome) {
  removed_ += outcome.removed;
  visited_ += outcome.visited;
  MotionCut cut = waiting.cut;
  if (waiting.end > waiting.first) {
    const std::size_t count = waiting.end - waiting.first;
    const std::span sweeps(batch.sweeps.data() + waiting.first, count);
    const std::span outcomes(batch.outcomes.data() + waiting.first, count);
    const CuttingTool& tool = rack_.tool(cut.tool);
    cut.has_findings = judge_.judge({.block = cut.block,
                                     .motion = cut.motion,
                                     .kind = waiting.kind,
                                     .spindle = waiting.spindle,
                                     .sweeps = sweeps,
                                     .outcomes = outcomes},
                                    tool, outcome);
    record(batch, waiting, outcome);
    if (waiting.kind == SweepKind::cut) {
      thread_watch_.take({.tool = tool,
                          .block = cut.block,
                          .motion = cut.motion,
                          .spindle = waiting.spindle,
                          .sweeps = sweeps,
                          .outcomes = outcomes});
    }
    cut.removed_mm3 = outcome.removed.value();
    cut.cuts = cut.removed_mm3 > kDust_mm3 || outcome.threaded.value() > kDust_mm3;
    if (settings_.cuts != nullptr && cut.removed_mm3 > kDust_mm3 && !outcome.has_contact())
      cut.data = data_of(batch, waiting, outcome);
  }
  if (settings_.cuts != nullptr) settings_.cuts->take(cut);
}

CuttingData Cutter::data_of(const Batch& batch, const Waiting& of, const Outcome& outcome) {
  bool is_axial = true;
  for (std::size_t i = of.first; is_axial && i < of.end; ++i)
    is_axial = !goes_across(batch.sweeps[i]);
  return cutting_data({.tool = rack_.tool(of.cut.tool),
                       .outcome = outcome,
                       .feed = of.feed,
                       .has_feed = of.has_feed,
                       .length_mm = of.cut.length_mm,
                       .grain_mm = model_.grain_mm(),
                       .rpm = of.rpm,
                       .turns_left = of.spindle == Turning::left,
                       .is_axial = is_axial,
                       .turns_work = of.is_turned,
                       .radius_mm = of.radius_mm,
                       .is_facing = of.is_facing,
                       .material = settings_.material});
}

void Cutter::record(const Batch& batch, const Waiting& of, const Outcome& outcome) {
  const auto same = [&](const ToolRecord& record) { return record.tool == of.cut.tool; };
  auto place = std::find_if(tools_.begin(), tools_.end(), same);
  if (place == tools_.end()) place = tools_.insert(place, ToolRecord{.tool = of.cut.tool});
  const bool removes = outcome.removed.value() > kDust_mm3 || outcome.threaded.value() > kDust_mm3;
  place->removed_mm3 += outcome.removed.value();
  if (of.kind == SweepKind::rapid) return;
  (removes ? place->cut_mm : place->air_mm) += of.cut.length_mm;
  bool& axial = axial_tools_.try_emplace(of.cut.tool, true).first->second;
  for (std::size_t i = of.first; axial && i < of.end; ++i) axial = !goes_across(batch.sweeps[i]);
  has_cut_ = has_cut_ || removes;
  for (std::size_t i = of.first; removes && i < of.end; ++i) {
    if (batch.outcomes[i].removed.value() + batch.outcomes[i].threaded.value() > kDust_mm3)
      place->lowest = std::min(place->lowest, bounds(batch.sweeps[i].way).low.z);
  }
}

}  // namespace kerf::stock
