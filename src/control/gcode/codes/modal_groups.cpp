#include "control/gcode/codes/modal_groups.hpp"

#include <array>

namespace kerf::control {
namespace {

constexpr std::array kGroupsForPeople = {
    ModalGroup{Group::motion, "motion"},
    ModalGroup{Group::cycle, "cycle"},
    ModalGroup{Group::plane, "plane"},
    ModalGroup{Group::distance, "distance"},
    ModalGroup{Group::feed, "feed"},
    ModalGroup{Group::unit, "unit"},
    ModalGroup{Group::compensation, "compensation"},
    ModalGroup{Group::length, "length"},
    ModalGroup{Group::work, "work"},
    ModalGroup{Group::stop_mode, "stop-mode"},
    ModalGroup{Group::rotation, "rotation"},
    ModalGroup{Group::scaling, "scaling"},
    ModalGroup{Group::mirror, "mirror"},
    ModalGroup{Group::cycle_return, "cycle-return"},
    ModalGroup{Group::speed, "speed"},
    ModalGroup{Group::modal_call, "modal-call"},
    ModalGroup{Group::stroke, "stroke"},
    ModalGroup{Group::polar, "polar"},
    ModalGroup{Group::normal_direction, "normal-direction"},
    ModalGroup{Group::in_feed, "in-feed"},
    ModalGroup{Group::polar_interpolation, "polar-interpolation"},
    ModalGroup{Group::turrets, "turrets"},
    ModalGroup{Group::spindle_watch, "spindle-watch"}};

}  // namespace

std::span<const ModalGroup> modal_groups() { return kGroupsForPeople; }

bool says_nothing_special(const CodeRow& row) {
  if (row.group == Group::motion || row.group == Group::work) return false;
  return row.power_on || row.meaning == Meaning::millimetre;
}

}  // namespace kerf::control
