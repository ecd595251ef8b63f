#pragma once

#include <string>

#include "output/features/edit_facts.hpp"

namespace kerf::output {

/// The report of an edit as one JSON object. Lines of a program keep every byte: those of a change
/// that are not all UTF-8 have a character U+0000 to U+00FF for each byte, and the change says so
/// by "encoding":"latin-1". "libraries" is there where files beside the program change.
[[nodiscard]] std::string edit_report_json(const EditFacts& facts);

/// The same in a few lines for people.
[[nodiscard]] std::string edit_report_text(const EditFacts& facts);

}  // namespace kerf::output
