#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "job/edit_scene.hpp"

namespace kerf::server {

/// What the loaded program of a machine machines: recognised once, and kept for the edits that are
/// tried on it. Belongs to the thread of the sockets; what is made in it belongs to one thread at a
/// time, that of the job whose owner it is.
struct FeatureScene {
  using Made = base::Outcome<std::shared_ptr<job::EditScene>>;
  /// Who waits for it gets it, or why there is none.
  using Waiting = std::function<void(const base::Outcome<std::shared_ptr<FeatureScene>>&)>;

  std::uint32_t revision = 0;
  std::stop_source unwanted{};
  std::optional<Made> made{};            ///< none: not yet; a failure is kept, too
  std::optional<std::string> insight{};  ///< of its run, as soon as that is over: JSON members
  std::vector<Waiting> waiting{};
  std::uint64_t used = 0;  ///< the last one to be used has the greatest
};

}  // namespace kerf::server
