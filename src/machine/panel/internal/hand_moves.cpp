#include "machine/panel/internal/hand_moves.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/decimal.hpp"
#include "machine/dialect/refused.hpp"

namespace kerf::machine {

using base::Refusal;
namespace {

// How far an axis without an end of its travel goes in one go, mm or degrees.
constexpr double kFar = JogBy::kMostDistance;
// Ends of what a linkage reaches are found to this, mm or degrees.
constexpr double kReachPitch = 1e-3;

constexpr const char* kAllHome = "all axes are at their reference points";

}  // namespace

std::optional<base::Axis> HandMoves::find_axis(const MachineDefinition& definition,
                                               const std::string& name) {
  return name.size() == 1 ? definition.axes.find(name[0]) : std::nullopt;
}

double HandMoves::own_speed(const std::string& axis) const {
  const auto found = find_axis(definition_, axis);
  if (!found) return 0;
  return definition_.axes[*found].rotary ? settings_.jog_deg_min : settings_.jog_mm_min;
}

std::optional<base::Failure> HandMoves::keeps_from_hand() const {
  if (run_.is_resetting) return base::refuse(Refusal::resetting);
  if (run_.is_active()) return base::refuse(Refusal::moves_already);
  if (run_.machine().alarm() || console_.alarm()) return base::refuse(Refusal::alarm_is_on);
  if (run_.machine().is_in_program() && !run_.machine().control().can_be_moved())
    return base::refuse(run_.is_pattern() ? Refusal::pattern_counts : Refusal::corner_held);
  return std::nullopt;
}

std::optional<base::Failure> HandMoves::keeps_axis(const std::string& axis) const {
  if (mode_ != Mode::jog && mode_ != Mode::teach) return base::refuse(Refusal::hand_mode);
  if (!find_axis(definition_, axis)) return base::refuse(Refusal::no_hand_axis, {axis});
  return std::nullopt;
}

std::optional<base::Failure> HandMoves::objection(const Jog& key) const {
  if (auto why = keeps_axis(key.axis)) return why;
  if (!(std::fabs(key.speed_per_min) > 0) || !std::isfinite(key.speed_per_min))
    return base::refuse(Refusal::jog_speed);
  return keeps_from_hand();
}

std::optional<base::Failure> HandMoves::objection(const JogBy& key) const {
  if (auto why = keeps_axis(key.axis)) return why;
  if (key.distance == 0 || !std::isfinite(key.distance) || std::fabs(key.distance) > kFar)
    return base::Failure{base::Failure::Kind::usage,
                         "a jog by a distance needs one, at most " + base::number_text(kFar)};
  if (key.speed_per_min < 0 || !std::isfinite(key.speed_per_min))
    return base::refuse(Refusal::jog_speed);
  return keeps_from_hand();
}

std::optional<base::Failure> HandMoves::objection(const Home& /*key*/) const {
  if (mode_ != Mode::reference) return base::refuse(Refusal::reference_mode);
  return keeps_from_hand();
}

// How far the axis can go until the end of its travel. By hand that is an end in any case, as it is
// for a machine with limit switches: stroke_check is about programs.
double HandMoves::travel_left(base::Axis axis, bool up) const {
  const motion::AxisConfig& config = definition_.axes[axis];
  if (!(config.travel_min < config.travel_max)) return kFar;
  PacedRun& machine = run_.machine();
  const double at = machine.servo().commanded()[axis] + machine.control().tool_length()[axis];
  return std::max(0.0, up ? config.travel_max - at : at - config.travel_min);
}

// Of a linkage: how much of the move its joints can follow.
double HandMoves::reachable(const motion::Motion& whole, base::Axis axis, double distance,
                            std::optional<HandEnd>& end) {
  const auto part = [&](double way) {
    motion::Motion motion = whole;
    auto& line = std::get<motion::Line>(motion.action);
    line.to = run_.machine().servo().commanded();
    line.to[axis] += way;
    return motion;
  };
  auto refusal = run_.machine().objection(part(distance));
  if (!refusal) return distance;
  double good = 0;
  double bad = distance;
  while (std::fabs(bad - good) > kReachPitch) {
    const double middle = good + (bad - good) / 2;
    auto at_middle = run_.machine().objection(part(middle));
    (at_middle ? bad : good) = middle;
    if (at_middle) refusal = std::move(at_middle);
  }
  end = HandEnd{refusal->code, refusal->sentence};
  return good;
}

HandMoves::Outcome HandMoves::go(const Jog& key) {
  return go(*find_axis(definition_, key.axis), std::copysign(kFar, key.speed_per_min),
            std::fabs(key.speed_per_min));
}

HandMoves::Outcome HandMoves::go(const JogBy& key) {
  const base::Axis axis = *find_axis(definition_, key.axis);
  return go(axis, key.distance / definition_.axes[axis].count_per_mm(),
            key.speed_per_min > 0 ? key.speed_per_min : own_speed(key.axis));
}

HandMoves::Outcome HandMoves::go(base::Axis axis, double distance, double speed_per_min) {
  const bool up = distance > 0;
  const motion::AxisConfig& config = definition_.axes[axis];
  const double left = travel_left(axis, up);
  std::optional<HandEnd> end;
  if (left < std::fabs(distance)) {
    const double limit = up ? config.travel_max : config.travel_min;
    end = HandEnd{up ? base::Code::overtravel_plus : base::Code::overtravel_minus,
                  std::string(1, config.letter) + " is at its limit, " +
                      base::number_text(limit * config.count_per_mm())};
    distance = up ? left : -left;
  }
  motion::Motion move;
  motion::Line line{run_.machine().servo().commanded(),
                    {speed_per_min, motion::FeedMode::per_minute}};
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
  run_.hand_end = end;
  if (distance == 0) {
    run_.hand_end.reset();
    if (end) console_.raise(end->code, end->sentence);
    return {};
  }
  run_.is_jog_stopping = false;
  run_.begin_next(Activity::jog);
  return run_.move_by_hand({move});
}

void HandMoves::stop() {
  if (!run_.is(Activity::jog)) return;
  run_.is_jog_stopping = true;
  run_.hand_end.reset();
  run_.source().reset();
}

void HandMoves::finish_jog() {
  if (!std::exchange(run_.is_jog_stopping, false)) {
    static_cast<void>(run_.ended_early(console_));
    return;
  }
  run_.machine().drop_ahead();
  run_.hand_end.reset();
}

// Of a pattern.
HandMoves::Outcome HandMoves::bring_motors_home() {
  run_.trail().settle();
  if (run_.machine().command_way_to_start()) {
    run_.begin_next(Activity::home);
  } else {
    console_.say(kAllHome);
  }
  return {};
}

std::vector<motion::Motion> HandMoves::way_home() const {
  PacedRun& machine = run_.machine();
  const base::AxisVector length = machine.control().tool_length();
  base::TipPoint to = machine.servo().commanded();
  motion::Motion move;
  std::vector<motion::Motion> motions;
  const auto go = [&] {
    const base::TipPoint& from =
        motions.empty() ? machine.servo().commanded() : *motion::target_of(motions.back());
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
  return motions;
}

HandMoves::Outcome HandMoves::go(const Home& /*key*/) {
  run_.hand_end.reset();
  if (run_.is_behind_pattern()) return bring_motors_home();
  const std::vector<motion::Motion> motions = way_home();
  if (motions.empty()) {
    console_.say(kAllHome);
    return {};
  }
  run_.begin_next(Activity::home);
  return run_.move_by_hand(motions);
}

}  // namespace kerf::machine
