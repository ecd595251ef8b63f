// Axes moved by hand: jog and reference return, through the interpolator and its limits.
#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "machine/dialect/refused.hpp"
#include "machine/panel/internal/live_core.hpp"

namespace kerf::machine {

using base::Refusal;
namespace {

// How far an axis without an end of its travel goes in one go, mm or degrees.
constexpr double kFar = 36000;
// Ends of what a linkage reaches are found to this, mm or degrees.
constexpr double kReachPitch = 1e-3;

}  // namespace

std::optional<base::Axis> LiveCore::find_axis(const std::string& name) const {
  return name.size() == 1 ? definition_.axes.find(name[0]) : std::nullopt;
}

std::optional<base::Failure> LiveCore::keeps_from_hand() const {
  if (resetting_) return base::refuse(Refusal::resetting);
  if (is_active()) return base::refuse(Refusal::moves_already);
  if (machine_->alarm() || panel_alarm_) return base::refuse(Refusal::alarm_is_on);
  if (machine_->is_in_program() && !machine_->control().can_be_moved())
    return base::refuse(is_pattern() ? Refusal::pattern_counts : Refusal::corner_held);
  return std::nullopt;
}

LiveCore::Outcome LiveCore::queue_moves(const std::vector<motion::Motion>& motions) {
  trail_->settle();
  bool any = false;
  for (const motion::Motion& motion : motions) {
    if (const auto refusal = machine_->command(motion)) {
      if (!any) activity_ = Activity::none;
      if (!any)
        return refused(base::refuse_for(std::string(base::text_of(refusal->code).number),
                                        Refusal::joints_cannot, {refusal->sentence}));
      jog_end_ = JogEnd{refusal->code, refusal->sentence};
      break;
    }
    any = true;
  }
  deadline_s_ = time_s();
  machine_->finish_moves();
  return {};
}

LiveCore::Outcome LiveCore::jog(const std::string& axis, double speed_per_min) {
  const auto found = find_axis(axis);
  if (panel_.mode != Mode::jog && panel_.mode != Mode::teach) return refused(Refusal::hand_mode);
  if (!found) return refused(Refusal::no_hand_axis, {axis});
  if (!(std::fabs(speed_per_min) > 0) || !std::isfinite(speed_per_min))
    return refused(Refusal::jog_speed);
  if (const auto why = keeps_from_hand()) return refused(*why);
  return jog_to(*found, std::copysign(kFar, speed_per_min), std::fabs(speed_per_min));
}

LiveCore::Outcome LiveCore::jog_by(const std::string& axis, double distance, double speed_per_min) {
  const auto found = find_axis(axis);
  if (panel_.mode != Mode::jog && panel_.mode != Mode::teach) return refused(Refusal::hand_mode);
  if (!found) return refused(Refusal::no_hand_axis, {axis});
  if (distance == 0 || !std::isfinite(distance) || std::fabs(distance) > kFar)
    return refused("a jog by a distance needs one, at most " + base::number_text(kFar));
  if (speed_per_min < 0 || !std::isfinite(speed_per_min)) return refused(Refusal::jog_speed);
  if (const auto why = keeps_from_hand()) return refused(*why);
  const double own = definition_.axes[*found].rotary ? settings_.jog_deg_min : settings_.jog_mm_min;
  return jog_to(*found, distance, speed_per_min > 0 ? speed_per_min : own);
}

// How far the axis can go until the end of its travel. By hand that is an end in any case, as it is
// for a machine with limit switches: stroke_check is about programs.
double LiveCore::travel_left(base::Axis axis, bool up) const {
  const motion::AxisConfig& config = definition_.axes[axis];
  if (!(config.travel_min < config.travel_max)) return kFar;
  const double at = machine_->servo().commanded()[axis] + machine_->control().tool_length()[axis];
  return std::max(0.0, up ? config.travel_max - at : at - config.travel_min);
}

// Of a linkage: how much of the move its joints can follow.
double LiveCore::reachable(const motion::Motion& whole, base::Axis axis, double distance,
                           std::optional<JogEnd>& end) {
  const auto part = [&](double way) {
    motion::Motion motion = whole;
    auto& line = std::get<motion::Line>(motion.action);
    line.to = machine_->servo().commanded();
    line.to[axis] += way;
    return motion;
  };
  auto refusal = machine_->objection(part(distance));
  if (!refusal) return distance;
  double good = 0;
  double bad = distance;
  while (std::fabs(bad - good) > kReachPitch) {
    const double middle = good + (bad - good) / 2;
    auto at_middle = machine_->objection(part(middle));
    (at_middle ? bad : good) = middle;
    if (at_middle) refusal = std::move(at_middle);
  }
  end = JogEnd{refusal->code, refusal->sentence};
  return good;
}

// The motors that count a pattern are left to the interpolator.
void LiveCore::take_in_hand() {
  if (!would_begin_by_hand()) return;
  begin_anew();
  static_cast<void>(open_program());
}

LiveCore::Outcome LiveCore::jog_to(base::Axis axis, double distance, double speed_per_min) {
  take_in_hand();
  const bool up = distance > 0;
  const motion::AxisConfig& config = definition_.axes[axis];
  const double left = travel_left(axis, up);
  std::optional<JogEnd> end;
  if (left < std::fabs(distance)) {
    const double limit = up ? config.travel_max : config.travel_min;
    end = JogEnd{up ? base::Code::overtravel_plus : base::Code::overtravel_minus,
                 std::string(1, config.letter) + " is at its limit, " + base::number_text(limit)};
    distance = up ? left : -left;
  }
  motion::Motion move;
  motion::Line line{machine_->servo().commanded(), {speed_per_min, motion::FeedMode::per_minute}};
  line.to[axis] += distance;
  move.action = line;
  if (definition_.axes.linked && distance != 0) {
    constexpr double kTheNextOne = 2000;  // a linkage has no farther point
    const double tried = std::clamp(distance, -kTheNextOne, kTheNextOne);
    const double reached = reachable(move, axis, tried, end);
    line.to[axis] += reached - distance;
    move.action = line;
    distance = reached;
  }
  jog_end_ = end;
  if (distance == 0) {
    jog_end_.reset();
    if (end) raise_panel(end->code, end->sentence);
    return {};
  }
  stopping_jog_ = false;
  activity_ = Activity::jog;
  ++run_;
  return queue_moves({move});
}

LiveCore::Outcome LiveCore::jog_stop() {
  if (activity_ != Activity::jog) return {};
  stopping_jog_ = true;
  jog_end_.reset();
  machine_->servo().source().reset();
  return {};
}

// Of a pattern.
LiveCore::Outcome LiveCore::home_motors() {
  trail_->settle();
  if (!machine_->command_way_to_start()) {
    say("all axes are at their reference points");
    return {};
  }
  deadline_s_ = time_s();
  activity_ = Activity::home;
  ++run_;
  return {};
}

LiveCore::Outcome LiveCore::home() {
  if (panel_.mode != Mode::reference) return refused(Refusal::reference_mode);
  if (const auto why = keeps_from_hand()) return refused(*why);
  jog_end_.reset();
  if (would_begin_by_hand()) return home_motors();
  const base::AxisVector length = machine_->control().tool_length();
  base::TipPoint to = machine_->servo().commanded();
  motion::Motion move;
  std::vector<motion::Motion> motions;
  const auto go = [&] {
    const base::TipPoint& from =
        motions.empty() ? machine_->servo().commanded() : *motion::target_of(motions.back());
    if (to == from) return;
    move.action = motion::Rapid{to, true};
    motions.push_back(move);
  };
  const auto send = [&](base::Axis axis) {
    to[axis] = definition_.axes[axis].reference[0] - length[axis];
  };
  if (const auto z = definition_.axes.find('Z')) send(*z);
  go();
  for (std::size_t i = 0; i < definition_.axes.count(); ++i)
    send(base::Axis{static_cast<std::uint8_t>(i)});
  go();
  if (motions.empty()) {
    say("all axes are at their reference points");
    return {};
  }
  activity_ = Activity::home;
  ++run_;
  return queue_moves(motions);
}

}  // namespace kerf::machine
