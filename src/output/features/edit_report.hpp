#pragma once

#include <string>

#include "output/features/edit_facts.hpp"

namespace kerf::output {

/// The report of an edit as one JSON object. Lines of a program keep every byte: those of a change
/// that are not all UTF-8 have a character U+0000 to U+00FF for each byte, and the change says so
/// by "encoding":"latin-1". "libraries" is there where files beside the program change.
[[nodiscard]] std::string edit_report_json(const EditFacts& facts);

// Members of it, as JSON.

[[nodiscard]] std::string changes_json(const EditFacts& facts);
[[nodiscard]] std::string blocks_json(const EditFacts& facts);
[[nodiscard]] std::string warnings_json(const EditFacts& facts);
/// Lines of a program: those that are not all UTF-8 as characters U+0000 to U+00FF.
[[nodiscard]] std::string text_json(const std::string& text);

/// The same in a few lines for people.
[[nodiscard]] std::string edit_report_text(const EditFacts& facts);

}  // namespace kerf::output
