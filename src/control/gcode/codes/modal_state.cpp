#include "control/gcode/codes/modal_state.hpp"

#include <algorithm>

namespace kerf::control {
namespace {

struct Entry {
  GCode code;
  Group group;
};

// Sorted by code. A code that is missing here is PS0010.
constexpr Entry kCodes[] = {{0, Group::motion},
                            {10, Group::motion},
                            {20, Group::motion},
                            {30, Group::motion},
                            {40, Group::one_shot},
                            {41, Group::one_shot},
                            {50, Group::one_shot},
                            {51, Group::one_shot},
                            {80, Group::one_shot},
                            {90, Group::one_shot},
                            {100, Group::one_shot},
                            {110, Group::one_shot},
                            {131, Group::polar_interpolation},
                            {150, Group::polar},
                            {160, Group::polar},
                            {170, Group::plane},
                            {180, Group::plane},
                            {190, Group::plane},
                            {200, Group::unit},
                            {210, Group::unit},
                            {220, Group::stroke},
                            {230, Group::stroke},
                            {270, Group::one_shot},
                            {280, Group::one_shot},
                            {290, Group::one_shot},
                            {300, Group::one_shot},
                            {310, Group::one_shot},
                            {330, Group::motion},
                            {400, Group::compensation},
                            {401, Group::normal_direction},
                            {410, Group::compensation},
                            {420, Group::compensation},
                            {430, Group::length},
                            {440, Group::length},
                            {450, Group::one_shot},
                            {460, Group::one_shot},
                            {470, Group::one_shot},
                            {480, Group::one_shot},
                            {490, Group::length},
                            {500, Group::scaling},
                            {501, Group::mirror},
                            {510, Group::scaling},
                            {511, Group::mirror},
                            {520, Group::one_shot},
                            {530, Group::one_shot},
                            {540, Group::work},
                            {541, Group::work},
                            {550, Group::work},
                            {560, Group::work},
                            {570, Group::work},
                            {580, Group::work},
                            {590, Group::work},
                            {600, Group::one_shot},
                            {610, Group::stop_mode},
                            {620, Group::stop_mode},
                            {630, Group::stop_mode},
                            {640, Group::stop_mode},
                            {650, Group::one_shot},
                            {660, Group::modal_call},
                            {661, Group::modal_call},
                            {670, Group::modal_call},
                            {680, Group::rotation},
                            {690, Group::rotation},
                            {730, Group::cycle},
                            {740, Group::cycle},
                            {760, Group::cycle},
                            {800, Group::cycle},
                            {810, Group::cycle},
                            {820, Group::cycle},
                            {830, Group::cycle},
                            {840, Group::cycle},
                            {850, Group::cycle},
                            {860, Group::cycle},
                            {870, Group::cycle},
                            {880, Group::cycle},
                            {890, Group::cycle},
                            {900, Group::distance},
                            {910, Group::distance},
                            {920, Group::one_shot},
                            {921, Group::one_shot},
                            {930, Group::feed},
                            {940, Group::feed},
                            {950, Group::feed},
                            {960, Group::speed},
                            {970, Group::speed},
                            {980, Group::cycle_return},
                            {990, Group::cycle_return},
                            {1600, Group::in_feed},
                            {1610, Group::in_feed}};

constexpr std::size_t kTableSize = 1024;

constexpr std::array<Group, kTableSize> make_table() {
  std::array<Group, kTableSize> table{};
  table.fill(Group::none);
  for (const Entry& entry : kCodes) {
    if (entry.code < kTableSize) table[entry.code] = entry.group;
  }
  return table;
}

constexpr std::array<Group, kTableSize> kTable = make_table();

}  // namespace

Group group_of(GCode code) {
  if (code < kTableSize) return kTable[code];
  const auto* const found = std::find_if(std::begin(kCodes), std::end(kCodes),
                                         [&](const Entry& entry) { return entry.code == code; });
  return found == std::end(kCodes) ? Group::none : found->group;
}

std::string name_of(GCode code) {
  const std::string number = std::to_string(code / 10);
  const std::string name = (number.size() < 2 ? "G0" : "G") + number;
  return code % 10 == 0 ? name : name + "." + std::to_string(code % 10);
}

ModalState::ModalState(const Parameters& parameters) {
  set(Group::motion, parameters.power_on_line ? 10 : 0);
  set(Group::plane, 170);
  set(Group::distance, 900);
  set(Group::stroke, 220);
  set(Group::feed, 940);
  set(Group::unit, parameters.power_on_inch ? 200 : 210);
  set(Group::compensation, 400);
  set(Group::length, 490);
  set(Group::cycle, 800);
  set(Group::cycle_return, 980);
  set(Group::scaling, 500);
  set(Group::modal_call, 670);
  set(Group::speed, 970);
  set(Group::work, 540);
  set(Group::stop_mode, 640);
  set(Group::rotation, 690);
  set(Group::polar, 150);
  set(Group::normal_direction, 401);
  set(Group::in_feed, 1600);
  set(Group::polar_interpolation, 131);
  set(Group::mirror, 501);
}

double ModalState::variable(std::size_t group_number) const {
  constexpr std::size_t kUnusedGroup = 18;
  if (group_number == 0 || group_number >= kGroups || group_number == kUnusedGroup) return -1;
  return codes_[group_number] / 10.0;
}

}  // namespace kerf::control
