#include "control/gcode/codes/modal_list.hpp"

#include "control/gcode/codes/code_table.hpp"

namespace kerf::control {

// Groups without a code, 0 and 18, have nothing to show.
std::vector<std::string> modal_list(const ModalView& modal) {
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
