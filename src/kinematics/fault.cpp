#include "kinematics/fault.hpp"

namespace kerf::kinematics {

std::string_view name_of(Fault::Kind kind) {
  switch (kind) {
    case Fault::Kind::out_of_reach: return "OUT_OF_REACH";
    case Fault::Kind::singular: return "SINGULAR";
    case Fault::Kind::limit: return "LIMIT";
  }
  return {};
}

}  // namespace kerf::kinematics
