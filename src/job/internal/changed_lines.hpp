#pragma once

#include <string>
#include <vector>

#include "features/merge/merge.hpp"
#include "job/edit_result.hpp"

namespace kerf::job {

/// The lines of a file that replacements change, in their order.
[[nodiscard]] std::vector<TextChange> changes_of(
    const std::string& file, const std::string& text,
    const std::vector<features::Replacement>& replacements);

}  // namespace kerf::job
