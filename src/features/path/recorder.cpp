#include "features/path/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/decimal.hpp"
#include "geometry/arc.hpp"
#include "motion/plane_axes.hpp"
#include "motion/space_arc_path.hpp"
#include "motion/surface_path.hpp"

namespace kerf::features {
namespace {

// As the writers of rows divide an arc in space.
constexpr double kRowChord_mm = 0.001;

double length_of(const motion::AxisSetup& axes, const base::AxisVector& way) {
  double linear = 0;
  for (std::size_t i = 0; i < axes.count(); ++i) {
    if (!axes.axes[i].rotary) linear += way.values[i] * way.values[i];
  }
  return std::sqrt(linear);
}

}  // namespace

Recorder::Recorder(const motion::AxisSetup& axes, ModeSource& modes, std::size_t most_bytes)
    : axes_(axes),
      modes_(modes),
      most_bytes_(most_bytes),
      xyz_{axes.find('X'), axes.find('Y'), axes.find('Z')},
      at_(axes.start) {
  recording_.turns = axes.turns();
}

Vec3 Recorder::in_setup(const base::TipPoint& tip) const {
  const auto of = [&](std::size_t i) { return xyz_[i] ? tip[*xyz_[i]] : 0.0; };
  const Vec3 origin = recording_.setups[state_.setup].origin;
  return {base::tidy(of(0) - origin.x), base::tidy(of(1) - origin.y), base::tidy(of(2) - origin.z)};
}

base::AxisVector Recorder::rotary_of(const base::TipPoint& at) const {
  base::AxisVector rotary;
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    if (axes_.axes[i].rotary) rotary.values[i] = at.values[i];
  }
  return rotary;
}

bool Recorder::turns_rotary(const base::TipPoint& to) const {
  return !(rotary_of(to) == rotary_of(at_));
}

std::uint32_t Recorder::setup_at(const Modes& modes, const base::TipPoint& at) {
  const base::AxisVector rotary = rotary_of(at);
  auto& setups = recording_.setups;
  const auto found = std::find_if(setups.begin(), setups.end(), [&](const SetUp& setup) {
    return setup.zero == modes.zero && setup.origin == modes.origin && setup.rotary == rotary;
  });
  if (found != setups.end()) return static_cast<std::uint32_t>(found - setups.begin());
  setups.push_back({modes.zero, modes.origin, rotary});
  return static_cast<std::uint32_t>(setups.size() - 1);
}

// What is in force for the row that goes to `to`.
void Recorder::look(const base::TipPoint& to) {
  const Modes& modes = modes_.modes();
  const bool turns = turns_rotary(to);
  if (knows_modes_ && !turns && modes == known_) return;
  const std::uint32_t setup = setup_at(modes, to);
  const bool is_other = !knows_modes_ || setup != state_.setup;
  known_ = modes;
  knows_modes_ = true;
  state_.setup = setup;
  state_.compensation = modes.compensation;
  state_.beside = modes.beside;
  state_.cycle = modes.cycle;
  state_.frame = modes.frame;
  state_.is_incremental = modes.is_incremental;
  state_.unit_mm = modes.unit_mm;
  is_state_new_ = true;
  if (!is_other) return;
  if (recording_.moves.empty()) {
    recording_.start = in_setup(at_);
  } else {
    recording_.begins[recording_.count()] = in_setup(at_);
  }
}

void Recorder::set_feed(const motion::Feed& feed) {
  if (state_.feed.value == feed.value && state_.feed.mode == feed.mode) return;
  state_.feed = feed;
  is_state_new_ = true;
}

void Recorder::add(Move row, const base::TipPoint& to) {
  if (is_state_new_) recording_.states.push_back(state_);
  is_state_new_ = false;
  if (recording_.blocks.empty() || !(recording_.blocks.back() == block_))
    recording_.blocks.push_back(block_);
  row.to = in_setup(to);
  row.block = static_cast<std::uint32_t>(recording_.blocks.size() - 1);
  row.state = static_cast<std::uint32_t>(recording_.states.size() - 1);
  row.row = rows_++;
  recording_.moves.push_back(row);
  at_ = to;
}

void Recorder::add_other(double length, const base::TipPoint& to, std::uint32_t rows) {
  recording_.lengths.push_back(length);
  add({.shaped = static_cast<std::uint32_t>(recording_.lengths.size() - 1),
       .kind = Move::Kind::feed,
       .shape = Move::Shape::other},
      to);
  rows_ += rows - 1;
}

void Recorder::straight(Move::Kind kind, const base::TipPoint& to) {
  const bool turns = turns_rotary(to);
  look(to);
  if (!turns || kind == Move::Kind::rapid) return add({.kind = kind}, to);
  add_other(length_of(axes_, to - at_), to, 1);
}

void Recorder::move(const motion::Rapid& rapid) { straight(Move::Kind::rapid, rapid.to); }

void Recorder::move(const motion::Line& line) {
  set_feed(line.feed);
  straight(Move::Kind::feed, line.to);
}

void Recorder::move(const motion::Probe& probe) {
  set_feed(probe.feed);
  straight(Move::Kind::probe, probe.to);
}

void Recorder::move(const motion::Thread& thread) {
  is_state_new_ =
      is_state_new_ || state_.lead != thread.lead || state_.start_deg != thread.angle_deg;
  state_.lead = thread.lead;
  state_.start_deg = thread.angle_deg;
  straight(Move::Kind::thread, thread.to);
}

void Recorder::move(const motion::Arc& arc) {
  const auto plane = motion::plane_axes(arc.plane, axes_);
  if (!plane) return;
  set_feed(arc.feed);
  const bool turns = turns_rotary(arc.to);
  look(arc.to);
  const bool clockwise = arc.direction == motion::Direction::clockwise;
  const Vec2 centre{arc.center[0], arc.center[1]};
  const Vec2 from = plane->project(at_);
  const Vec2 to = plane->project(arc.to);
  if (turns || arc.plane != (recording_.turns ? motion::Plane::zx : motion::Plane::xy)) {
    const double rise = plane->normal ? arc.to[*plane->normal] - at_[*plane->normal] : 0;
    return add_other(
        math::hypot(geometry::arc_length(from, to, centre, clockwise, arc.turns, 0), rise), arc.to,
        1);
  }
  const double sweep = geometry::sweep_rad(from, to, centre, clockwise) +
                       2 * std::numbers::pi * static_cast<double>(arc.turns);
  const Vec3 origin = recording_.setups[state_.setup].origin;
  const Vec2 zero = recording_.flat(origin);
  recording_.arcs.push_back(
      {{base::tidy(centre.u - zero.u), base::tidy(centre.v - zero.v)}, clockwise ? -sweep : sweep});
  add({.shaped = static_cast<std::uint32_t>(recording_.arcs.size() - 1),
       .kind = Move::Kind::feed,
       .shape = Move::Shape::arc},
      arc.to);
}

void Recorder::move(const motion::SpaceArc& arc) {
  set_feed(arc.feed);
  look(arc.to);
  const motion::SpaceArcPath path(axes_, at_, arc);
  std::uint32_t rows = 0;
  path.chords(geometry::chord_angle_rad(path.circle().radius(), kRowChord_mm),
              [&](const base::TipPoint&) { ++rows; });
  add_other(path.circle().length(), arc.to, rows);
}

void Recorder::move(const motion::SurfaceMove& move) {
  set_feed(move.feed);
  std::uint32_t rows = 0;
  const motion::SurfacePath path(axes_, at_, move, [&](const motion::Curve&) { ++rows; });
  look(move.to);
  add_other(path.length(), move.to, rows);
}

void Recorder::note(const motion::ToolChange& change) {
  ++rows_;
  state_.tool = change.tool;
  is_state_new_ = true;
}

void Recorder::note(const motion::Spindle& spindle) {
  state_.spindle_rpm = spindle.known_rpm();
  state_.turning = spindle.turning;
  is_state_new_ = true;
}

void Recorder::take(const motion::Motion& motion) {
  if (most_bytes_ > 0 && recording_.bytes() > most_bytes_) return;
  block_ = motion.block;
  std::visit(
      [this](const auto& action) {
        if constexpr (requires { this->move(action); }) {
          this->move(action);
        } else if constexpr (requires { this->note(action); }) {
          this->note(action);
        }
      },
      motion.action);
}

}  // namespace kerf::features
