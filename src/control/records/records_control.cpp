#include "control/records/records_control.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/decimal.hpp"
#include "geometry/space_arc.hpp"
#include "motion/radius_change.hpp"
#include "motion/surface_path.hpp"
#include "motion/thread_speed.hpp"

namespace kerf::control {
namespace {

using base::Code;
using vm::Verdict;

constexpr double kNoRadius_mm = 1e-9;

double place_on(char letter, const motion::AxisSetup& axes, const base::TipPoint& tip) {
  const auto axis = axes.find(letter);
  return axis ? tip[*axis] : 0.0;
}

geometry::Vec3 place_in(const motion::AxisSetup& axes, const base::TipPoint& tip) {
  return {place_on('X', axes, tip), place_on('Y', axes, tip), place_on('Z', axes, tip)};
}

Code code_of(geometry::NoArc why) {
  return why == geometry::NoArc::coincident ? Code::arc_coincident : Code::arc_collinear;
}

bool is_straight(const motion::Motion& motion) {
  return std::holds_alternative<motion::Rapid>(motion.action) ||
         std::holds_alternative<motion::Line>(motion.action);
}

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

RecordsControl::RecordsControl(const motion::AxisSetup& axes, const RecordedFor& machine,
                               records::RecordsLibrary& library, Memory& memory,
                               Surroundings& surroundings, motion::MotionSink& sink)
    : RecordControl(library, sink),
      axes_(axes),
      machine_(machine),
      memory_(memory),
      strokes_(axes, machine_.checks_strokes, &length_),
      outlet_(alarms_, surroundings,
              axes.linked ? Outlet::Machine::is_asked : Outlet::Machine::makes_all, &strokes_,
              sink),
      tip_(axes.start) {}

void RecordsControl::start(std::string name) {
  outlet_.reset();
  put_on({});
  stand_at_head(records::RecordsLibrary::kProgram, std::move(name));
}

void RecordsControl::reset() {
  RecordControl::reset();
  outlet_.reset();
  put_on({});
}

// The axes stay: it is the tip that is elsewhere then.
void RecordsControl::put_on(const motion::ToolLength& length) {
  tool_length_ = length;
  length_ = {};
  length_[length.axis] = length.mm;
}

void RecordsControl::tell(const std::string& unknown) {
  if (unknown.empty() || unknown_.size() >= kMostUnknown || has(unknown_, unknown)) return;
  unknown_.push_back(unknown);
  assumptions_.add(place().line, "member " + unknown + " means nothing in a motion record");
}

// As its program has measured it.
void RecordsControl::set(const records::ToolRadius& radius) {
  const bool turns = axes_.turns();
  if (radius.number >= (turns ? memory_.turning.size() : memory_.tools.size())) return;
  (turns ? memory_.turning[radius.number].geometry.radius
         : memory_.tools[radius.number].radius_geometry) = radius.geometry_mm;
  (turns ? memory_.turning[radius.number].wear.radius : memory_.tools[radius.number].radius_wear) =
      radius.wear_mm;
  ++memory_.revision;
}

bool RecordsControl::is_arc(const motion::Arc& arc, const records::RecordBlock& record) {
  const motion::PlaneAxes plane = *motion::plane_axes(arc.plane, axes_);
  const geometry::Vec2 about{arc.center[0], arc.center[1]};
  const double begin = length(plane.project(tip_) - about);
  const double end = length(plane.project(arc.to) - about);
  const bool is_one =
      record.is_spiral || motion::radius_change(plane, tip_, arc) <= motion::kSameRadius_mm;
  if (is_one && begin > kNoRadius_mm) return true;
  return alarms_.raise(Code::motion_radii, record.centre,
                       "it begins " + base::number_text(base::tidy(begin)) +
                           " mm from its centre and ends " + base::number_text(base::tidy(end)) +
                           " mm from it");
}

bool RecordsControl::is_arc(const motion::SpaceArc& arc) {
  const geometry::Vec3 from = place_in(axes_, tip_);
  const geometry::Vec3 via = place_in(axes_, arc.via);
  const geometry::Vec3 last = place_in(axes_, arc.full_circle ? arc.second_via : arc.to);
  const auto circle = arc.full_circle ? geometry::SpaceArc::circle(from, via, last)
                                      : geometry::SpaceArc::through(from, via, last);
  return circle || alarms_.raise(code_of(circle.error()));
}

bool RecordsControl::is_arc(const motion::SurfaceMove& move) {
  const geometry::Vec2 from = motion::flat_of(move.surface, tip_);
  if (!move.is_arc || length(from - geometry::Vec2{move.about[0], move.about[1]}) > kNoRadius_mm)
    return true;
  return alarms_.raise(Code::motion_radii, "it begins at its centre");
}

bool RecordsControl::is_thread(const motion::Thread& thread) {
  const bool is_endless = std::isinf(motion::ThreadWay(thread, tip_, axes_).revolutions());
  return !is_endless || alarms_.raise(Code::thread_lead_negative);
}

bool RecordsControl::is_made(const records::RecordBlock& record) {
  const auto& action = record.motion.action;
  if (const auto* const arc = std::get_if<motion::Arc>(&action)) return is_arc(*arc, record);
  if (const auto* const arc = std::get_if<motion::SpaceArc>(&action)) return is_arc(*arc);
  if (const auto* const move = std::get_if<motion::SurfaceMove>(&action)) return is_arc(*move);
  const auto* const thread = std::get_if<motion::Thread>(&action);
  return thread == nullptr || is_thread(*thread);
}

bool RecordsControl::goes_nowhere(const motion::Motion& motion) const {
  const base::TipPoint* const to = motion::target_of(motion);
  return is_straight(motion) && *to == tip_;
}

// Its block is a place of this file, in which the line is that of the program it comes from.
motion::Motion RecordsControl::as_made(const records::RecordBlock& record) {
  motion::Motion motion = record.motion;
  const base::BlockId here = block();
  motion.block.from = here.from + (motion.block.column > 0 ? motion.block.column - 1 : 0);
  motion.block.length = here.length;
  motion.length = tool_length_;
  if (auto* const spindle = std::get_if<motion::Spindle>(&motion.action)) {
    if (spindle->mode == motion::Spindle::Mode::constant_surface_speed)
      spindle->most_rpm = machine_.most_rpm[index(spindle->name)];
  } else if (auto* const stop = std::get_if<motion::Stop>(&motion.action)) {
    stop->passed = stop->passed && !optional_stop_;
  }
  return motion;
}

Verdict RecordsControl::behind(const motion::Motion& motion) {
  if (const auto* const stop = std::get_if<motion::Stop>(&motion.action)) {
    if (!stop->optional) return halt_with(Halt::program_stop, Verdict::pause);
    if (optional_stop_) return halt_with(Halt::optional_stop, Verdict::pause);
  }
  if (std::holds_alternative<motion::End>(motion.action))
    return halt_with(Halt::end, Verdict::stop);
  return behind_record();
}

// vm::Host

Verdict RecordsControl::execute(const vm::CodePage& page, std::uint32_t block,
                                const double* /*registers*/) {
  const records::RecordBlock& record = static_cast<const records::RecordPage&>(page).blocks[block];
  ++blocks_;
  tell(record.unknown);
  if (!is_made(record)) return Verdict::stop;
  if (record.length) put_on(*record.length);
  for (const records::ToolRadius& radius : record.radii) set(radius);
  const motion::Motion motion = as_made(record);
  if (goes_nowhere(motion)) return behind_record();
  if (!outlet_.let_out(motion, tip_)) return Verdict::stop;
  if (const base::TipPoint* const to = motion::target_of(motion)) tip_ = *to;
  return behind(motion);
}

}  // namespace kerf::control
