#pragma once

#include <cstdint>
#include <string>

#include "base/result.hpp"
#include "face/server/hub/part.hpp"
#include "job/stock_job.hpp"

namespace kerf::server {

/// Whether a text is a set-up (docs/set-up.md). Failure (usage): a sentence with its line.
[[nodiscard]] base::Outcome<void> check_set_up(const std::string& toml);

/// Whether somebody looks at the part, and sees it against the design of its set-up.
enum class Sight : std::uint8_t { none, against_design };

/// The job that cuts a part as it is set up; empty: as nobody has. Files that the set-up names are
/// those of `folder`. Waits for the disk.
[[nodiscard]] base::Outcome<job::StockJob> part_job(const PartSource& source,
                                                    const std::string& set_up,
                                                    const std::string& folder, Sight sight);

}  // namespace kerf::server
