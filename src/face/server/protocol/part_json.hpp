#pragma once

#include "face/server/protocol/json.hpp"
#include "job/live/live_part.hpp"
#include "job/live/part_sight.hpp"

namespace kerf::server {

/// What all who look at a part are told of it, for the event `stock`. On the thread that cuts it.
[[nodiscard]] Json part_json(const job::PartProgress& progress);

/// What one who looks is told besides.
[[nodiscard]] Json sight_json(const job::PartLook& look);

/// The answer of `stock_probe`.
[[nodiscard]] Json place_json(const std::optional<job::PartAnswer>& answer);

}  // namespace kerf::server
