#include "control/gcode/acts/drawing.hpp"

#include <cmath>
#include <string>

#include "base/decimal.hpp"

namespace kerf::control {
namespace {

using base::Code;
using gcode::Word;
using gcode::WordFlag;
using geometry::AngledLine;
using geometry::Vec2;

// An end point that has an angle beside it lies on its line, but for decimals left out.
constexpr double kOnLine_mm = 0.01;

bool cuts_thread(const Words& words, const ModalState& modal) {
  const Meaning motion = modal[Group::motion];
  return words.has_g(Meaning::compound_thread) || motion == Meaning::thread ||
         motion == Meaning::thread_of_variable_lead || motion == Meaning::thread_cycle;
}

bool is_leg(const Word& word) { return word.letter == 'I' || word.letter == 'K'; }

bool names(const Target& target, base::Axis axis) { return base::contains(target.named, axis); }

Vec2 tidy_point(Vec2 point) { return {base::tidy(point.u), base::tidy(point.v)}; }

}  // namespace

bool Drawing::admits(const Words& words, const Dimensions& dimensions) {
  if (!state_.codes.habits().drawing_dimensions) return true;
  const Word& word = dimensions.first();
  if (!cuts_line(words, state_.modal)) {
    return state_.alarms.raise(
        cuts_thread(words, state_.modal) ? Code::corner_second : Code::drawing_format, word.text,
        "it needs a G01 move");
  }
  const bool on_surface = state_.path.surface() != nullptr;
  if (state_.modal.plane() == motion::Plane::zx && !on_surface) return true;
  return state_.alarms.raise(Code::drawing_plane, word.text);
}

bool Drawing::move(const Words& words, const Dimensions& dimensions, bool& moved) {
  if (!state_.codes.habits().drawing_dimensions)
    return move_on_mill(words, *dimensions.corner, moved);
  const auto plane = motion::plane_axes(motion::Plane::zx, state_.axes);
  if (!plane) return state_.alarms.raise(Code::drawing_plane, dimensions.first().text);
  Line line{.words = words, .dimensions = dimensions, .plane = *plane};
  return move_on_lathe(line, moved);
}

// A chamfer or corner radius at the end of a G01, G02 or G03 move.
bool Drawing::move_on_mill(const Words& words, const Word& corner, bool& moved) {
  if (state_.modal[Group::motion] != Meaning::line && !state_.modal.circular()) {
    return state_.alarms.raise(Code::corner_second, corner.text, "it needs a G01, G02 or G03 move");
  }
  const auto plane = state_.plane();
  if (!plane) return state_.alarms.raise(Code::illegal_plane_axis);
  if (!words.has_any(targets_.letters()))
    return state_.alarms.raise(Code::corner_missing_move, corner.text, "this block does not move");
  double size = 0;
  if (!state_.values.length(corner, size)) return false;
  if (size < 0) return state_.alarms.raise(Code::illegal_minus, corner.text);
  const auto kind =
      corner.letter == 'C' ? CornerRounding::Kind::chamfer : CornerRounding::Kind::radius;
  state_.path.round_corner({{.kind = kind, .size_mm = size}, state_.modal.plane(), *plane});
  return moves_.execute(words, moved);
}

bool Drawing::move_on_lathe(Line& line, bool& moved) {
  if (!read(line)) return false;
  moved = true;
  if (line.dimensions.angle != nullptr && line.target.named == 0) return await_end(line);
  if (line.dimensions.angle != nullptr && !find_end(line)) return false;
  if (!read_corner(line)) return false;
  round_corner(line);
  return moves_.straight(line.words, line.target);
}

bool Drawing::read(Line& line) {
  const Dimensions& dimensions = line.dimensions;
  if (!targets_.read(line.words, line.target)) return false;
  if (dimensions.angle == nullptr) {
    return line.target.named != 0 ||
           state_.alarms.raise(Code::corner_missing_move, dimensions.corner->text,
                               "this block does not move");
  }
  targets_.tell_increments(*dimensions.angle, true);
  return state_.values.angle(*dimensions.angle, line.angle_deg);
}

// The sign counts where it says where to, or where the comma shows that a length is meant.
bool Drawing::read_corner(Line& line) {
  const Word* const word = line.dimensions.corner;
  if (word == nullptr) return true;
  CornerRounding::Request request{.between_lines = true};
  targets_.tell_increments(*word, false);
  if (!state_.values.length(*word, request.size_mm)) return false;
  if (word->has(WordFlag::comma) && request.size_mm < 0)
    return state_.alarms.raise(Code::illegal_minus, word->text);
  if (word->letter != 'R') request.kind = CornerRounding::Kind::chamfer;
  if (is_leg(*word) && !read_legs(line, request)) return false;
  request.size_mm = std::fabs(request.size_mm);
  line.corner = request;
  return true;
}

// I behind a move along Z, K behind one along X: 45 degrees, toward their sign.
bool Drawing::read_legs(const Line& line, CornerRounding::Request& request) {
  const Word& word = *line.dimensions.corner;
  const Vec2 way = line.plane.project(line.target.program) - start(line);
  const bool along_z = std::fabs(way.u) > CornerRounding::kAlongAxis_mm;
  const bool along_x = std::fabs(way.v) > CornerRounding::kAlongAxis_mm;
  if (line.dimensions.angle != nullptr || (along_z && along_x))
    return state_.alarms.raise(Code::corner_taper, word.text,
                               "I and K stand behind a move along one axis");
  if ((along_z || along_x) && along_z != (word.letter == 'I'))
    return state_.alarms.raise(
        Code::corner_axis, word.text,
        along_z ? "behind a move along Z stands I" : "behind a move along X stands K");
  const double side = request.size_mm < 0 ? -1 : 1;
  request.toward = along_z ? Vec2{0, side} : Vec2{side, 0};
  return true;
}

void Drawing::round_corner(const Line& line) {
  if (line.corner) state_.path.round_corner({*line.corner, motion::Plane::zx, line.plane});
}

// What the angle says of the end of the line.
bool Drawing::find_end(Line& line) {
  if (state_.path.unfinished()) return finish_waiting(line);
  const AngledLine along{start(line), line.angle_deg};
  const bool has_z = names(line.target, line.plane.first);
  const bool has_x = names(line.target, line.plane.second);
  if (has_z != has_x) return find_coordinate(line, along);
  const Word& word = *line.dimensions.angle;
  if (!has_z)
    return state_.alarms.raise(Code::drawing_format, word.text,
                               "an angle stands beside X or Z, or alone");
  const double off = geometry::distance(along, line.plane.project(line.target.program));
  return off <= kOnLine_mm || state_.alarms.raise(Code::no_line_end, word.text,
                                                  "X and Z lie " + base::rounded_text(off, 3) +
                                                      " mm beside the line of this angle");
}

bool Drawing::find_coordinate(Line& line, const AngledLine& along) {
  const Vec2 end = line.plane.project(line.target.program);
  const bool has_z = names(line.target, line.plane.first);
  const auto found =
      has_z ? geometry::point_at_u(along, end.u) : geometry::point_at_v(along, end.v);
  if (!found)
    return state_.alarms.raise(Code::no_line_end, line.dimensions.angle->text,
                               has_z ? "the line runs along X" : "the line runs along Z");
  line.plane.place(line.target.program, tidy_point(*found));
  line.target.named = static_cast<base::AxisSet>(line.target.named | base::only(line.plane.first) |
                                                 base::only(line.plane.second));
  return true;
}

// G40 to G42 would belong to two lines.
bool Drawing::switches_compensation() const {
  return state_.before[Group::compensation] != state_.modal[Group::compensation];
}

// An angle alone.
bool Drawing::await_end(Line& line) {
  const Word& word = *line.dimensions.angle;
  if (state_.path.unfinished())
    return state_.alarms.raise(Code::line_end_missing, word.text,
                               "two angles follow each other without an end point");
  if (switches_compensation()) return state_.alarms.raise(Code::corner_in_compensation, word.text);
  if (!moves_.has_feed(line.words) || !read_corner(line)) return false;
  moves_.apply_length(
      static_cast<base::AxisSet>(base::only(line.plane.first) | base::only(line.plane.second)));
  round_corner(line);
  return state_.path.await_end(line.angle_deg, moves_.feed());
}

bool Drawing::check_second(const Line& line) {
  const Word& word = *line.dimensions.angle;
  if (!names(line.target, line.plane.first) || !names(line.target, line.plane.second))
    return state_.alarms.raise(Code::line_end_missing, word.text,
                               "behind an angle alone the next line needs X and Z");
  if (state_.modal.incremental() || targets_.ways(line.words) != 0)
    return state_.alarms.raise(Code::drawing_format, word.text,
                               "behind an angle alone the end point is absolute");
  return !switches_compensation() || state_.alarms.raise(Code::corner_in_compensation, word.text);
}

// The line that waited ends where this one crosses it, and this one begins there.
bool Drawing::finish_waiting(const Line& line) {
  if (!check_second(line)) return false;
  const auto corner = geometry::crossing({start(line), state_.path.unfinished()->angle_deg},
                                         {line.plane.project(line.target.program), line.angle_deg});
  if (!corner)
    return state_.alarms.raise(Code::no_line_end, line.dimensions.angle->text,
                               "the two lines are parallel");
  base::ProgramPoint program = state_.coordinates.program();
  line.plane.place(program, tidy_point(*corner));
  const base::PathPoint path = state_.coordinates.path_of(program);
  if (!moves_.check_limits(path) || !state_.path.finish_line(state_.coordinates.path(), path))
    return false;
  state_.coordinates.move_to(program, path);
  return true;
}

}  // namespace kerf::control
