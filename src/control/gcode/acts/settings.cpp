#include "control/gcode/acts/settings.hpp"

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"

namespace kerf::control {
namespace {

using base::Axis;
using base::AxisSet;
using base::AxisVector;
using base::Code;
using base::ProgramPoint;
using gcode::Word;
using gcode::WordFlag;

constexpr double kMostOffset = 9999.999;  // mm, geometry and wear together

// It would leave the coordinate system that a transformation is part of.
bool leaves_system(const State& state, const CodeRow& row) {
  switch (row.meaning) {
    case Meaning::reference_check:
    case Meaning::reference_return:
    case Meaning::way_from_reference:
    case Meaning::further_reference_return:
    case Meaning::machine_system:
    case Meaning::further_work_system: return true;
    case Meaning::work_system: return state.modal.row(Group::work) != &row;
    default: return false;
  }
}

bool shifts_system(Meaning meaning) {
  return meaning == Meaning::local_system || meaning == Meaning::preset ||
         meaning == Meaning::clear_shifts;
}

}  // namespace

bool Settings::read_codes(const Words& words, const Words::G*& one_shot) {
  for (const Words::G* g = words.g_begin(); g != words.g_end(); ++g) {
    if (g->row == nullptr) {
      return state_.alarms.raise(Code::improper_g_code, g->word->text,
                                 "G" + base::number_text(g->code / 10.0) + " is not available");
    }
    if (!check_code(words, *g)) return false;
    if (g->group() == Group::one_shot) {
      one_shot = g;
    } else {
      state_.modal.set(*g->row);
    }
  }
  state_.refresh_format();
  return true;
}

// G96 P: the axis whose position is the diameter, by number.
bool Settings::check_css_axis(const Word& word) {
  std::int64_t axis = 0;
  if (!state_.values.integer(word, 0, 99999999, axis)) return false;
  if (axis <= static_cast<std::int64_t>(state_.axes.count())) {
    state_.words.css_axis = axis;
    return true;
  }
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

bool Settings::check_code(const Words& words, const Words::G& g) {
  const Group group = g.group();
  if (group == Group::motion) return true;
  const Transform& transform = state_.coordinates.transform();
  const bool leaves = leaves_system(state_, *g.row);
  if (transform.scaled() && (leaves || shifts_system(g.meaning()))) {  // TRF-2
    return state_.alarms.raise(Code::illegal_in_scaling, g.word->text);
  }
  if (transform.rotated() && leaves)
    return state_.alarms.raise(Code::illegal_rotation, g.word->text);
  if (group == Group::plane && g.row != state_.modal.row(group)) {
    if (state_.path.compensating() || state_.modal.compensating()) {
      return state_.alarms.raise(Code::plane_change_in_compensation, g.word->text);
    }
    if (state_.rigid_tapping && state_.modal.in_cycle())
      return state_.alarms.raise(Code::tap_plane, g.word->text);
  }
  if (group == Group::plane && !check_parallel_axes(words)) return false;
  const bool repeated = group != Group::one_shot && state_.modal.row(group) == g.row;
  if (repeated && g.meaning() != Meaning::stroke_check_on) return true;
  if (g.meaning() == Meaning::per_revolution && !state_.parameters.feed_per_revolution)
    return state_.alarms.raise(Code::no_feed_per_revolution, g.word->text);
  if (g.meaning() == Meaning::surface_speed && words.has('P') && !check_css_axis(words['P']))
    return false;
  if (*g.row->effect != '\0') state_.assume(Assumed::g_code + g.code, g.row->effect);
  return true;
}

bool Settings::takes_axis_words(const Words& words) const {
  return std::any_of(words.g_begin(), words.g_end(), [](const Words::G& g) {
    return g.row != nullptr && g.row->axis_words == AxisWords::data;
  });
}

bool Settings::apply_codes(const Words& words) {
  bool length = false;
  bool compensation = false;
  bool feed_mode = false;
  for (const Words::G* g = words.g_begin(); g != words.g_end(); ++g) {
    const Group group = g->group();
    length |= group == Group::length;
    compensation |= group == Group::compensation;
    feed_mode |= group == Group::feed;
    bool good = true;
    switch (g->meaning()) {
      case Meaning::scaling_off: {
        Transform transform = state_.coordinates.transform();
        transform.cancel_scaling();
        state_.coordinates.set_transform(transform);
        break;
      }
      case Meaning::rotation_off: {
        Transform transform = state_.coordinates.transform();
        transform.cancel_rotation();
        state_.coordinates.set_transform(transform);
        break;
      }
      case Meaning::scaling_on: good = set_scaling(words); break;
      case Meaning::mirror_off:
      case Meaning::mirror_on: good = set_mirror(words, g->meaning() == Meaning::mirror_on); break;
      case Meaning::double_turret_on:
      case Meaning::double_turret_off: set_turret(g->meaning() == Meaning::double_turret_on); break;
      case Meaning::rotation_on: good = set_rotation(words); break;
      case Meaning::polar_on: targets_.begin_polar(); break;
      default:
        if (group == Group::work) good = select_work(words, *g->row);
        break;
    }
    if (!good) return false;
  }
  // F counts something else now: the old one means nothing any more.
  if (feed_mode && state_.before.feed_mode() != state_.modal.feed_mode() && !words.has('F'))
    state_.words.feed = 0;
  return set_length(words, length) && compensation_.apply(words, compensation);
}

// WCS-1, WCS-2
bool Settings::select_work(const Words& words, const CodeRow& row) {
  WorkSystem work;
  const bool first = row.meaning == Meaning::work_system && row.value == 0;
  const bool extended = row.meaning == Meaning::further_work_system || (first && words.has('P'));
  if (extended) {
    std::int64_t number = 1;
    if (words.has('P') && !state_.values.integer(words['P'], 0, 99999999, number)) return false;
    if (number < 1 || number > static_cast<std::int64_t>(kExtendedSystems)) {
      return state_.alarms.raise(Code::illegal_offset_number, words['P'].text,
                                 "G54.1 takes P1 to P300");
    }
    work.extended = static_cast<std::uint32_t>(number);
    state_.words.extended_work = number;
    state_.modal.set(Meaning::further_work_system);
  } else {
    work.index = static_cast<std::uint32_t>(row.value);
  }
  state_.coordinates.select(work);
  return true;
}

double Settings::length_of(std::int64_t number) const {
  const ToolOffset& tool = state_.memory.tools[static_cast<std::size_t>(number)];
  return base::tidy(tool.length_geometry + tool.length_wear);
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
  const Meaning mode = state_.modal[Group::length];
  if (!switched && !(words.has('H') && mode != Meaning::length_off)) return true;
  Axis axis = state_.length_axis;
  if (switched && mode != Meaning::length_off) {
    if (!find_length_axis(words, axis)) return state_.alarms.raise(Code::no_length_axis);
    if (axis != state_.length_axis) state_.set_length(state_.length_axis, 0);
    state_.length_axis = axis;
  }
  const double offset = length_of(state_.words.length_offset);
  if (std::fabs(offset) > kMostOffset)
    return state_.alarms.raise(
        Code::illegal_offset_value,
        "H" + std::to_string(state_.words.length_offset) + " is " + base::number_text(offset));
  state_.wanted_length = mode == Meaning::length_off    ? 0
                         : mode == Meaning::length_plus ? offset
                                                        : -offset;
  if (switched && mode != Meaning::length_off && state_.words.length_offset == 0) {
    state_.assume(Assumed::no_offset, "G43 or G44 without an offset number: length offset 0");
  }
  moves_.apply_length(base::only(axis));
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
  ProgramPoint centre = state_.coordinates.program();
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
  ProgramPoint values = state_.coordinates.program();
  AxisSet named = 0;
  if (!targets_.values(words, values, named)) return false;
  Transform transform = state_.coordinates.transform();
  for (std::size_t i = 0; i < state_.axes.count(); ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    if (on && base::contains(named, axis)) transform.mirror(axis, values[axis]);
    if (!on && (named == 0 || base::contains(named, axis))) transform.cancel_mirror(axis);
  }
  state_.coordinates.set_transform(transform);
  state_.modal.set(transform.mirrored() != 0 ? Meaning::mirror_on : Meaning::mirror_off);
  return true;
}

// Of a lathe: X of the second turret counts from the other side of the work's zero.
void Settings::set_turret(bool second) {
  const auto x = state_.axes.find('X');
  if (!x) return;
  Transform transform = state_.coordinates.transform();
  transform.cancel_mirror(*x);
  if (second) transform.mirror(*x, 0);
  state_.coordinates.set_transform(transform);
}

bool Settings::set_rotation(const Words& words) {
  const auto plane = state_.plane();
  if (!plane)
    return state_.alarms.raise(Code::illegal_plane_axis, "the machine lacks an axis of the plane");
  ProgramPoint centre = state_.coordinates.program();
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
  ProgramPoint program = state_.coordinates.program();
  AxisSet named = 0;
  if (!targets_.values(words, program, named)) return false;
  state_.coordinates.preset(program);
  return true;
}

// G10.9: 0 is a radius, 1 a diameter.
bool Settings::switch_diameter(const Words& words) {
  for (std::size_t i = 0; i < state_.axes.count(); ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    const gcode::Word* const word = words.find(state_.axes[axis].letter);
    if (word == nullptr || !state_.axes[axis].diameter) continue;
    if (word->value != 0 && word->value != 1)
      return state_.alarms.raise(Code::improper_address_word, word->text,
                                 "0 is a radius, 1 a diameter");
    const auto others = static_cast<AxisSet>(state_.radius_words & ~base::only(axis));
    state_.radius_words =
        word->value == 0 ? static_cast<AxisSet>(others | base::only(axis)) : others;
  }
  state_.assume(Assumed::diameter_switch,
                "G10.9 makes words of X radii or diameters; offsets, variables and what cycles set "
                "stay diameters");
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
