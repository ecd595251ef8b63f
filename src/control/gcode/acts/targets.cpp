#include "control/gcode/acts/targets.hpp"

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"
#include "geometry/angle.hpp"

namespace kerf::control {

using base::Axis;
using gcode::WordFlag;

void Targets::learn_letters() {
  letters_ = 0;
  for (const motion::AxisConfig& axis : state_.axes.axes) letters_ |= Words::mask(axis.letter);
}

bool Targets::value(const gcode::Word& word, Axis axis, double& value) {
  const bool rotary = state_.axes[axis].rotary;
  const bool bare = word.has(WordFlag::literal) && !word.has(WordFlag::point) && word.value != 0;
  if (bare && !state_.parameters.calculator_point &&
      state_.assumptions.is_new(Assumed::least_increments)) {
    const double unit = rotary || !state_.modal.inch() ? 0.001 : 0.0001;
    const char* const name = rotary ? " degrees" : state_.modal.inch() ? " inch" : " mm";
    state_.assumptions.add(
        state_.line, std::string("a number without a decimal point counts least increments: ") +
                         word.letter + base::number_text(word.value) + " is " +
                         base::number_text(base::tidy(word.value * unit)) + name);
  }
  return rotary ? state_.values.angle(word, value) : state_.values.length(word, value);
}

bool Targets::values(const Words& words, base::AxisVector& values, base::AxisSet& named) {
  for (std::size_t i = 0; i < state_.axes.count(); ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    const gcode::Word* const word = words.find(state_.axes[axis].letter);
    if (word == nullptr) continue;
    if (!value(*word, axis, values[axis])) return false;
    named = static_cast<base::AxisSet>(named | base::only(axis));
  }
  return true;
}

bool Targets::read(const Words& words, Target& target) {
  target.program = state_.coordinates.program();
  target.named = 0;
  if (!words.has_any(letters_)) return true;
  if (state_.modal[Group::polar] == Meaning::polar_on) return read_polar(words, target);
  const bool incremental = state_.modal.incremental();
  for (std::size_t i = 0; i < state_.axes.count(); ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    const gcode::Word* const word = words.find(state_.axes[axis].letter);
    if (word == nullptr) continue;
    double number = 0;
    if (!value(*word, axis, number)) return false;
    target.program[axis] = incremental ? base::tidy(target.program[axis] + number) : number;
    target.named = static_cast<base::AxisSet>(target.named | base::only(axis));
  }
  return true;
}

// G16: the first axis of the plane is a radius, the second an angle. The origin is work zero for an
// absolute radius, the programmed point for an incremental one (docs/dialect.md §8.5).
bool Targets::read_polar(const Words& words, Target& target) {
  const auto plane = motion::plane_axes(state_.modal.plane(), state_.axes);
  if (!plane) return state_.alarms.raise(base::Code::illegal_plane_axis);
  const bool incremental = state_.modal.incremental();
  const gcode::Word* const radius = words.find(state_.axes[plane->first].letter);
  const gcode::Word* const angle = words.find(state_.axes[plane->second].letter);
  double number = 0;
  geometry::Vec2 origin;
  if (radius != nullptr) {
    if (!state_.values.length(*radius, radius_)) return false;
    if (incremental) origin = plane->project(target.program);
  }
  if (angle != nullptr) {
    if (!state_.values.angle(*angle, number)) return false;
    angle_deg_ = incremental ? angle_deg_ + number : number;
  }
  if (radius != nullptr || angle != nullptr) {
    const geometry::SineCosine turn = geometry::sine_cosine_deg(angle_deg_);
    plane->place(target.program, origin + radius_ * geometry::Vec2{turn.cosine, turn.sine});
    target.named = static_cast<base::AxisSet>(base::only(plane->first) | base::only(plane->second));
  }
  for (std::size_t i = 0; i < state_.axes.count(); ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    const gcode::Word* const word = words.find(state_.axes[axis].letter);
    if (plane->contains(axis) || word == nullptr) continue;
    if (!value(*word, axis, number)) return false;
    target.program[axis] = incremental ? base::tidy(target.program[axis] + number) : number;
    target.named = static_cast<base::AxisSet>(target.named | base::only(axis));
  }
  return true;
}

}  // namespace kerf::control
