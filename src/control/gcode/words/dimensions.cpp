#include "control/gcode/words/dimensions.hpp"

namespace kerf::control {

bool cuts_line(const Words& words, const ModalState& modal) {
  Meaning motion = modal[Group::motion];
  bool in_cycle = modal.in_cycle();
  for (const Words::G* g = words.g_begin(); g != words.g_end(); ++g) {
    if (g->row == nullptr) continue;
    if (g->row->axis_words != AxisWords::motion) return false;
    if (g->group() == Group::cycle) in_cycle = g->meaning() != Meaning::cycle_off;
    if (g->group() == Group::motion) {
      motion = g->meaning();
      in_cycle = false;
    }
  }
  return motion == Meaning::line && !in_cycle;
}

}  // namespace kerf::control
