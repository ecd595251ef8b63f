// What a machining centre shows of its modes: one code a group, and the offsets that are on.
#include <algorithm>
#include <tuple>

#include "control/gcode/controller.hpp"

namespace kerf::control {

ModalView Controller::modal() const {
  ModalView view;
  static_assert(kGroups <= std::tuple_size_v<decltype(view.codes)>);
  const auto codes = state_.modal.codes();
  std::copy(codes.begin(), codes.end(), view.codes.begin());
  view.feed = state_.words.feed;
  view.speed = state_.words.speed;
  view.further_system = state_.coordinates.work().extended;
  view.length_offset = static_cast<std::uint32_t>(state_.words.length_offset);
  view.radius_offset = static_cast<std::uint32_t>(state_.words.radius_offset);
  return view;
}

// Groups without a code, 0 and 18, have nothing to show.
std::vector<std::string> Controller::modal_text(const ModalView& modal) const {
  std::vector<std::string> list;
  for (std::size_t group = 1; group < kGroups; ++group) {
    const bool is_motion = group == static_cast<std::size_t>(Group::motion);
    if (modal.codes[group] != 0 || is_motion) list.push_back(name_of(modal.codes[group]));
    if (group == static_cast<std::size_t>(Group::work) && modal.further_system != 0)
      list.back() += " P" + std::to_string(modal.further_system);
  }
  if (modal.length_offset != 0) list.push_back("H" + std::to_string(modal.length_offset));
  if (modal.radius_offset != 0) list.push_back("D" + std::to_string(modal.radius_offset));
  return list;
}

}  // namespace kerf::control
