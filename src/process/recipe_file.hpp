#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "base/diagnostic.hpp"
#include "process/recipe.hpp"

namespace kerf::process {

using Diagnostics = std::vector<base::Diagnostic>;

/// What a job file says (its keys: keys.def), or what is wrong with it, in the order of its lines:
/// JOB_KEY and JOB_VALUE with line and column. `source` is its name, `file` its number in the
/// sources of whoever prints the findings. All of the file is read; at most 100 findings are told.
[[nodiscard]] tl::expected<Recipe, Diagnostics> read_recipe(const std::string& text,
                                                            const std::string& source,
                                                            base::FileId file);

/// KEY=VALUE of --job-set: "place.scale", "operation.outline.feed", "operation.1.lead_in.length",
/// "text.serial.start". An operation is named by its name, or counted from 1. The value is as in
/// the file, texts and words also without quotes. What a key stands instead of gives way: `power`
/// to ton_ms and toff_ms. Returns what is wrong, and changes nothing then.
[[nodiscard]] Diagnostics set(Recipe& recipe, std::string_view key, std::string_view value);

/// What does not go together: JOB_VALUE of each, without a place. read_recipe() has told that of
/// its file; this is for a recipe that was changed since.
[[nodiscard]] Diagnostics contradictions(const Recipe& recipe);

}  // namespace kerf::process
