#include "control/gcode/acts/state.hpp"

#include <algorithm>
#include <tuple>

namespace kerf::control {

void State::reset() {
  path.reset();
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
  rigid_tapping = false;
  parameter_entry = false;
  block_control = feed_control = 0;
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
  return view;
}

}  // namespace kerf::control
