#pragma once

#include "base/result.hpp"
#include "face/cli/commands.hpp"
#include "job/drawing/draw_order.hpp"

namespace kerf::cli {

/// What the words of `kerf draw` come to, with what they left open. Failure (usage): an option is
/// wrong; (input): the job, materials or the machine cannot be read.
struct Ordered {
  job::DrawOrder order;
  std::vector<std::string> assumed;
};
[[nodiscard]] base::Outcome<Ordered> draw_order_of(const DrawOptions& options);

}  // namespace kerf::cli
