#include "control/gcode/codes/modal_state.hpp"

namespace kerf::control {

ModalState::ModalState(const CodeTable& codes, const Parameters& parameters) : codes_(&codes) {
  for (const CodeRow& row : codes.codes()) {
    if (row.power_on) set(row);
  }
  if (parameters.power_on_line) set(Meaning::line);
  set(parameters.power_on_inch ? Meaning::inch : Meaning::millimetre);
}

motion::Plane ModalState::plane() const {
  switch ((*this)[Group::plane]) {
    case Meaning::plane_zx: return motion::Plane::zx;
    case Meaning::plane_yz: return motion::Plane::yz;
    default: return motion::Plane::xy;
  }
}

motion::FeedMode ModalState::feed_mode() const {
  switch ((*this)[Group::feed]) {
    case Meaning::per_revolution: return motion::FeedMode::per_revolution;
    case Meaning::inverse_time: return motion::FeedMode::inverse_time;
    default: return motion::FeedMode::per_minute;
  }
}

std::array<GCode, kGroups> ModalState::codes() const {
  std::array<GCode, kGroups> numbers{};
  for (std::size_t i = 0; i < kGroups; ++i) numbers[i] = rows_[i] == nullptr ? 0 : rows_[i]->number;
  return numbers;
}

double ModalState::variable(std::size_t group_number) const {
  const Group group = group_number == 0 ? Group::none : codes_->group_of(group_number);
  const CodeRow* const row = group == Group::none ? nullptr : rows_[index(group)];
  return row == nullptr ? -1 : row->number / 10.0;
}

}  // namespace kerf::control
