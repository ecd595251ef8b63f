#pragma once

#include "job/edit_result.hpp"
#include "output/features/edit_facts.hpp"

namespace kerf::job {

/// What an edit has done, for reports.
[[nodiscard]] output::EditFacts facts_of(const EditResult& result);

}  // namespace kerf::job
