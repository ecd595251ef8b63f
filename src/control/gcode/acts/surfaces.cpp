#include "control/gcode/acts/surfaces.hpp"

#include <algorithm>

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"
#include "geometry/angle.hpp"

namespace kerf::control {
namespace {

using base::Code;
using motion::Surface;

bool is_cut(Meaning motion) {
  return motion == Meaning::line || motion == Meaning::arc_clockwise ||
         motion == Meaning::arc_counterclockwise;
}

bool is_on_face(const State& state) {
  return state.path.surface() != nullptr && state.path.surface()->kind == Surface::Kind::face;
}

Code misplaced(const State& state) {
  return is_on_face(state) ? Code::illegal_in_polar : Code::illegal_in_cylinder;
}

bool suits_face(const CodeRow& row) {
  switch (row.group) {
    case Group::motion: return is_cut(row.meaning);
    case Group::one_shot:
      return row.meaning == Meaning::dwell || row.meaning == Meaning::macro_call;
    case Group::compensation:
    case Group::modal_call:
    case Group::speed:
    case Group::feed:
    case Group::distance:
    case Group::polar_interpolation: return true;
    default: return false;
  }
}

bool suits_cylinder(const CodeRow& row) {
  switch (row.group) {
    case Group::motion: return is_cut(row.meaning);
    case Group::one_shot:
      return row.meaning == Meaning::dwell || row.meaning == Meaning::macro_call ||
             row.meaning == Meaning::data_setting ||
             row.meaning == Meaning::cylindrical_interpolation;
    case Group::cycle: return row.meaning == Meaning::cycle_off;
    case Group::polar_interpolation: return row.meaning == Meaning::polar_interpolation_off;
    case Group::work: return false;
    default: return true;
  }
}

}  // namespace

bool suits_surface(State& state, Meaning motion) {
  if (state.path.surface() == nullptr || is_cut(motion)) return true;
  return state.alarms.raise(misplaced(state), "only G01, G02 and G03 move here");
}

bool Surfaces::check(const Words& words) {
  const bool on_surface = state_.path.surface() != nullptr;
  for (const Words::G* g = words.g_begin(); g != words.g_end(); ++g) {
    if (g->row == nullptr) continue;
    const bool on = g->meaning() == Meaning::polar_interpolation_on;
    const bool off = g->meaning() == Meaning::polar_interpolation_off && is_on_face(state_);
    if ((on || off) && !check_alone(words, *g)) return false;
    if (!on_surface || off) continue;
    const bool suits = is_on_face(state_) ? suits_face(*g->row) : suits_cylinder(*g->row);
    if (!suits) return state_.alarms.raise(misplaced(state_), g->word->text);
  }
  return true;
}

bool Surfaces::check_alone(const Words& words, const Words::G& g) {
  const bool alone =
      (words.present() & ~Words::mask("GN")) == 0 && words.g_end() - words.g_begin() == 1;
  if (!alone)
    return state_.alarms.raise(Code::polar_misuse, g.word->text,
                               "it must stand alone in its block");
  return g.meaning() == Meaning::polar_interpolation_off || !is_on_face(state_) ||
         state_.alarms.raise(Code::polar_misuse, g.word->text, "it is in force already");
}

// Corners and compensation do not go on into another plane. An offset that G40 has left to the next
// move stays where it is: that move has no plane to lose it in.
bool Surfaces::may_switch(Code code) {
  if (state_.modal.compensating()) return state_.alarms.raise(code, "G41 or G42 is in force");
  if (!state_.path.release()) return false;
  if (state_.path.compensating()) state_.path.go_back_to(state_.path.tip());
  return true;
}

bool Surfaces::find_axes(char first, Surface& surface) const {
  const auto linear = state_.axes.find(first);
  const auto rotary = state_.axes.find('C');
  if (!linear || !rotary || !state_.axes[*rotary].rotary) return false;
  surface.first = *linear;
  surface.rotary = *rotary;
  return true;
}

bool Surfaces::apply(const Words& words) {
  if (words.has_g(Meaning::polar_interpolation_off) && is_on_face(state_)) {
    if (!may_switch(Code::polar_misuse)) return false;
    state_.leave_surface();
  }
  return !words.has_g(Meaning::polar_interpolation_on) || begin_face();
}

bool Surfaces::begin_face() {
  Surface surface;
  if (!find_axes('X', surface))
    return state_.alarms.raise(Code::polar_misuse, "the machine needs a linear X and a rotary C");
  if (!may_switch(Code::polar_misuse)) return false;
  if (state_.modal.feed_mode() == motion::FeedMode::per_revolution)
    state_.assume(Assumed::polar_per_revolution,
                  "G12.1 with feed per revolution: F counts turns of the spindle, not mm/min");
  const base::TipPoint tip = state_.path.tip();
  surface.centre_mm = state_.coordinates.origin()[surface.first];
  surface.zero_deg = tip[surface.rotary];
  surface.side = tip[surface.first] < surface.centre_mm ? -1 : 1;
  state_.enter_surface(surface, 0);
  return true;
}

// The word is the radius of the cylinder, 0 the end.
bool Surfaces::cylinder(const Words& words) {
  Surface surface{.kind = Surface::Kind::cylinder};
  if (!find_axes('Z', surface))
    return state_.alarms.raise(Code::cylinder_misuse,
                               "the machine needs a linear Z and a rotary C");
  const gcode::Word* const word = words.find('C');
  if (word == nullptr || (words.present() & ~Words::mask("GNC")) != 0 ||
      words.g_end() - words.g_begin() != 1) {
    return state_.alarms.raise(Code::cylinder_misuse,
                               "G07.1 stands with the radius C alone in its block");
  }
  double radius_mm = 0;
  if (!state_.values.length(*word, radius_mm)) return false;
  if (radius_mm < 0)
    return state_.alarms.raise(Code::cylinder_misuse, word->text, "a radius is not negative");
  if (!may_switch(Code::cylinder_misuse)) return false;
  if (state_.path.surface() != nullptr) state_.leave_surface();
  if (radius_mm == 0) return true;
  surface.radius_mm = radius_mm;
  state_.enter_surface(surface, geometry::radians(radius_mm));
  return true;
}

}  // namespace kerf::control
