#include "features/path/allowance.hpp"

namespace kerf::features {

bool Allowance::is_over() {
  if (is_over_) return true;
  if (limit_.reached()) {
    reason_ = limit_.reason();
  } else if (!tells_ && has_no_room()) {
    reason_ = "what is recognised needs more than " + std::to_string(bounds_.memory_bytes >> 20U) +
              " MiB";
  } else {
    return false;
  }
  is_over_ = true;
  return true;
}

// Who no longer wants it wants nothing told, either.
void Allowance::begin_telling() {
  tells_ = true;
  is_over_ = false;
  limit_ = base::WorkLimit(bounds_.seconds, bounds_.unwanted);
}

}  // namespace kerf::features
