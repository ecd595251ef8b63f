#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "base/text_stretch.hpp"
#include "job/edit_result.hpp"

namespace kerf::job {

/// Where changes stand in the text that they change. Lines count as those of a program do. The
/// error is a line, from 1, at which the text has not the lines of a change, or that comes before
/// the change before it.
[[nodiscard]] tl::expected<std::vector<base::TextStretch>, std::uint32_t> stretches_of(
    std::string text, std::span<const TextChange> changes);

/// Where a line, from 1, begins; the end of the text where it has not so many.
[[nodiscard]] std::size_t start_of_line(std::string text, std::uint32_t line);

/// The text with something else in its stretches. Precondition: they lie in it.
[[nodiscard]] std::string with_stretches(std::string_view text,
                                         std::span<const base::TextStretch> stretches);

/// The changes that take changes of one text back, as they stand in the text that those have left.
[[nodiscard]] std::vector<TextChange> taken_back(std::span<const TextChange> changes);

}  // namespace kerf::job
