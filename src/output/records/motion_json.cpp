#include "output/records/motion_json.hpp"

#include <nlohmann/json.hpp>

#include "base/decimal.hpp"
#include "base/program_name.hpp"
#include "geometry/angle.hpp"
#include "motion/plane_axes.hpp"
#include "motion/radius_change.hpp"
#include "motion/space_arc_path.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::output {
namespace {

using namespace motion;

void append_vector(std::string& out, const char* name, geometry::Vec3 vector) {
  out += name;
  base::append_number(out, base::tidy(vector.x));
  out += ',';
  base::append_number(out, base::tidy(vector.y));
  out += ',';
  base::append_number(out, base::tidy(vector.z));
  out += ']';
}

void append_member(std::string& out, const char* name, double value) {
  out += name;
  base::append_number(out, value);
}

const char* plane_name(Plane plane) {
  switch (plane) {
    case Plane::xy: return "XY";
    case Plane::zx: return "ZX";
    case Plane::yz: return "YZ";
  }
  return "";
}

const char* turning_name(Spindle::Turning turning) {
  switch (turning) {
    case Spindle::Turning::clockwise: return "cw";
    case Spindle::Turning::counterclockwise: return "ccw";
    case Spindle::Turning::stopped: return "stop";
    case Spindle::Turning::oriented: return "orient";
  }
  return "";
}

const char* coolant_name(Coolant::State state) {
  switch (state) {
    case Coolant::State::off: return "off";
    case Coolant::State::mist: return "mist";
    case Coolant::State::flood: return "flood";
  }
  return "";
}

const char* feed_mode_name(FeedMode mode) {
  switch (mode) {
    case FeedMode::per_minute: return "per-minute";
    case FeedMode::per_revolution: return "per-revolution";
    case FeedMode::inverse_time: return "inverse-time";
  }
  return "";
}

// No length is the same on every axis.
bool is_same(const ToolLength& a, const ToolLength& b) {
  const bool none = a.mm == 0 && a.offset == 0 && b.mm == 0 && b.offset == 0;
  return none || a == b;
}

}  // namespace

MotionJson::MotionJson(const AxisSetup& axes, const base::SourceSet* sources,
                       base::OutputFile& file, Origin origin)
    : axes_(axes),
      sources_(sources),
      file_(file),
      at_(axes.start),
      title_(std::move(origin.title)) {
  if (origin.memory != nullptr) radii_.emplace(*origin.memory, axes.turns());
  for (const AxisConfig& axis : axes.axes) {
    keys_.push_back(std::string(keys_.empty() ? "\"" : ",\"") + axis.letter + "\":");
  }
}

void MotionJson::name_file(base::FileId id) {
  constexpr base::FileId kMain{0};
  source_id_ = id;
  source_.clear();
  if (id == kMain || sources_ == nullptr || !sources_->contains(id)) return;
  source_ = ",\"file\":" + quoted((*sources_)[id].name());
}

void MotionJson::name_source(base::ProgramNumber first) {
  const std::string name = base::program_name(static_cast<std::uint32_t>(first));
  if (!title_->empty() && *title_ != name) line_ += ",\"source\":" + output::quoted(*title_);
  title_.reset();
}

void MotionJson::begin(const char* kind, const Motion& motion) {
  if (motion.block.program != program_number_) {
    program_number_ = motion.block.program;
    program_ = "\",\"program\":\"" +
               base::program_name(static_cast<std::uint32_t>(motion.block.program)) +
               "\",\"line\":";
  }
  line_ = "{\"kind\":\"";
  line_ += kind;
  line_ += program_;
  base::append_integer(line_, motion.block.line);
  if (motion.block.column > 0) {
    line_ += ",\"column\":";
    base::append_integer(line_, motion.block.column);
  }
  if (motion.block.file != source_id_) name_file(motion.block.file);
  line_ += source_;
  if (title_) name_source(motion.block.program);
}

void MotionJson::point(const char* name, const base::TipPoint& at) {
  line_ += name;
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    line_ += keys_[i];
    base::append_number(line_, at.values[i] * axes_.axes[i].count_per_mm());
  }
  line_ += '}';
}

void MotionJson::centre(const Arc& arc) {
  const auto plane = plane_axes(arc.plane, axes_);
  append_member(line_, "\",\"center\":[",
                arc.center[0] * (plane ? axes_[plane->first].count_per_mm() : 1));
  append_member(line_, ",", arc.center[1] * (plane ? axes_[plane->second].count_per_mm() : 1));
}

bool MotionJson::is_spiral(const Arc& arc) const {
  const auto plane = plane_axes(arc.plane, axes_);
  return plane && radius_change(*plane, at_, arc) > kSameRadius_mm;
}

void MotionJson::feed(const Feed& feed) {
  append_member(line_, ",\"feed\":", feed.value);
  line_ += ",\"feed_mode\":\"";
  line_ += feed_mode_name(feed.mode);
  line_ += '"';
}

void MotionJson::spindle(const Spindle& spindle) {
  const bool css = spindle.mode == Spindle::Mode::constant_surface_speed;
  line_ += std::string(",\"direction\":\"") + turning_name(spindle.turning) + '"';
  append_member(line_, ",\"speed\":", spindle.speed);
  line_ += css ? ",\"mode\":\"css\"" : ",\"mode\":\"rpm\"";
  if (css && spindle.max_rpm > 0) append_member(line_, ",\"max_rpm\":", spindle.max_rpm);
  if (spindle.follows_radius()) append_member(line_, ",\"centre\":", spindle.centre);
  if (spindle.name != SpindleName::main)
    line_ += ",\"spindle\":\"" + std::string(name_of(spindle.name)) + '"';
  flag(spindle.cuts_standing, ",\"cuts_standing\":true");
  flag(spindle.is_clamped, ",\"clamped\":true");
}

void MotionJson::thread(const Thread& thread) {
  append_member(line_, ",\"lead\":", thread.lead);
  if (thread.lead_change != 0) append_member(line_, ",\"lead_change\":", thread.lead_change);
  if (thread.angle_deg != 0) append_member(line_, ",\"angle_deg\":", thread.angle_deg);
  if (thread.depth_mm != 0) append_member(line_, ",\"depth_mm\":", thread.depth_mm);
}

// Where the axes and the plane are, in mm of the machine.
void MotionJson::surface(const SurfaceMove& move) {
  const Surface& surface = move.surface;
  line_ += surface.kind == Surface::Kind::face ? ",\"surface\":{\"kind\":\"face\",\"axes\":\""
                                               : ",\"surface\":{\"kind\":\"cylinder\",\"axes\":\"";
  line_ += axes_[surface.first].letter;
  line_ += axes_[surface.rotary].letter;
  append_member(line_, "\",\"centre_mm\":", surface.centre_mm);
  append_member(line_, ",\"zero_deg\":", surface.zero_deg);
  append_member(line_, ",\"side\":", surface.side);
  append_member(line_, ",\"radius_mm\":", surface.radius_mm);
  append_member(line_, ",\"to\":[", move.flat_to[0]);
  append_member(line_, ",", move.flat_to[1]);
  line_ += "]}";
}

void MotionJson::length(const ToolLength& length) {
  length_ = length;
  line_ += ",\"length\":{\"axis\":\"";
  line_ += axes_[length_.axis].letter;
  append_member(line_, "\",\"mm\":", length_.mm);
  line_ += ",\"offset\":";
  base::append_integer(line_, length_.offset);
  line_ += '}';
}

// What any record may have, where it changes or is not usual.
void MotionJson::state(const Motion& motion) {
  flag(motion.exact_stop, ",\"exact_stop\":true");
  flag(motion.fixed_override, ",\"fixed_override\":true");
  if (!is_same(motion.length, length_)) length(motion.length);
  if (radii_) radii_->append_changes(line_);
}

void MotionJson::space_arc(const SpaceArc& arc) {
  const geometry::SpaceArc circle = SpaceArcPath(axes_, at_, arc).circle();
  target(arc.to);
  point(",\"via\":{", arc.via);
  if (arc.full_circle) point(",\"second_via\":{", arc.second_via);
  append_vector(line_, ",\"center\":[", circle.centre());
  append_vector(line_, ",\"normal\":[", circle.e3());
  append_member(line_, ",\"sweep_deg\":", base::tidy(geometry::degrees(circle.sweep_rad())));
  feed(arc.feed);
}

// Its plane is named by the letters of its axes.
void MotionJson::surface_arc(const SurfaceMove& move) {
  const AxisConfig& first = axes_[move.surface.first];
  line_ += ",\"plane\":\"";
  line_ += first.letter;
  line_ += axes_[move.surface.rotary].letter;
  append_member(line_, "\",\"center\":[", move.about[0] * first.count_per_mm());
  append_member(line_, ",", move.about[1]);
  line_ += move.direction == Direction::clockwise ? "],\"direction\":\"cw\",\"turns\":0"
                                                  : "],\"direction\":\"ccw\",\"turns\":0";
}

void MotionJson::take(const Motion& motion) {
  write(motion);
  state(motion);
  line_ += "}\n";
  file_.write(line_);
  if (const base::TipPoint* const to = target_of(motion)) at_ = *to;
}

void MotionJson::write(const Motion& motion) {
  const auto record = [&](const auto& action) {
    using Action = std::decay_t<decltype(action)>;
    if constexpr (std::is_same_v<Action, Rapid>) {
      begin("rapid", motion);
      target(action.to);
      flag(!action.linear, ",\"linear\":false");
    } else if constexpr (std::is_same_v<Action, Line>) {
      begin("line", motion);
      target(action.to);
      feed(action.feed);
    } else if constexpr (std::is_same_v<Action, Arc>) {
      begin("arc", motion);
      target(action.to);
      line_ += ",\"plane\":\"";
      line_ += plane_name(action.plane);
      centre(action);
      line_ += action.direction == Direction::clockwise ? "],\"direction\":\"cw\""
                                                        : "],\"direction\":\"ccw\"";
      line_ += ",\"turns\":";
      base::append_integer(line_, action.turns);
      feed(action.feed);
      flag(is_spiral(action), ",\"spiral\":true");
    } else if constexpr (std::is_same_v<Action, SpaceArc>) {
      begin("space-arc", motion);
      space_arc(action);
    } else if constexpr (std::is_same_v<Action, SurfaceMove>) {
      begin(action.is_arc ? "arc" : "line", motion);
      target(action.to);
      if (action.is_arc) surface_arc(action);
      feed(action.feed);
      surface(action);
    } else if constexpr (std::is_same_v<Action, Dwell>) {
      begin("dwell", motion);
      append_member(line_, ",\"seconds\":", action.seconds);
    } else if constexpr (std::is_same_v<Action, ToolChange>) {
      begin("tool", motion);
      line_ += ",\"tool\":";
      base::append_integer(line_, action.tool);
    } else if constexpr (std::is_same_v<Action, Spindle>) {
      begin("spindle", motion);
      spindle(action);
    } else if constexpr (std::is_same_v<Action, Coolant>) {
      begin("coolant", motion);
      line_ += std::string(",\"state\":\"") + coolant_name(action.state) + '"';
    } else if constexpr (std::is_same_v<Action, Power>) {
      begin("power", motion);
      append_member(line_, ",\"percent\":", action.percent);
      if (!action.on) line_ += ",\"beam\":false";
      if (action.follows_speed) line_ += ",\"follows_speed\":true";
      if (action.frequency_hz > 0) append_member(line_, ",\"frequency_hz\":", action.frequency_hz);
    } else if constexpr (std::is_same_v<Action, Probe>) {
      begin("probe", motion);
      target(action.to);
      feed(action.feed);
      line_ += action.contact ? ",\"contact\":true" : ",\"contact\":false";
    } else if constexpr (std::is_same_v<Action, Thread>) {
      begin("thread", motion);
      target(action.to);
      thread(action);
    } else if constexpr (std::is_same_v<Action, AuxiliaryCode>) {
      begin("mcode", motion);
      line_ += ",\"code\":";
      base::append_integer(line_, action.code);
    } else if constexpr (std::is_same_v<Action, Stop>) {
      begin("stop", motion);
      line_ += action.optional ? ",\"optional\":true" : ",\"optional\":false";
      flag(action.passed, ",\"passed\":true");
    } else if constexpr (std::is_same_v<Action, Message>) {
      begin("message", motion);
      const nlohmann::json text = std::string(action.text.view());
      line_ += ",\"text\":" + text.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    } else {
      begin("end", motion);
    }
  };
  std::visit(record, motion.action);
}

}  // namespace kerf::output
