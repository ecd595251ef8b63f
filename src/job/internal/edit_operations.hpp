#pragma once

#include <string>

#include "features/edit/edit.hpp"
#include "job/internal/json_members.hpp"

namespace kerf::job {

/// What the operations of one file share while they are read.
struct EditReading {
  const PlacedJson& json;
  bool turns = false;
  std::size_t points = 0;  ///< of contours, so far
};

/// Which members, besides its own, an operation takes.
struct EditTakes {
  bool layer = false;
  bool island = false;
  bool rule = false;   ///< `layers`
  bool target = true;  ///< a feature, a hole or a pattern
  bool call = false;
};

struct ReadOperation {
  features::EditOperation operation{};
  EditTakes takes{};
};

/// Reads the members of the operation `op`. Throws Misread.
[[nodiscard]] ReadOperation read_operation(EditReading& reading, JsonMembers& members);

}  // namespace kerf::job
