#include "control/gcode/acts/targets.hpp"

#include "base/decimal.hpp"
#include "control/core/assumed.hpp"
#include "geometry/angle.hpp"

namespace kerf::control {

using base::Axis;
using gcode::Word;
using gcode::WordFlag;

namespace {

// The letter of ways along an axis where letters say what is a way; 0: it has none.
char letter_of_ways(char axis) {
  switch (axis) {
    case 'X': return 'U';
    case 'Y': return 'V';
    case 'Z': return 'W';
    case 'C': return 'H';
    default: return 0;
  }
}

// What a bare number counts follows from the axis, not from the letter of ways along it.
Word as_of_axis(Word word, char letter) {
  word.letter = letter;
  return word;
}

}  // namespace

void Targets::learn_letters() {
  letters_ = 0;
  for (const motion::AxisConfig& axis : state_.axes.axes) {
    letters_ |= Words::mask(axis.letter);
    const char way = ways_have_letters() ? letter_of_ways(axis.letter) : '\0';
    if (way != 0) letters_ |= Words::mask(way);
  }
}

const Word* Targets::word_of(const Words& words, Axis axis) const {
  const char letter = state_.axes[axis].letter;
  const Word* const point = words.find(letter);
  if (!ways_have_letters()) return point;
  const char way_letter = letter_of_ways(letter);
  const Word* const way = way_letter != 0 ? words.find(way_letter) : nullptr;
  return way != nullptr && (point == nullptr || way > point) ? way : point;  // LAT-2
}

base::AxisSet Targets::ways(const Words& words) const {
  base::AxisSet ways = 0;
  for (std::size_t i = 0; i < state_.axes.count(); ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    const Word* const word = word_of(words, axis);
    if (word != nullptr && is_way(*word, axis))
      ways = static_cast<base::AxisSet>(ways | base::only(axis));
  }
  return ways;
}

void Targets::tell_increments(const Word& word, bool angle) {
  const bool bare = word.has(WordFlag::literal) && !word.has(WordFlag::point) && word.value != 0;
  if (!bare || state_.parameters.calculator_point ||
      !state_.assumptions.is_new(Assumed::least_increments))
    return;
  const double unit = angle || !state_.modal.inch() ? 0.001 : 0.0001;
  const char* const name = angle ? " degrees" : state_.modal.inch() ? " inch" : " mm";
  state_.assumptions.add(state_.line,
                         std::string("a number without a decimal point counts least increments: ") +
                             word.letter + base::number_text(word.value) + " is " +
                             base::number_text(base::tidy(word.value * unit)) + name);
}

bool Targets::value(const Word& word, Axis axis, double& value) {
  const motion::Surface* const surface = state_.path.surface();
  const bool unrolled = surface != nullptr && surface->rotary == axis;
  const bool on_face = unrolled && surface->kind == motion::Surface::Kind::face;
  const Word as_written = as_of_axis(word, state_.axes[axis].letter);
  const bool angle = state_.axes[axis].rotary && !on_face;
  tell_increments(word, angle);
  if (angle) {
    if (!state_.values.angle(as_written, value)) return false;
    if (unrolled) value *= geometry::radians(surface->radius_mm);
    return true;
  }
  if (!state_.values.length(as_written, value)) return false;
  if (!base::contains(state_.radius_words, axis)) value /= state_.axes[axis].count_per_mm();
  return true;
}

bool Targets::values(const Words& words, base::AxisVector& values, base::AxisSet& named) {
  for (std::size_t i = 0; i < state_.axes.count(); ++i) {
    const Axis axis{static_cast<std::uint8_t>(i)};
    const Word* const word = word_of(words, axis);
    if (word == nullptr) continue;
    double number = 0;
    if (!value(*word, axis, number)) return false;
    values[axis] = is_way(*word, axis) ? base::tidy(values[axis] + number) : number;
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
    const Word* const word = word_of(words, axis);
    if (word == nullptr) continue;
    double number = 0;
    if (!value(*word, axis, number)) return false;
    const bool way = incremental || is_way(*word, axis);
    target.program[axis] = way ? base::tidy(target.program[axis] + number) : number;
    target.named = static_cast<base::AxisSet>(target.named | base::only(axis));
  }
  return command(target.named);
}

bool Targets::command(base::AxisSet named) {
  state_.commanded = static_cast<base::AxisSet>(state_.commanded | named);
  if (state_.c_axis_is_on) return true;
  const auto c = state_.axes.find('C');
  return !c || !base::contains(named, *c) || state_.alarms.raise(base::Code::c_axis_is_off);
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
  return command(target.named);
}

}  // namespace kerf::control
