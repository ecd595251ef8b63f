#include "planner/interpolator.hpp"

namespace kerf::planner {

// Makes the next section the one under way. False when what is known of the path is not enough.
bool Interpolator::load_section() {
  Section section;
  if (!ahead_.next_section(wishes_.overrides(), section)) return false;
  drive_.begin(section);
  return true;
}

bool Interpolator::next(motion::Setpoint& point) {
  wishes_.grant();
  if (wishes_.held()) {
    drive_.stand(point);
    return true;
  }
  while (drive_.driving() || load_section()) {
    switch (drive_.next(point)) {
      case SectionDrive::Step::point: return true;
      case SectionDrive::Step::at_rest: wishes_.come_to_rest(); return true;
      case SectionDrive::Step::over: break;
    }
  }
  return false;
}

void Interpolator::skip() {
  while (drive_.driving() || load_section()) drive_.skip();
}

}  // namespace kerf::planner
