#include "control/gcode/acts/state.hpp"

#include <algorithm>
#include <tuple>

namespace kerf::control {

void State::reset() {
  path.reset();
  if (path.surface() != nullptr) leave_surface();
  coordinates.set_transform({});
  for (std::size_t i = 0; i < axes.count(); ++i) {
    coordinates.set_local(base::Axis{static_cast<std::uint8_t>(i)}, 0);
  }
  for (std::size_t i = 0; i < axes.count(); ++i)
    set_length(base::Axis{static_cast<std::uint8_t>(i)}, 0);
  coordinates.select({});
  wanted_length = 0;
  wanted_offset = {};
  modal = ModalState(codes, parameters);
  before = modal;
  refresh_format();
  words = {};
  radius_words = 0;
  rigid_tapping = false;
  parameter_entry = false;
  block_control = feed_control = 0;
}

double State::most_rpm() const {
  if (words.spindle == motion::SpindleName::main) return parameters.spindle_max_rpm;
  const SpindleSettings* const settings = parameters.machine_codes.find(words.spindle);
  return settings == nullptr ? 0 : settings->most_rpm;
}

motion::Spindle State::spindle() const {
  const bool css = has_surface_speed();
  motion::Spindle spindle{
      .turning = words.turning,
      .mode = css ? motion::Spindle::Mode::constant_surface_speed : motion::Spindle::Mode::rpm,
      .speed = words.speed,
      .max_rpm = css ? words.max_rpm : 0,
      .name = words.spindle};
  if (!codes.habits().tool_brings_offset) return spindle;
  if (css) {
    measure_radius(spindle);
  } else if (const double most = most_rpm(); most > 0) {
    spindle.is_clamped = spindle.speed > most;
    spindle.speed = std::min(spindle.speed, most);
  }
  return spindle;
}

std::optional<motion::PlaneAxes> State::plane() const {
  const motion::Surface* const surface = path.surface();
  if (surface == nullptr) return motion::plane_axes(modal.plane(), axes);
  return motion::PlaneAxes{surface->first, surface->rotary, std::nullopt, 'I', 'J'};
}

void State::enter_surface(const motion::Surface& surface, double mm_per_degree) {
  path.enter(surface);
  coordinates.unroll(surface.rotary, mm_per_degree);
}

void State::leave_surface() {
  path.leave_surface();
  coordinates.roll_up(base::PathPoint(path.tip().numbers()));
}

ModalView State::modal_view() const {
  ModalView view;
  static_assert(kGroups <= std::tuple_size_v<decltype(view.codes)>);
  const auto numbers = modal.codes();
  std::copy(numbers.begin(), numbers.end(), view.codes.begin());
  view.feed = words.feed;
  view.speed = words.speed;
  view.further_system = coordinates.work().extended;
  view.length_offset = static_cast<std::uint32_t>(words.length_offset);
  view.radius_offset = static_cast<std::uint32_t>(words.radius_offset);
  view.tool_offset = static_cast<std::uint32_t>(words.turning_offset);
  return view;
}

}  // namespace kerf::control
