#include "lang/records/record_parser.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "base/decimal.hpp"
#include "motion/plane_axes.hpp"

namespace kerf::records {
namespace {

using namespace motion;
using Need = Members::Need;

constexpr std::uint64_t kMostOffset = 9999;
constexpr double kMostWhole = std::numeric_limits<std::uint32_t>::max();
constexpr std::array<std::string_view, 15> kKinds = {
    "rapid", "line",  "arc",    "space-arc", "dwell", "tool",    "spindle", "coolant",
    "power", "probe", "thread", "mcode",     "stop",  "message", "end"};

FeedMode feed_mode_of(Members& members) {
  constexpr std::array kModes = {FeedMode::per_minute, FeedMode::per_revolution,
                                 FeedMode::inverse_time};
  return kModes[members.one_of("feed_mode", {"per-minute", "per-revolution", "inverse-time"})];
}

Feed feed_of(Members& members) {
  const double value = members.number("feed", kLeastFeed, kMostNumber);
  return {value, feed_mode_of(members)};
}

Direction direction_of(Members& members) {
  return members.one_of("direction", {"cw", "ccw"}) == 0 ? Direction::clockwise
                                                         : Direction::counterclockwise;
}

Motion::Action coolant_of(Members& members) {
  constexpr std::array kStates = {Coolant::State::off, Coolant::State::mist, Coolant::State::flood};
  return Coolant{kStates[members.one_of("state", {"off", "mist", "flood"})]};
}

// Without "beam" it is on.
Motion::Action power_of(Members& members) {
  Power power{members.number("percent", 0, 100)};
  power.on = members.find("beam", Need::optional) == nullptr || members.truth("beam");
  power.follows_speed = members.truth("follows_speed", Need::optional);
  return power;
}

Motion::Action stop_of(Members& members) {
  return Stop{members.truth("optional"), members.truth("passed", Need::optional)};
}

Motion::Action message_of(Members& members) {
  const std::string_view text = members.string("text");
  return Message{ShortText(text.empty() ? std::string() : json_text(text))};
}

// O and digits.
std::optional<std::uint32_t> number_of_program(std::string_view name) {
  if (name.empty() || name[0] != 'O') return std::nullopt;
  const auto number = base::read_whole_number(name.substr(1));
  if (!number || *number > 99'999'999) return std::nullopt;
  return static_cast<std::uint32_t>(*number);
}

}  // namespace

void RecordParser::head(Members& members, Record& record) {
  base::BlockId& block = record.motion.block;
  const std::string_view program = members.string("program");
  const auto number =
      program.empty() ? std::nullopt : number_of_program(program.substr(1, program.size() - 2));
  if (number) {
    block.program = base::ProgramNumber{*number};
  } else if (!program.empty()) {
    members.refuse({base::Code::motion_member, "program is not O and a number", program});
  }
  block.line = members.whole("line", kMostWhole);
  block.column = members.whole("column", kMostWhole, Need::optional);
  record.file = members.string("file", Need::optional);
  static_cast<void>(members.find("source", Need::optional));
}

tl::expected<Record, Mistake> RecordParser::parse(std::string_view line) {
  if (const auto fault = line_.read(line))
    return tl::unexpected(Mistake{base::Code::motion_kind, fault->sentence, fault->text});
  const JsonValue& whole = line_.values()[0];
  if (whole.kind != JsonValue::Kind::object)
    return tl::unexpected(Mistake{base::Code::motion_kind, "the line is no object", whole.text});
  Members members(line_, 0);
  const JsonValue* const kind = members.find("kind", Need::optional);
  const std::string_view word = kind == nullptr || kind->kind != JsonValue::Kind::string
                                    ? std::string_view()
                                    : kind->text.substr(1, kind->text.size() - 2);
  if (!members.mistake() && std::find(kKinds.begin(), kKinds.end(), word) == kKinds.end())
    return tl::unexpected(
        Mistake{base::Code::motion_kind,
                kind == nullptr ? "the object has no kind" : "there is no such kind",
                kind == nullptr ? whole.text : kind->text});
  Record record;
  head(members, record);
  record.motion.action = action(word, members, record);
  state(members, record);
  if (members.mistake()) return tl::unexpected(*members.mistake());
  record.unknown = members.rest();
  return record;
}

Motion::Action RecordParser::action(std::string_view kind, Members& members, Record& record) {
  if (kind == "rapid") {
    const base::TipPoint to = point("to", members);
    return Rapid{to, members.find("linear", Need::optional) == nullptr || members.truth("linear")};
  }
  if (kind == "line") return line_or_surface(members);
  if (kind == "arc") return arc_or_surface(members, record);
  if (kind == "space-arc") return space_arc(members);
  if (kind == "dwell") return Dwell{members.number("seconds", 0, kMostNumber)};
  if (kind == "tool") return ToolChange{members.whole("tool", kMostWhole)};
  if (kind == "spindle") return spindle(members);
  if (kind == "coolant") return coolant_of(members);
  if (kind == "power") return power_of(members);
  if (kind == "probe")
    return Probe{point("to", members), feed_of(members), members.truth("contact")};
  if (kind == "thread") return thread(members);
  if (kind == "mcode") return AuxiliaryCode{members.whole("code", kMostWhole)};
  if (kind == "stop") return stop_of(members);
  if (kind == "message") return message_of(members);
  return End{};
}

// What any record may have.
void RecordParser::state(Members& members, Record& record) {
  record.motion.exact_stop = members.truth("exact_stop", Need::optional);
  record.motion.fixed_override = members.truth("fixed_override", Need::optional);
  read_length(members, record);
  read_radii(members, record);
}

void RecordParser::read_radii(Members& members, Record& record) {
  const auto object = members.object("radii", Need::optional);
  if (!object) return;
  Members radii(line_, *object);
  radii.each([&](const JsonValue& value) {
    const auto number = base::read_whole_number(value.name);
    if (!number || *number > kMostOffset) return radii.wrong(value, "is the radius of no offset");
    std::array<double, 2> mm{};
    radii.numbers(value.name, mm);
    record.radii.push_back({static_cast<std::uint32_t>(*number), mm[0], mm[1]});
  });
  if (radii.mistake()) members.refuse(*radii.mistake());
}

void RecordParser::read_length(Members& members, Record& record) {
  const auto object = members.object("length", Need::optional);
  if (!object) return;
  Members length(line_, *object);
  const std::string_view letter = length.string("axis");
  ToolLength read{length.number("mm", -kMostCoordinate, kMostCoordinate),
                  length.whole("offset", kMostWhole),
                  {}};
  if (!letter.empty())
    read.axis = axis(letter.substr(1, letter.size() - 2), *length.find("axis"), length);
  if (length.mistake()) return members.refuse(*length.mistake());
  record.length = read;
}

base::Axis RecordParser::axis(std::string_view letter, const JsonValue& at, Members& members) {
  const auto found = letter.size() == 1 ? axes_.find(letter[0]) : std::nullopt;
  if (!found)
    members.refuse({base::Code::motion_axis,
                    "the machine has no axis " + std::string(letter.substr(0, 20)), at.text});
  return found.value_or(base::Axis{});
}

// Each axis of the machine, and no other.
base::TipPoint RecordParser::point(const char* name, Members& members) {
  base::TipPoint at;
  const auto object = members.object(name);
  if (!object) return at;
  Members coordinates(line_, *object);
  coordinates.each(
      [&](const JsonValue& value) { static_cast<void>(axis(value.name, value, coordinates)); });
  for (std::size_t i = 0; i < axes_.count(); ++i) {
    const AxisConfig& config = axes_.axes[i];
    at.values[i] = coordinates.number({&config.letter, 1}, -kMostCoordinate, kMostCoordinate) /
                   config.count_per_mm();
  }
  if (coordinates.mistake()) members.refuse(*coordinates.mistake());
  return at;
}

Motion::Action RecordParser::line_or_surface(Members& members) {
  if (const auto surface = members.object("surface", Need::optional))
    return surface_move(members, *surface, false);
  const base::TipPoint to = point("to", members);
  return Line{to, feed_of(members)};
}

Motion::Action RecordParser::arc_or_surface(Members& members, Record& record) {
  if (const auto surface = members.object("surface", Need::optional))
    return surface_move(members, *surface, true);
  return arc(members, record);
}

// False: a mistake.
bool RecordParser::is_arm_of(Plane plane, Members& members) {
  if (plane_axes(plane, axes_)) return true;
  members.refuse({base::Code::motion_axis, "the machine lacks an axis of this plane",
                  members.string("plane")});
  return false;
}

Motion::Action RecordParser::arc(Members& members, Record& record) {
  constexpr std::array kPlanes = {Plane::xy, Plane::zx, Plane::yz};
  Arc arc;
  arc.to = point("to", members);
  arc.plane = kPlanes[members.one_of("plane", {"XY", "ZX", "YZ"})];
  members.numbers("center", arc.center);
  arc.direction = direction_of(members);
  arc.turns =
      static_cast<std::uint16_t>(members.whole("turns", std::numeric_limits<std::uint16_t>::max()));
  arc.feed = feed_of(members);
  if (members.mistake() || !is_arm_of(arc.plane, members)) return arc;
  const PlaneAxes plane = *plane_axes(arc.plane, axes_);
  arc.center[0] /= axes_[plane.first].count_per_mm();
  arc.center[1] /= axes_[plane.second].count_per_mm();
  record.centre = members.find("center")->text;
  record.is_spiral = members.truth("spiral", Need::optional);
  return arc;
}

// Its circle follows from its points; what the record says of it is for people.
Motion::Action RecordParser::space_arc(Members& members) {
  SpaceArc arc;
  arc.to = point("to", members);
  arc.via = point("via", members);
  arc.full_circle = members.find("second_via", Need::optional) != nullptr;
  if (arc.full_circle) arc.second_via = point("second_via", members);
  arc.feed = feed_of(members);
  for (const char* const follows : {"center", "normal", "sweep_deg"})
    static_cast<void>(members.find(follows, Need::optional));
  return arc;
}

Motion::Action RecordParser::spindle(Members& members) {
  using Turning = Spindle::Turning;
  constexpr std::array kTurnings = {Turning::clockwise, Turning::counterclockwise, Turning::stopped,
                                    Turning::oriented};
  constexpr std::array kNames = {SpindleName::main, SpindleName::live, SpindleName::sub};
  Spindle spindle;
  spindle.turning = kTurnings[members.one_of("direction", {"cw", "ccw", "stop", "orient"})];
  spindle.speed = members.number("speed", 0, kMostNumber);
  if (members.one_of("mode", {"rpm", "css"}) == 1)
    spindle.mode = Spindle::Mode::constant_surface_speed;
  spindle.max_rpm = members.number_if("max_rpm", 0, kMostNumber).value_or(0);
  if (const auto centre = members.number_if("centre", -kMostCoordinate, kMostCoordinate)) {
    spindle.centre = *centre;
    spindle.radius_axis = axes_.find('X');
  }
  if (members.find("spindle", Need::optional) != nullptr)
    spindle.name = kNames[members.one_of("spindle", {"main", "live", "sub"})];
  spindle.cuts_standing = members.truth("cuts_standing", Need::optional);
  spindle.is_clamped = members.truth("clamped", Need::optional);
  return spindle;
}

Motion::Action RecordParser::thread(Members& members) {
  Thread thread;
  thread.to = point("to", members);
  thread.lead = members.number("lead", -kMostCoordinate, kMostCoordinate);
  thread.lead_change =
      members.number_if("lead_change", -kMostCoordinate, kMostCoordinate).value_or(0);
  thread.angle_deg = members.number_if("angle_deg", -kMostCoordinate, kMostCoordinate).value_or(0);
  thread.depth_mm = members.number_if("depth_mm", 0, kMostCoordinate).value_or(0);
  return thread;
}

Motion::Action RecordParser::surface_move(Members& members, std::size_t object, bool is_arc) {
  Members said(line_, object);
  SurfaceMove move;
  move.to = point("to", members);
  move.is_arc = is_arc;
  Surface& surface = move.surface;
  if (said.one_of("kind", {"face", "cylinder"}) == 1) surface.kind = Surface::Kind::cylinder;
  const std::string_view axes = said.string("axes");
  if (axes.size() == 4) {
    surface.first = axis(axes.substr(1, 1), *said.find("axes"), said);
    surface.rotary = axis(axes.substr(2, 1), *said.find("axes"), said);
    if (!said.mistake() && (axes_[surface.first].rotary || !axes_[surface.rotary].rotary))
      said.wrong(*said.find("axes"), "is not a linear axis and a rotary one");
  } else if (const JsonValue* const value = said.find("axes")) {
    said.wrong(*value, "is not the letters of two axes");
  }
  surface.centre_mm = said.number("centre_mm", -kMostCoordinate, kMostCoordinate);
  surface.zero_deg = said.number("zero_deg", -kMostCoordinate, kMostCoordinate);
  surface.side = said.number("side", -1, 1) < 0 ? -1 : 1;
  surface.radius_mm = said.number("radius_mm", 0, kMostCoordinate);
  if (surface.kind == Surface::Kind::cylinder && surface.radius_mm == 0 && !said.mistake())
    said.wrong(*said.find("radius_mm"), "is 0: a cylinder has one");
  said.numbers("to", move.flat_to);
  if (said.mistake()) members.refuse(*said.mistake());
  if (is_arc) {
    static_cast<void>(members.string("plane"));
    members.numbers("center", move.about);
    move.about[0] /= axes_[surface.first].count_per_mm();
    move.direction = direction_of(members);
    static_cast<void>(members.whole("turns", 0));
  }
  move.feed = feed_of(members);
  return move;
}

}  // namespace kerf::records
