#include "output/programs/post.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/decimal.hpp"
#include "motion/feed.hpp"
#include "output/programs/internal/post_head.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::output {
namespace {

using namespace motion;

std::string beam_word(const machine::LaserSettings& laser, const Power& power) {
  const bool dynamic = laser.post_beam == machine::LaserSettings::Beam::dynamic;
  return dynamic || power.follows_speed ? "M4" : "M3";
}

}  // namespace

Post::Post(const machine::MachineDefinition& machine, std::string program, base::OutputFile& file)
    : machine_(machine),
      axes_(machine.axes),
      laser_(machine.drive.laser),
      program_(std::move(program)),
      file_(file),
      body_(file),
      at_(axes_.start),
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

void Post::block(std::string_view text) {
  if (text.empty()) return;
  body_.write(text);
  body_.write("\n");
}

void Post::comment(const std::string& text) {
  block("(LINE " + std::to_string(source_line_) + ": " + comment_text(text) + ")");
}

// What the program says there and plain G-code does not.
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
  if (rapid && (!first_ || approaches_)) {
    place(*target_of(motion));
  } else if (!rapid) {
    stand();
  }
  approaches_ = approaches_ && rapid && turning_.empty();
  const MotionExtent extent = extent_of(axes_, from, motion);
  travel_->reach(extent.low);
  travel_->reach(extent.high);
  std::visit([this](const auto& action) { act(action); }, motion.action);
}

// Every axis is brought there, whatever it says: another controller's stands elsewhere. Rapids one
// behind the other are one way there; a spindle that turns by then starts up on the rest of them.
void Post::place(const base::TipPoint& first) {
  begin_place();
  first_ = at_ = first;
  travel_ = {first, first};
  if (const auto z = axes_.find('Z')) highest_mm_ = std::max(highest_mm_, first[*z]);
  modal_ = "G0";
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
  if (length == length_) return;
  length_ = length;
  const bool head = machine_.kinematics.kind == kinematics::Kind::head_ac;
  added_mm_ = head ? 0 : length.mm;
  if (length.mm == 0) return;
  std::string text = "TOOL " + std::to_string(tool_) + ", H" + std::to_string(length.offset) +
                     ", LENGTH " + post_number(post_rounded(length.mm)) + " MM";
  text += head ? " IS NOT ADDED" : std::string(" IS ADDED TO ") + axes_[length.axis].letter;
  if (text == told_length_) return;
  has_lengths_ = !head;
  if (head) lost_.add("tool length", source_line_);
  comment(text);
  told_length_ = std::move(text);
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

bool Post::rounded_equal(const base::TipPoint& a, const base::TipPoint& b) const {
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    if (post_rounded(a.values[i]) != post_rounded(b.values[i])) return false;
  }
  return true;
}

// Without the beam. Where the tool became longer on the way the axis rises before the others move,
// where it became shorter it comes down behind them.
void Post::travel(const base::TipPoint& to) {
  if (rounded_equal(at_, to)) {
    at_ = to;
    return;
  }
  const bool burns = beam_on_ && laser_.fitted();
  if (burns) block("M5");
  const base::Axis axis = length_.axis;
  if (post_rounded(at_[axis]) != post_rounded(beyond_tip(tip_)[axis])) {
    base::TipPoint corner = to[axis] > at_[axis] ? at_ : to;
    corner[axis] = std::max(to[axis], at_[axis]);
    rapid(corner);
  }
  rapid(to);
  if (burns) block(turning_);
}

void Post::words(const char* code, const base::TipPoint& to) {
  if (modal_ != code) block_.code(code);
  modal_ = code;
  cuts_ = beam_on_ && modal_ != "G0";
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    const double value = post_rounded(to.values[i]);
    if (value != post_rounded(at_.values[i])) block_.number(axes_.axes[i].letter, value);
  }
  at_ = to;
}

void Post::rapid(const base::TipPoint& to) {
  if (!rounded_equal(at_, to)) words("G0", to);
  end_block();
  at_ = to;
}

// Moves

// A taught point is gone to with the beam as it is; no posted rapid burns.
void Post::act(const Rapid& rapid) {
  if (beam_on_ && laser_.fitted()) lose("beam in a rapid", "RAPID WITHOUT THE BEAM");
  travel(rapid.to);
  if (const auto z = axes_.find('Z')) highest_mm_ = std::max(highest_mm_, rapid.to[*z]);
}

void Post::feed(double per_minute) {
  if (per_minute == feed_) return;
  feed_ = per_minute;
  block_.number('F', per_minute);
}

// Nothing where the output's digits show no way.
void Post::line(const base::TipPoint& to, double per_minute) {
  if (rounded_equal(at_, to)) {
    at_ = to;
    return;
  }
  words("G1", to);
  feed(per_minute);
  end_block();
}

void Post::straight(const base::TipPoint& to, const Feed& rate) {
  double squares = 0;
  for (std::size_t i = 0; i < axes_.count(); ++i)
    squares += (to.values[i] - at_.values[i]) * (to.values[i] - at_.values[i]);
  line(to, post_rounded(motion::feed_per_minute(rate, std::sqrt(squares), speed_rpm_)));
}

void Post::act(const Line& line) { straight(line.to, line.feed); }

void Post::act(const Probe& probe) {
  lose("probing move", "PROBING MOVE");
  straight(probe.to, probe.feed);
}

void Post::act(const Thread& thread) {
  lose("thread", "THREAD OF LEAD " + base::number_text(post_rounded(thread.lead)));
  straight(thread.to, {thread.lead, FeedMode::per_revolution});
}

// What is no move

// Its point says that P counts seconds: where it counts milliseconds, it may have none. A beam that
// was turned on behind a rapid burns from G1 on.
void Post::act(const Dwell& dwell) {
  const bool burns = beam_on_ && laser_.fitted();
  if (burns) stand();
  if (burns && !cuts_) {
    modal_ = "G1";
    block_.code(modal_);
    if (feed_ < 0) feed(1);  // many a control takes no G1 before any F
    end_block();
  }
  cuts_ = beam_on_;
  block_.code("G4").number('P', post_rounded(dwell.seconds));
  end_block();
}

// M6 stops the spindle on many a control, and the program goes on with it.
void Post::act(const ToolChange& change) {
  tool_ = change.tool;
  block("T" + std::to_string(change.tool) + " M6");
  block(turning_);
}

// G96 stays what it is: its speed follows from where the tool stands.
void Post::act(const Spindle& spindle) {
  const bool turns = spindle.turns();
  const bool css = turns && spindle.mode == Spindle::Mode::constant_surface_speed;
  speed_rpm_ = css ? spindle.max_rpm : spindle.speed;
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
    feed_ = -1;
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
    if (power.on || beam_on_) lose("laser", "LASER " + beam);
    beam_on_ = percent > 0;
    return;
  }
  const double s = post_rounded(power.percent / 100 * laser_.s_of_full_power);
  if (percent == 0 && beam_on_) block("M5");
  beam_on_ = percent > 0;
  cuts_ = cuts_ && beam_on_;
  if (beam_on_) {
    begin_place();
    block_.code(beam_word(laser_, power));
  }
  if (beam_on_ || (!power.on && s != s_)) block_.count('S', s_ = s);
  turning_ = beam_on_ ? block_.text() : std::string();
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
  if (!turning_.empty()) block("M5");
  block("M30");
  ended_ = true;
}

void Post::finish() {
  if (!ended_) act(End{});
  if (const auto z = axes_.find('Z'); z && first_) {
    base::TipPoint level = *first_;
    level[*z] = highest_mm_;
    travel_->reach(level);
  }
  file_.write(post_head({program_, machine_, travel_, has_lengths_, lost_}));
  const std::uint64_t place_at = first_ ? *place_at_ : 0;
  body_.copy_to_output(0, place_at);
  if (first_) file_.write(positioning(axes_, *first_, highest_mm_));
  body_.copy_to_output(place_at, body_.size());
}

std::string Post::remark() const {
  if (lost_.count() == 0) return {};
  return "  --post: what plain G-code cannot say is in " + std::to_string(lost_.count()) +
         (lost_.count() == 1 ? " comment" : " comments") + ", the first one of line " +
         std::to_string(lost_.kinds().front().line) + "\n";
}

std::string Post::json() const { return JsonObject().raw("lost", lost_.json()).done(); }

}  // namespace kerf::output
