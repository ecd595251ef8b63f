#pragma once

#include "base/work_limit.hpp"
#include "face/server/protocol/json.hpp"
#include "face/server/store/chunk_store.hpp"

namespace kerf::server {

/// What `speeds` asks for of the chunks of a run.
struct SpeedQuestion {
  double from_s = 0;
  double to_s = 0;
  std::size_t points = 2;  ///< >= 2
};

/// `{time_s, speed_mm_min, line}`: lists of equal length. Times are the begins of `points` equal
/// intervals; each has the fastest segment that reaches into it, none where nothing moves. Chunks
/// behind the limit are left out.
[[nodiscard]] Json speed_profile(const ChunkStore& chunks, const SpeedQuestion& question,
                                 const base::WorkLimit& limit);

}  // namespace kerf::server
