#include "output/programs/lathe_post.hpp"

#include <algorithm>
#include <vector>

#include "base/decimal.hpp"
#include "motion/surface_path.hpp"
#include "output/programs/internal/post_head.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::output {

using namespace motion;

LathePost::LathePost(const machine::MachineDefinition& machine, std::string program,
                     base::OutputFile& file, const PostSettings& settings)
    : machine_(machine),
      axes_(machine.axes),
      program_(std::move(program)),
      file_(file),
      flavour_(settings.flavour),
      body_(file, flavour_),
      moves_(axes_, body_, flavour_, static_cast<base::AxisSet>(-1)),
      arcs_(moves_),
      surfaces_(moves_, body_),
      tip_(axes_.start) {}

void LathePost::take(const Motion& motion) {
  if (ended_) return;
  source_line_ = motion.block.line;
  if (motion.length.mm != length_.mm) moves_.name(motion.length.axis);
  length_ = motion.length;
  if (target_of(motion) != nullptr) {
    move(motion);
  } else {
    std::visit([this](const auto& action) { act(action); }, motion.action);
  }
}

void LathePost::lose(const std::string& what, const std::string& text) {
  body_.comment(source_line_, text);
  lost_.add(what, source_line_);
}

void LathePost::frequency(double hz, std::uint32_t line) {
  source_line_ = line;
  lose("frequency", "LASER FREQUENCY " + base::number_text(post_rounded(hz)) + " HZ");
}

// Moves

void LathePost::move(const Motion& motion) {
  const base::TipPoint& to = *target_of(motion);
  bring_tool();
  begin();
  const bool fixed = motion.fixed_override && is_cut_at_feed(motion);
  if (fixed && !fixed_) lose("feed without override", "FEED WITHOUT OVERRIDE");
  fixed_ = fixed;
  const MotionExtent extent = extent_of(axes_, tip_, motion);
  if (!travel_) travel_ = extent;
  travel_->reach(extent.low);
  travel_->reach(extent.high);
  if (!std::holds_alternative<SurfaceMove>(motion.action)) surfaces_.leave();
  std::visit([this](const auto& action) { act(action); }, motion.action);
  tip_ = to;
}

// Behind the positioning the first move says every axis.
void LathePost::begin() {
  if (!place_at_) place_at_ = body_.size();
  if (corner_) return;
  corner_ = tip_;
  moves_.stand_at(tip_);
  for (std::size_t i = 0; i < axes_.count(); ++i)
    moves_.name(base::Axis{static_cast<std::uint8_t>(i)});
}

// X and Z at their largest.
void LathePost::reach(const base::TipPoint& corner) {
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    const base::Axis axis{static_cast<std::uint8_t>(i)};
    if (!axes_[axis].rotary) (*corner_)[axis] = std::max((*corner_)[axis], corner[axis]);
  }
}

void LathePost::act(const Rapid& rapid) {
  reach(rapid.to);
  moves_.rapid(rapid.to);
}

void LathePost::act(const SurfaceMove& move) {
  if (surfaces_.can_say(move)) return surfaces_.write(move);
  surfaces_.leave();
  in_chords(move);
}

void LathePost::in_chords(const SurfaceMove& move) {
  std::vector<base::TipPoint> ends;
  const SurfacePath path(axes_, moves_.at(), move,
                         [&](const Curve& curve) { ends.push_back(curve.end()); });
  lose("move on a face whose centre is not X0", "IN CHORDS, THE FEED IS THAT OF X");
  for (const base::TipPoint& to : ends) moves_.straight(to, move.feed);
}

void LathePost::act(const Probe& probe) {
  lose("probing move", "PROBING MOVE");
  moves_.straight(probe.to, probe.feed);
}

// What is no move

// X counts seconds everywhere, P does not.
void LathePost::act(const Dwell& dwell) {
  block(BlockText().code("G4").number('X', post_rounded(dwell.seconds)).text());
}

void LathePost::act(const ToolChange& change) {
  tool_ = change.tool;
  surfaces_.leave();
  bring_tool();
}

// Each number has the digits that the control takes for offsets.
void LathePost::bring_tool() {
  const std::pair now{tool_, length_.offset};
  if (now == brought_) return;
  surfaces_.leave();
  brought_ = now;
  std::string offset = std::to_string(now.second);
  const auto digits = static_cast<std::size_t>(machine_.parameters.tool_offset_digits);
  if (offset.size() < digits) offset.insert(0, digits - offset.size(), '0');
  const std::string tool = std::to_string(now.first);
  block("T" + (tool.size() < 2 ? "0" + tool : tool) + offset);
}

// G96 stays what it is: its speed follows from where the tool stands.
void LathePost::act(const Spindle& spindle) {
  surfaces_.leave();
  if (spindle.turns()) return turn(spindle);
  if (turns_) block("M5");
  turns_ = false;
  if (spindle.turning == Spindle::Turning::oriented) lose("spindle orientation", "M19");
}

void LathePost::turn(const Spindle& spindle) {
  const bool css = spindle.mode == Spindle::Mode::constant_surface_speed;
  if (!place_at_) place_at_ = body_.size();
  moves_.set_speed(css ? spindle.max_rpm : spindle.speed);
  if (css && spindle.max_rpm > 0)
    block(BlockText().code("G50").count('S', post_rounded(spindle.max_rpm)).text());
  BlockText on;
  if (css != css_) on.code(css ? "G96" : "G97");
  on.code(spindle.turning == Spindle::Turning::clockwise ? "M3" : "M4");
  block(on.count('S', post_rounded(spindle.speed)).text());
  css_ = css;
  turns_ = true;
}

void LathePost::act(const Coolant& coolant) {
  switch (coolant.state) {
    case Coolant::State::off: return block("M9");
    case Coolant::State::mist: return block("M7");
    case Coolant::State::flood: return block("M8");
  }
}

void LathePost::act(const Power& power) {
  if (power.beam_percent() > 0) lose("laser", "LASER");
}

void LathePost::act(const AuxiliaryCode& code) {
  const std::string text = "M" + std::to_string(code.code);
  lose(text, text);
}

void LathePost::act(const Message& message) {
  lose("message", "MESSAGE " + std::string(message.text.view()));
}

void LathePost::act(const End& /*end*/) {
  surfaces_.leave();
  if (turns_) block("M5");
  block(flavour_.end);
  ended_ = true;
}

void LathePost::finish() {
  if (!ended_) act(End{});
  if (travel_ && corner_) travel_->reach(*corner_);
  file_.write(lathe_head({program_, machine_, flavour_, travel_, false, lost_}));
  const std::uint64_t place_at = corner_ ? *place_at_ : 0;
  body_.copy_to_output(0, place_at);
  if (corner_) file_.write(lathe_positioning(axes_, flavour_, *corner_));
  body_.copy_to_output(place_at, body_.size());
  if (flavour_.is_framed) file_.write("%\n");
}

std::string LathePost::json() const { return JsonObject().raw("lost", lost_.json()).done(); }

}  // namespace kerf::output
