#include "kinematics/fault.hpp"

namespace kerf::kinematics {

base::Code code_of(Fault::Kind kind) {
  switch (kind) {
    case Fault::Kind::out_of_reach: return base::Code::out_of_reach;
    case Fault::Kind::singular: return base::Code::singular;
    case Fault::Kind::limit: return base::Code::joint_limit;
  }
  return {};
}

std::string_view name_of(Fault::Kind kind) { return base::text_of(code_of(kind)).number; }

}  // namespace kerf::kinematics
