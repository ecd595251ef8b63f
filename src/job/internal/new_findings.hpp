#pragma once

#include <string>
#include <vector>

#include "job/edit_run.hpp"
#include "job/stock_job.hpp"

namespace kerf::job {

/// What cutting an edited program finds that cutting the original did not.
struct NewFindings {
  std::vector<std::string> found{};  ///< a sentence each, with its line of the edited program
  std::string skipped{};             ///< why the two were not compared; empty: they were
};

/// Cuts both programs from the same stock, as coarsely as a look at collisions allows. A finding
/// was there before if the original has one with its code in the block that has become its block.
/// `changes`: what makes the texts of `before` those of `after`.
[[nodiscard]] NewFindings new_findings(const StockJob& before, const StockJob& after,
                                       const std::vector<TextChange>& changes);

}  // namespace kerf::job
