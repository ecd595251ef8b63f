#include "control/gcode/acts/settings.hpp"

#include <cmath>

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"

namespace kerf::control {
namespace {

using base::Axis;
using base::AxisSet;
using base::AxisVector;
using base::Code;
using gcode::Word;
using gcode::WordFlag;

constexpr double kMostOffset = 9999.999;  // mm, geometry and wear together

// Codes that are accepted and change nothing here, with what to say about them.
struct WithoutEffect {
  GCode code;
  const char* what;
};
constexpr WithoutEffect kWithoutEffect[] = {{41, "G04.1 (look-ahead stop) has no effect"},
                                            {50, "G05 (high-speed machining) has no effect"},
                                            {51, "G05.1 (look-ahead) has no effect"},
                                            {80, "G08 (look-ahead) has no effect"},
                                            {220, "G22 (stroke check area) has no effect"},
                                            {230, "G23 (stroke check area) has no effect"},
                                            {600, "G60 (single direction positioning) runs as G00"},
                                            {620, "G62 (corner override) has no effect"},
                                            {630, "G63 (tapping mode) does not lock the feed hold"},
                                            {1610, "G161 (in-feed control) has no effect"}};

bool is_reference(GCode code) { return code >= 270 && code <= 300; }

// Another work coordinate system than the active one.
bool changes_work(const State& state, GCode code) {
  return code >= 540 && code <= 590 && (code == 541 || state.modal[Group::work] != code);
}

}  // namespace

bool Settings::read_codes(const Words& words, const Words::G*& one_shot) {
  for (const Words::G* g = words.g_begin(); g != words.g_end(); ++g) {
    const Group group = group_of(g->code);
    if (group == Group::none) {
      return state_.alarms.raise(Code::improper_g_code, g->word->text,
                                 "G" + base::number_text(g->code / 10.0) + " is not available");
    }
    if (!check_code(words, *g, group)) return false;
    if (group == Group::one_shot) {
      one_shot = g;
    } else {
      state_.modal.set(group, g->code);
    }
  }
  state_.refresh_format();
  return true;
}

// G96 P: the axis whose position is the diameter, by number.
bool Settings::check_css_axis(const Word& word) {
  std::int64_t axis = 0;
  if (!state_.values.integer(word, 0, 99999999, axis)) return false;
  if (axis <= static_cast<std::int64_t>(state_.axes.count())) return true;
  return state_.alarms.raise(Code::css_axis, word.text,
                             "the machine has " + std::to_string(state_.axes.count()) + " axes");
}

// G17 to G19 with U, V or W would choose a plane of parallel axes.
bool Settings::check_parallel_axes(const Words& words) {
  constexpr std::pair<char, char> kParallel[] = {{'U', 'X'}, {'V', 'Y'}, {'W', 'Z'}};
  for (const auto& [parallel, basic] : kParallel) {
    if (!words.has(parallel) || !state_.axes.find(parallel)) continue;
    const std::string name(1, parallel);
    return state_.alarms.raise(Code::parallel_plane_axes, words[parallel].text,
                               words.has(basic)
                                   ? name + " is parallel to " + basic
                                   : "a plane of the parallel axis " + name + " is not available");
  }
  return true;
}

bool Settings::check_code(const Words& words, const Words::G& g, Group group) {
  if (group == Group::motion) return true;
  const Transform& transform = state_.coordinates.transform();
  const bool leaves_system = is_reference(g.code) || g.code == 530 || changes_work(state_, g.code);
  const bool shifts_system = g.code == 520 || g.code == 920 || g.code == 921;
  if (transform.scaled() && (leaves_system || shifts_system)) {  // TRF-2
    return state_.alarms.raise(Code::illegal_in_scaling, g.word->text);
  }
  if (transform.rotated() && leaves_system)
    return state_.alarms.raise(Code::illegal_rotation, g.word->text);
  if (group == Group::plane && g.code != state_.modal[Group::plane]) {
    if (state_.path.compensating() || state_.modal.compensating()) {
      return state_.alarms.raise(Code::plane_change_in_compensation, g.word->text);
    }
    if (state_.rigid_tapping && state_.modal.in_cycle())
      return state_.alarms.raise(Code::tap_plane, g.word->text);
  }
  if (group == Group::plane && !check_parallel_axes(words)) return false;
  const bool repeated = group != Group::one_shot && state_.modal[group] == g.code;
  if (group == Group::motion || (repeated && g.code != 220)) return true;
  if (g.code == 950 && !state_.parameters.feed_per_revolution)
    return state_.alarms.raise(Code::no_feed_per_revolution, g.word->text);
  if (g.code == 960 && words.has('P') && !check_css_axis(words['P'])) return false;
  for (const WithoutEffect& entry : kWithoutEffect) {
    if (entry.code == g.code) state_.assume(Assumed::g_code + g.code, entry.what);
  }
  return true;
}

bool Settings::takes_axis_words(const Words& words) const {
  for (const Words::G* g = words.g_begin(); g != words.g_end(); ++g) {
    switch (g->code) {
      case 220:
      case 510:
      case 501:
      case 511:
      case 680: return true;
      default: break;
    }
  }
  return false;
}

bool Settings::apply_codes(const Words& words) {
  bool length = false;
  bool compensation = false;
  bool feed_mode = false;
  for (const Words::G* g = words.g_begin(); g != words.g_end(); ++g) {
    const Group group = group_of(g->code);
    length |= group == Group::length;
    compensation |= group == Group::compensation;
    feed_mode |= group == Group::feed;
    bool good = true;
    switch (g->code) {
      case 500: {
        Transform transform = state_.coordinates.transform();
        transform.cancel_scaling();
        state_.coordinates.set_transform(transform);
        break;
      }
      case 690: {
        Transform transform = state_.coordinates.transform();
        transform.cancel_rotation();
        state_.coordinates.set_transform(transform);
        break;
      }
      case 510: good = set_scaling(words); break;
      case 501:
      case 511: good = set_mirror(words, g->code == 511); break;
      case 680: good = set_rotation(words); break;
      case 160: targets_.begin_polar(); break;
      default:
        if (group == Group::work) good = select_work(words, g->code);
        break;
    }
    if (!good) return false;
  }
  // F counts something else now: the old one means nothing any more.
  if (feed_mode && state_.before.feed_mode() != state_.modal.feed_mode() && !words.has('F'))
    state_.words.feed = 0;
  return set_length(words, length) && set_compensation(words, compensation);
}

// WCS-1, WCS-2
bool Settings::select_work(const Words& words, GCode code) {
  WorkSystem work;
  const bool extended = code == 541 || (code == 540 && words.has('P'));
  if (extended) {
    std::int64_t number = 1;
    if (words.has('P') && !state_.values.integer(words['P'], 0, 99999999, number)) return false;
    if (number < 1 || number > static_cast<std::int64_t>(kExtendedSystems)) {
      return state_.alarms.raise(Code::illegal_offset_number, words['P'].text,
                                 "G54.1 takes P1 to P300");
    }
    work.extended = static_cast<std::uint32_t>(number);
    state_.words.extended_work = number;
    state_.modal.set(Group::work, 541);
  } else {
    work.index = (code - 540U) / 10U;
  }
  state_.coordinates.select(work);
  return true;
}

double Settings::length_of(std::int64_t number) const {
  const ToolOffset& tool = state_.memory.tools[static_cast<std::size_t>(number)];
  return base::tidy(tool.length_geometry + tool.length_wear);
}

double Settings::radius_of(std::int64_t number) const {
  const ToolOffset& tool = state_.memory.tools[static_cast<std::size_t>(number)];
  if (state_.parameters.offset_memory != 'C')
    return base::tidy(tool.length_geometry + tool.length_wear);
  return base::tidy(tool.radius_geometry + tool.radius_wear);
}

// Always Z, or with type C the axis that the block names (TLC-4).
bool Settings::find_length_axis(const Words& words, Axis& axis) const {
  if (state_.parameters.length_axis_type == 0) {
    const auto z = state_.axes.find('Z');
    if (z) axis = *z;
    return z.has_value();
  }
  bool found = false;
  for (std::size_t i = 0; i < state_.axes.count(); ++i) {
    const Axis candidate{static_cast<std::uint8_t>(i)};
    if (!words.has(state_.axes[candidate].letter)) continue;
    axis = candidate;
    found = true;
  }
  return found;
}

// TLC-1 to TLC-4. The offset moves the axis at once (TLC-2); its motion shows in the machine
// coordinates only, because targets leave the tool length out.
bool Settings::set_length(const Words& words, bool switched) {
  const GCode mode = state_.modal[Group::length];
  if (!switched && !(words.has('H') && mode != 490)) return true;
  Axis axis = state_.length_axis;
  if (switched && mode != 490) {
    if (!find_length_axis(words, axis)) return state_.alarms.raise(Code::no_length_axis);
    if (axis != state_.length_axis) state_.set_length(state_.length_axis, 0);
    state_.length_axis = axis;
  }
  const double offset = length_of(state_.words.length_offset);
  if (std::fabs(offset) > kMostOffset)
    return state_.alarms.raise(
        Code::illegal_offset_value,
        "H" + std::to_string(state_.words.length_offset) + " is " + base::number_text(offset));
  state_.wanted_length = mode == 490 ? 0 : mode == 430 ? offset : -offset;
  if (switched && mode != 490 && state_.words.length_offset == 0) {
    state_.assume(Assumed::no_offset, "G43 or G44 without an offset number: length offset 0");
  }
  moves_.apply_length(base::only(axis));
  return true;
}

bool Settings::set_compensation(const Words& words, bool switched) {
  const GCode mode = state_.modal[Group::compensation];
  if (mode == 400) {
    if (!switched || !state_.path.compensating()) return true;
    std::optional<geometry::Vec2> wall;
    const auto plane = motion::plane_axes(state_.modal.plane(), state_.axes);
    if (plane && (words.has(plane->first_offset) || words.has(plane->second_offset)) &&
        state_.modal[Group::motion] < 20) {
      geometry::Vec2 direction;
      if (words.has(plane->first_offset) &&
          !state_.values.length(words[plane->first_offset], direction.u))
        return false;
      if (words.has(plane->second_offset) &&
          !state_.values.length(words[plane->second_offset], direction.v))
        return false;
      if (geometry::length(direction) > 0) wall = direction;
    }
    const GCode motion = state_.modal[Group::motion];
    if (motion != 0 && motion != 10 && words.has_any(targets_.letters())) {
      return state_.alarms.raise(Code::arc_at_start_up);
    }
    state_.path.end_compensation(wall);
    return true;
  }
  if (!switched && !words.has('D')) return true;
  const auto plane = motion::plane_axes(state_.modal.plane(), state_.axes);
  if (!plane)
    return state_.alarms.raise(Code::illegal_plane_axis, "the machine lacks an axis of the plane");
  const Transform& transform = state_.coordinates.transform();
  if (transform.rotated() && !transform.rotates(*plane))  // TRF-3
    return state_.alarms.raise(Code::illegal_transform_plane);
  const double radius = radius_of(state_.words.radius_offset);
  if (std::fabs(radius) > kMostOffset)
    return state_.alarms.raise(
        Code::illegal_offset_value,
        "D" + std::to_string(state_.words.radius_offset) + " is " + base::number_text(radius));
  if (state_.words.radius_offset == 0 || radius == 0) {  // D0 cancels (CRC-1, CRC-12)
    if (switched && state_.words.radius_offset == 0) {
      state_.assume(Assumed::no_offset + 500, "G41 or G42 without an offset number: radius 0");
    }
    if (state_.path.compensating()) state_.path.end_compensation(std::nullopt);
    return true;
  }
  const bool left = (mode == 410) != transform.reverses(*plane);
  state_.path.compensate(*plane, left ? radius : -radius);
  return true;
}

// G51 P counts 0.001 (SCR); with a decimal point it is the factor itself.
bool Settings::scale_factor(const Words& words, char letter, double& factor) {
  const Word& word = words[letter];
  if (!state_.values.plain(word, factor)) return false;
  if (!(word.has(WordFlag::literal) && word.has(WordFlag::point))) {
    factor *= state_.parameters.scale_thousandth ? 0.001 : 0.00001;
  }
  factor = base::tidy(factor);
  if (factor == 0) return state_.alarms.raise(Code::illegal_scale, word.text);
  return true;
}

bool Settings::set_scaling(const Words& words) {
  AxisVector centre = state_.coordinates.program();
  AxisSet named = 0;
  if (!targets_.values(words, centre, named)) return false;
  AxisVector factors;
  factors.values.fill(1);
  constexpr std::pair<char, char> kPairs[] = {{'X', 'I'}, {'Y', 'J'}, {'Z', 'K'}};
  double common = 1;
  if (words.has('P') && !scale_factor(words, 'P', common)) return false;
  for (const auto& [axis_letter, factor_letter] : kPairs) {
    const auto axis = state_.axes.find(axis_letter);
    if (!axis) continue;
    factors[*axis] = common;
    if (!words.has('P') && words.has(factor_letter) &&
        !scale_factor(words, factor_letter, factors[*axis]))
      return false;
  }
  Transform transform = state_.coordinates.transform();
  transform.scale(centre, factors);
  state_.coordinates.set_transform(transform);
  return true;
}

bool Settings::set_mirror(const Words& words, bool on) {
  AxisVector values = state_.coordinates.program();
  AxisSet named = 0;
  if (!targets_.values(words, values, named)) return false;
  Transform transform = state_.coordinates.transform();
  for (std::size_t i = 0; i < state_.axes.count(); ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    if (on && base::contains(named, axis)) transform.mirror(axis, values[axis]);
    if (!on && (named == 0 || base::contains(named, axis))) transform.cancel_mirror(axis);
  }
  state_.coordinates.set_transform(transform);
  state_.modal.set(Group::mirror, transform.mirrored() != 0 ? 511 : 501);
  return true;
}

bool Settings::set_rotation(const Words& words) {
  const auto plane = motion::plane_axes(state_.modal.plane(), state_.axes);
  if (!plane)
    return state_.alarms.raise(Code::illegal_plane_axis, "the machine lacks an axis of the plane");
  AxisVector centre = state_.coordinates.program();
  AxisSet named = 0;
  if (!targets_.values(words, centre, named)) return false;
  double angle = state_.parameters.rotation_default;
  if (words.has('R') && !state_.values.angle(words['R'], angle)) return false;
  if (state_.coordinates.transform().rotated() && state_.modal.incremental()) {
    angle += state_.coordinates.transform().rotation_deg();
  }
  Transform transform = state_.coordinates.transform();
  transform.rotate(*plane, plane->project(centre), angle);
  state_.coordinates.set_transform(transform);
  return true;
}

// WCS-3
bool Settings::local_system(const Words& words) {
  AxisVector values;
  AxisSet named = 0;
  if (!targets_.values(words, values, named)) return false;
  for (std::size_t i = 0; i < state_.axes.count(); ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    if (base::contains(named, axis)) state_.coordinates.set_local(axis, values[axis]);
  }
  return true;
}

// WCS-4
bool Settings::preset(const Words& words) {
  AxisVector program = state_.coordinates.program();
  AxisSet named = 0;
  if (!targets_.values(words, program, named)) return false;
  state_.coordinates.preset(program);
  return true;
}

// WCS-5
bool Settings::clear_shifts(const Words& words) {
  for (std::size_t i = 0; i < state_.axes.count(); ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    if (words.has(state_.axes[axis].letter)) state_.coordinates.clear_shifts(axis);
  }
  return true;
}

}  // namespace kerf::control
