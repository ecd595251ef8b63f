#include "output/programs/post.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/decimal.hpp"
#include "motion/plane_axes.hpp"
#include "motion/surface_path.hpp"
#include "output/programs/internal/post_head.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::output {
namespace {

using namespace motion;

constexpr std::string_view kAlwaysSaid = "XYZ";

std::string beam_word(const machine::LaserSettings& laser, const Power& power) {
  const bool dynamic = laser.post_beam == machine::LaserSettings::Beam::dynamic;
  return dynamic || power.follows_speed ? "M4" : "M3";
}

// The axes that are written.
base::AxisSet said_axes(const AxisSetup& axes, const PostSettings& settings) {
  base::AxisSet said{};
  for (std::size_t i = 0; i < axes.count(); ++i) {
    const char letter = axes.axes[i].letter;
    const bool named = settings.axes ? settings.axes->find(letter) != std::string::npos
                                     : settings.flavour.has_rotary_axes;
    if (named || kAlwaysSaid.find(letter) != std::string_view::npos)
      said |= base::only(base::Axis{static_cast<std::uint8_t>(i)});
  }
  return said;
}

}  // namespace

Post::Post(const machine::MachineDefinition& machine, std::string program, base::OutputFile& file,
           const PostSettings& settings)
    : machine_(machine),
      axes_(machine.axes),
      laser_(machine.drive.laser),
      program_(std::move(program)),
      file_(file),
      flavour_(settings.flavour),
      said_(said_axes(axes_, settings)),
      body_(file, flavour_),
      moves_(axes_, body_, flavour_, said_),
      arcs_(moves_),
      tip_(axes_.start) {}

void Post::take(const Motion& motion) {
  if (ended_) return;
  source_line_ = motion.block.line;
  if (const base::TipPoint* const to = target_of(motion)) {
    tell_override(motion);
    set_length(motion.length);
    move(added_mm_ == 0 ? motion : beyond_tip(motion));
    tip_ = *to;
  } else {
    approaches_ = approaches_ && !first_;
    std::visit([this](const auto& action) { act(action); }, motion.action);
  }
}

// Blocks

void Post::end_block() {
  block(block_.text());
  block_.clear();
}

void Post::frequency(double hz, std::uint32_t line) {
  source_line_ = line;
  lose("frequency", "LASER FREQUENCY " + base::number_text(post_rounded(hz)) + " HZ");
}

// What the program says there and the flavour does not.
void Post::lose(const std::string& what, const std::string& text) {
  comment(text);
  lost_.add(what, source_line_);
}

// Of tapping, which goes with the spindle, and of #3004.
void Post::tell_override(const Motion& motion) {
  const bool fixed = motion.fixed_override && !std::holds_alternative<Rapid>(motion.action) &&
                     !std::holds_alternative<Thread>(motion.action) &&
                     !std::holds_alternative<Probe>(motion.action);
  if (fixed && !fixed_) lose("feed without override", "FEED WITHOUT OVERRIDE");
  fixed_ = fixed;
}

// Where the axes stand

void Post::move(const Motion& motion) {
  const bool rapid = std::holds_alternative<Rapid>(motion.action);
  const base::TipPoint from = beyond_tip(tip_);
  tell_axes(*target_of(motion));
  if (rapid && (!first_ || approaches_)) {
    place(*target_of(motion));
  } else if (!rapid) {
    stand();
  }
  approaches_ = approaches_ && rapid && turning_.empty();
  need(extent_of(axes_, from, motion));
  std::visit([this](const auto& action) { act(action); }, motion.action);
}

base::TipPoint Post::as_written(base::TipPoint point) const {
  if (left_out_mm_ != 0) point[*axes_.find('Z')] -= left_out_mm_;
  return point;
}

void Post::need(MotionExtent extent) {
  extent.low = as_written(extent.low);
  extent.high = as_written(extent.high);
  if (!travel_) travel_ = extent;
  travel_->reach(extent.low);
  travel_->reach(extent.high);
}

// Of a move along an axis that is not written.
void Post::tell_axes(const base::TipPoint& to) {
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    const base::Axis axis{static_cast<std::uint8_t>(i)};
    if (moves_.is_said(axis) || to[axis] == tip_[axis]) continue;
    const std::string letter(1, axes_[axis].letter);
    lose("axis " + letter, "AXIS " + letter + " TO " + post_number(post_rounded(to[axis])));
  }
}

// Every axis is brought there, whatever it says: another controller's stands elsewhere. Rapids one
// behind the other are one way there; a spindle that turns by then starts up on the rest of them.
void Post::place(const base::TipPoint& first) {
  begin_place();
  first_ = first;
  settle_length();
  moves_.stand_at(first);
  travel_.reset();
  need({first, first});
  if (const auto z = axes_.find('Z')) highest_mm_ = std::max(highest_mm_, first[*z]);
}

// Before spindle or beam are on, and before the first move.
void Post::begin_place() {
  if (!place_at_) place_at_ = body_.size();
}

// Where the tool of the run is: what is done there is a cut like others.
void Post::stand() {
  const base::TipPoint here = beyond_tip(tip_);
  if (first_) {
    travel(here);
  } else {
    place(here);
  }
  approaches_ = false;
}

// It is told when it becomes another one, and not each time that a return to reference takes it
// away and the next move has it again.
void Post::set_length(const ToolLength& length) {
  const bool is_none = length.mm == 0 && length.offset == 0;
  if (length == length_ || (is_none && length_.mm == 0 && length_.offset == 0)) return;
  length_ = length;
  const bool head = machine_.kinematics.kind == kinematics::Kind::head_ac;
  added_mm_ = head ? 0 : length.mm;
  if (control_has(length)) {
    lengths_.use_offset(length.offset, length.mm);
    const ControlLength now = by_control(length);
    left_out_mm_ = now.mm;
    moves_.put_on(now);
    return tell_length(flavour_.lengths == PostFlavour::Lengths::dynamic ? " IS OF G43.1"
                                                                         : " IS OF THE TABLE");
  }
  tell_length(head ? " IS NOT ADDED" : std::string(" IS ADDED TO ") + axes_[length.axis].letter);
}

void Post::tell_length(const std::string& where) {
  if (length_.mm == 0) return;
  std::string text = "TOOL " + std::to_string(tool_) + ", H" + std::to_string(length_.offset) +
                     ", LENGTH " + post_number(post_rounded(length_.mm)) + " MM" + where;
  if (text == told_length_) return;
  const bool is_lost = machine_.kinematics.kind == kinematics::Kind::head_ac;
  has_lengths_ = !is_lost;
  if (is_lost) lost_.add("tool length", source_line_);
  comment(text);
  told_length_ = std::move(text);
}

// Of Z, on a machine whose tip is where its axes are.
bool Post::control_has(const ToolLength& length) const {
  const auto z = axes_.find('Z');
  const bool is_of_z = z && (length.axis == *z || length.mm == 0);
  return is_of_z && flavour_.lengths != PostFlavour::Lengths::added &&
         machine_.kinematics.kind != kinematics::Kind::head_ac;
}

// G43.1 stays where no length is in force: its coordinates count from the first tool.
ControlLength Post::by_control(const ToolLength& length) const {
  const base::Axis z = *axes_.find('Z');
  if (flavour_.lengths == PostFlavour::Lengths::dynamic) {
    if (length.mm == 0) return {z, left_out_mm_, {}};
    return {z, length.mm,
            BlockText().code("G43.1").number('Z', post_rounded(length.mm - first_mm_)).text()};
  }
  if (length.mm == 0 && length.offset == 0) return {z, 0, "G49"};
  return {z, length.mm, "G43 H" + std::to_string(length.offset)};
}

// The path begins with it: behind the head no other one is in force.
void Post::settle_length() {
  const auto words = moves_.settle_length();
  first_mm_ = left_out_mm_;
  if (!words) return;
  first_words_ = flavour_.lengths == PostFlavour::Lengths::dynamic || *words == "G49" ? "" : *words;
}

base::TipPoint Post::beyond_tip(base::TipPoint tip) const {
  if (added_mm_ == 0) return tip;
  tip[length_.axis] = base::tidy(tip[length_.axis] + added_mm_);
  return tip;
}

Motion Post::beyond_tip(const Motion& motion) const {
  Motion beyond = motion;
  const auto shift = [this](auto& action) {
    if constexpr (requires { action.to; }) action.to = beyond_tip(action.to);
    if constexpr (requires { action.via; }) {
      action.via = beyond_tip(action.via);
      action.second_via = beyond_tip(action.second_via);
    }
    if constexpr (requires { action.center; }) {
      const auto plane = plane_axes(action.plane, axes_);
      if (plane && plane->first == length_.axis) action.center[0] += added_mm_;
      if (plane && plane->second == length_.axis) action.center[1] += added_mm_;
    }
  };
  std::visit(shift, beyond.action);
  return beyond;
}

// Without the beam. Where the tool became longer on the way the axis rises before the others move,
// where it became shorter it comes down behind them.
void Post::travel(const base::TipPoint& to) {
  if (moves_.is_at(to)) return moves_.rapid(to);  // what no digit shows
  const base::TipPoint& at = moves_.at();
  const bool burns = burns_now();
  if (burns) block("M5");
  const base::Axis axis = length_.axis;
  const bool is_new = post_rounded(at[axis]) != post_rounded(beyond_tip(tip_)[axis]);
  if (is_new || moves_.has_length_waiting()) bring_length(to);
  moves_.rapid(to);
  if (burns) block(turning_);
}

void Post::bring_length(base::TipPoint corner) {
  const base::Axis axis = length_.axis;
  const base::TipPoint& at = moves_.at();
  const double to_mm = corner[axis];
  const bool falls = to_mm < at[axis];
  if (!falls) {
    corner = at;
    moves_.say_length();
  }
  corner[axis] = std::max(to_mm, at[axis]);
  moves_.rapid(corner);
  moves_.say_length();
}

// Moves

// A taught point is gone to with the beam as it is; no posted rapid burns.
void Post::act(const Rapid& rapid) {
  if (burns_now()) lose("beam in a rapid", "RAPID WITHOUT THE BEAM");
  travel(rapid.to);
  if (const auto z = axes_.find('Z')) highest_mm_ = std::max(highest_mm_, rapid.to[*z]);
}

void Post::act(const Line& line) { moves_.straight(line.to, line.feed); }

void Post::act(const Arc& arc) { arcs_.write(arc); }

void Post::act(const SpaceArc& arc) { arcs_.write(arc); }

// Its curves are short: their ends.
void Post::act(const SurfaceMove& move) {
  std::vector<base::TipPoint> ends;
  const SurfacePath path(axes_, moves_.at(), move,
                         [&](const Curve& curve) { ends.push_back(curve.end()); });
  lose("move on a surface", "IN CHORDS");
  for (const base::TipPoint& to : ends) moves_.straight(to, move.feed);
}

void Post::act(const Probe& probe) {
  lose("probing move", "PROBING MOVE");
  moves_.straight(probe.to, probe.feed);
}

void Post::act(const Thread& thread) {
  lose("thread", "THREAD OF LEAD " + base::number_text(post_rounded(thread.lead)));
  moves_.straight(thread.to, {thread.lead, FeedMode::per_revolution});
}

// What is no move

// Its point says that P counts seconds: where it counts milliseconds, it has none. A beam that
// was turned on behind a rapid burns from G1 on.
void Post::act(const Dwell& dwell) {
  if (burns_now()) {
    stand();
    moves_.burn_here();
  }
  block_.code("G4");
  if (flavour_.dwell == PostFlavour::Dwell::milliseconds) {
    block_.count('P', std::ceil(post_rounded(dwell.seconds * 1000)));
  } else {
    block_.number('P', post_rounded(dwell.seconds));
  }
  end_block();
}

// M6 stops the spindle on many a control, and the program goes on with it.
void Post::act(const ToolChange& change) {
  tool_ = change.tool;
  lengths_.use_tool(change.tool);
  if (flavour_.changes_tools) {
    block("T" + std::to_string(change.tool) + " M6");
  } else {
    if (!turning_.empty()) block("M5");
    block("M0 (TOOL " + std::to_string(change.tool) + ")");
  }
  block(turning_);
}

// G96 stays what it is: its speed follows from where the tool stands.
void Post::act(const Spindle& spindle) {
  const bool turns = spindle.turns();
  const bool css = turns && spindle.mode == Spindle::Mode::constant_surface_speed;
  moves_.set_speed(css ? spindle.max_rpm : spindle.speed);
  turning_.clear();
  if (!turns) {
    if (place_at_) block("M5");  // before, the head has said it
    if (spindle.turning == Spindle::Turning::oriented) lose("spindle orientation", "M19");
    return;
  }
  begin_place();
  if (css && spindle.max_rpm > 0) {
    block_.code("G92").count('S', post_rounded(spindle.max_rpm));
    end_block();
  }
  BlockText on;
  on.code(spindle.turning == Spindle::Turning::clockwise ? "M3" : "M4");
  turning_ = on.count('S', post_rounded(spindle.speed)).text();
  if (css != css_) {
    block_.code(css ? "G96" : "G97");
    moves_.forget_feed();
  }
  css_ = css;
  block_.code(turning_);
  end_block();
}

void Post::act(const Coolant& coolant) {
  switch (coolant.state) {
    case Coolant::State::off: return block("M9");
    case Coolant::State::mist: return block("M7");
    case Coolant::State::flood: return block("M8");
  }
}

// A beam that is only set takes its power as S alone, once it is off.
void Post::act(const Power& power) {
  const double percent = post_rounded(power.beam_percent());
  if (!laser_.fitted()) {
    const std::string beam = percent > 0 ? base::number_text(percent) + " PERCENT" : "OFF";
    if (power.on || moves_.beam_on()) lose("laser", "LASER " + beam);
    moves_.set_beam(percent > 0);
    return;
  }
  const double s = post_rounded(power.percent / 100 * laser_.s_of_full_power);
  if (percent == 0 && moves_.beam_on()) block("M5");
  moves_.set_beam(percent > 0);
  if (percent > 0) {
    begin_place();
    if (power.follows_speed && !flavour_.has_following_beam)
      lose("power that follows the speed", "POWER FOLLOWS THE SPEED");
    block_.code(flavour_.has_following_beam ? beam_word(laser_, power) : "M3");
  }
  if (percent > 0 || (!power.on && s != s_)) block_.count('S', s_ = s);
  turning_ = percent > 0 ? block_.text() : std::string();
  end_block();
}

void Post::act(const AuxiliaryCode& code) {
  const std::string text = "M" + std::to_string(code.code);
  lose(text, text);
}

void Post::act(const Stop& stop) { block(stop.optional ? "M1" : "M0"); }

void Post::act(const Message& message) {
  lose("message", "MESSAGE " + std::string(message.text.view()));
}

void Post::act(const End& /*end*/) {
  if (!turning_.empty() && !flavour_.end.starts_with("M5")) block("M5");
  block(flavour_.end);
  ended_ = true;
}

void Post::finish() {
  if (!ended_) act(End{});
  const auto z = axes_.find('Z');
  Beginning beginning{axes_, flavour_, said_, first_.value_or(base::TipPoint()), 0, first_words_};
  if (z && first_) {
    beginning.first[*z] -= first_mm_;
    beginning.level_mm = highest_mm_ - first_mm_;
    base::TipPoint level = beginning.first;
    level[*z] = beginning.level_mm;
    travel_->reach(level);
  }
  file_.write(post_head({program_, machine_, flavour_, travel_, has_lengths_, lost_}));
  const std::uint64_t place_at = first_ ? *place_at_ : 0;
  body_.copy_to_output(0, place_at);
  if (first_) file_.write(positioning(beginning));
  body_.copy_to_output(place_at, body_.size());
  if (flavour_.is_framed) file_.write("%\n");
}

std::string Post::json() const { return JsonObject().raw("lost", lost_.json()).done(); }

}  // namespace kerf::output
