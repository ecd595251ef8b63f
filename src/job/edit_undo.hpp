#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "base/text_stretch.hpp"
#include "job/edit_result.hpp"

namespace kerf::job {

/// What a report of an edit says of one text.
struct TextUndo {
  std::string file{};  ///< as the edit knew it
  bool is_main = true;
  std::uint32_t crc32 = 0;            ///< of what the edit has left
  std::vector<TextChange> changes{};  ///< as the edit made them, in the order of the text
};

/// Reads a report of `kerf edit` (output/features/edit_report.hpp): the main text first, which is
/// always there, then others. The error is a sentence.
[[nodiscard]] tl::expected<std::vector<TextUndo>, std::string> read_edit_report(
    const std::string& text);

/// The first line, from 1, at which a text is not what an edit has left; 0: it is somewhere else.
struct ChangedSince {
  std::uint32_t line = 0;
};

/// What takes an edit of a text back, to the byte.
[[nodiscard]] tl::expected<std::vector<base::TextStretch>, ChangedSince> undo_of(
    const TextUndo& undo, const std::string& text);

}  // namespace kerf::job
