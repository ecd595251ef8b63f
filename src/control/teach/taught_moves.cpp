#include "control/teach/taught_moves.hpp"

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"
#include "geometry/space_arc.hpp"

namespace kerf::control {
namespace {

using base::Code;
using base::number_text;
using base::TipPoint;

constexpr std::array kLetters = {'X', 'Y', 'Z', 'A', 'C'};
// Beyond a limit by no more than this counts as on it, as with joints.
constexpr double kOnLimit = 1e-9;

std::array<double, kLetters.size()> values_of(const teach::Pose& pose) {
  return {pose.x, pose.y, pose.z, pose.a_deg, pose.c_deg};
}

std::string text_of(const teach::Radii& radii) {
  return number_text(radii.r_a_mm) + " " + number_text(radii.r_c_mm);
}

}  // namespace

TaughtMoves::TaughtMoves(const motion::AxisSetup& axes, Alarms& alarms, Assumptions& assumptions,
                         Outlet& outlet, const TaughtFor& machine)
    : axes_(axes),
      alarms_(alarms),
      assumptions_(assumptions),
      outlet_(outlet),
      machine_(machine),
      tip_(axes.start) {
  for (std::size_t i = 0; i < kLetters.size(); ++i) xyzac_[i] = axes.find(kLetters[i]);
}

void TaughtMoves::reset() {
  outlet_.reset();
  feed_ = 0;
  percent_ = 100;
  beam_ = false;
}

bool TaughtMoves::execute(const teach::Block& block, const base::BlockId& id) {
  block_ = &block;
  id_ = id;
  return std::visit([this](const auto& record) { return execute(record); }, block.record);
}

bool TaughtMoves::execute(const teach::Period& period) {
  if (period.milliseconds != machine_.period_ms && is_new(Assumed::taught_period))
    assume("PERIOD " + number_text(period.milliseconds) + ": the servo of this machine has " +
           number_text(machine_.period_ms) + " ms, which counts");
  return true;
}

bool TaughtMoves::execute(const teach::Radii& radii) {
  if (machine_.radii == radii || !is_new(Assumed::taught_radii)) return true;
  assume("RADII " + text_of(radii) +
         (machine_.radii
              ? ": the head of this machine has " + text_of(*machine_.radii) + ", which counts"
              : ": this machine has no such head"));
  return true;
}

bool TaughtMoves::execute(const teach::Point& point) {
  const auto to = target(point.to, 1);
  if (!to) return false;
  if (beam_ && *to != tip_ && is_new(Assumed::rapid_with_beam))
    assume("POINT moves at rapid while the beam is on");
  return move(motion::Rapid{*to, true});
}

bool TaughtMoves::execute(const teach::Feed& feed) {
  feed_ = feed.mm_per_min;
  return true;
}

bool TaughtMoves::execute(const teach::Laser& laser) {
  if (laser.on && !machine_.has_laser && is_new(Assumed::no_laser))
    assume("LASER ON: this machine has no laser");
  percent_ = laser.percent.value_or(percent_);
  beam_ = laser.on;
  return let_out(motion::Power{beam_ ? percent_ : 0});
}

bool TaughtMoves::execute(const teach::Line& line) {
  const auto to = target(line.to, 1);
  return to && move(motion::Line{*to, {feed_, motion::FeedMode::per_minute}});
}

bool TaughtMoves::execute(const teach::Arc& arc) {
  const auto via = target(arc.via, 1);
  if (!via) return false;
  const auto to = target(arc.to, 1 + kPoseWords);
  if (!to) return false;
  const motion::Feed feed{feed_, motion::FeedMode::per_minute};
  const geometry::Vec3 from{xyzac_[0] ? tip_[*xyzac_[0]] : 0, xyzac_[1] ? tip_[*xyzac_[1]] : 0,
                            xyzac_[2] ? tip_[*xyzac_[2]] : 0};
  if (geometry::SpaceArc::through(from, arc.via.focus(), arc.to.focus()))
    return move(motion::SpaceArc{.to = *to, .via = *via, .feed = feed});
  return move(motion::Line{*via, feed}) && move(motion::Line{*to, feed});
}

bool TaughtMoves::execute(const teach::Circle& circle) {
  const auto via = target(circle.via, 1);
  if (!via) return false;
  const auto second_via = target(circle.second_via, 1 + kPoseWords);
  if (!second_via) return false;
  return move(motion::SpaceArc{.to = tip_,
                               .via = *via,
                               .second_via = *second_via,
                               .feed = {feed_, motion::FeedMode::per_minute},
                               .full_circle = true},
              WithoutWay::is_a_circle);
}

bool TaughtMoves::execute(const teach::Dwell& dwell) {
  return let_out(motion::Dwell{dwell.seconds});
}

bool TaughtMoves::execute(const teach::End& /*end*/) {
  if (beam_ && !let_out(motion::Power{0})) return false;
  beam_ = false;
  return let_out(motion::End{});
}

// Where the axes stand at a taught point, whose first value is word number `word` of the record.
std::optional<TipPoint> TaughtMoves::target(const teach::Pose& pose, std::size_t word) {
  const auto values = values_of(pose);
  TipPoint to = tip_;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (xyzac_[i]) {
      if (!check(axes_[*xyzac_[i]], values[i], word + i)) return std::nullopt;
      to[*xyzac_[i]] = values[i];
    } else if (values[i] != 0) {
      raise(Code::teach_range, word + i,
            std::string(1, kLetters[i]) + " is " + number_text(values[i]) +
                ", but the machine has no such axis: there it can only be 0");
      return std::nullopt;
    }
  }
  return to;
}

bool TaughtMoves::check(const motion::AxisConfig& axis, double value, std::size_t word) {
  if (!(axis.travel_min < axis.travel_max)) return true;
  const bool low = value < axis.travel_min - kOnLimit;
  const bool high = value > axis.travel_max + kOnLimit;
  if (!low && !high) return true;
  if (axis.rotary)
    return raise(Code::joint_limit, word,
                 std::string(1, axis.letter) + " is " + number_text(value) +
                     " degrees, the axis turns from " + number_text(axis.travel_min) + " to " +
                     number_text(axis.travel_max));
  if (!machine_.checks_strokes) return true;
  return raise(low ? Code::overtravel_minus : Code::overtravel_plus, word,
               std::string(1, axis.letter) + " is " + number_text(value) + ", the limit " +
                   number_text(low ? axis.travel_min : axis.travel_max));
}

bool TaughtMoves::raise(Code code, std::size_t word, const std::string& detail) {
  base::Place place = alarms_.place();
  place.column = block_->words[word].column;
  place.length = block_->words[word].length;
  return alarms_.raise_at(code, place, detail);
}

bool TaughtMoves::move(const motion::Motion::Action& action, WithoutWay without_way) {
  const motion::Motion motion{.block = id_, .action = action};
  const TipPoint to = *motion::target_of(motion);
  if (to == tip_ && without_way == WithoutWay::is_nothing) return true;
  if (!outlet_.let_out(motion, tip_)) return false;
  tip_ = to;
  return true;
}

bool TaughtMoves::let_out(const motion::Motion::Action& action) {
  return outlet_.let_out({.block = id_, .action = action}, tip_);
}

}  // namespace kerf::control
