#include "base/work_limit.hpp"

#include "base/decimal.hpp"

namespace kerf::base {

std::string WorkLimit::reason() const {
  if (unwanted()) return "nobody waits for it any more";
  return number_text(seconds_) + " s of computing are over";
}

}  // namespace kerf::base
