#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "base/source_file.hpp"
#include "face/cli/commands.hpp"
#include "job/drawing/draw_order.hpp"

namespace kerf::cli {

/// What the words of `kerf draw` come to, with what they left open.
struct Ordered {
  job::DrawOrder order;
  std::vector<std::string> assumed;
};

/// Why there is no order: an option is wrong or a file cannot be read; or what is wrong in the job.
struct JobFault {
  std::optional<base::Failure> failure;
  std::vector<base::Diagnostic> wrong;
};

/// `sources` gets the job file, which places in it refer to.
[[nodiscard]] tl::expected<Ordered, JobFault> draw_order_of(const DrawOptions& options,
                                                            base::SourceSet& sources);

}  // namespace kerf::cli
