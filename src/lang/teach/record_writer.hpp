#pragma once

#include <string>
#include <string_view>

#include "lang/teach/record.hpp"

namespace kerf::teach {

/// Appends a record as one line without its end, in the form that the writer always uses: capitals,
/// one blank between words, of every number the fewest digits that read back to the same double (at
/// most 17). So what is read again is the same record to the last bit, -0 included, and writing
/// that gives the same bytes.
void append_record(std::string& out, const Record& record);

/// A line with a comment, and one that has it behind a record. `text` is what follows the
/// semicolon; line ends in it become blanks.
void append_comment(std::string& out, std::string_view text);

/// One line with its end: a record, a comment, both or neither.
void append_line(std::string& out, const Record* record, const std::string_view* comment);

}  // namespace kerf::teach
