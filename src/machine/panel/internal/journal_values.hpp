#pragma once

#include <cstdint>
#include <string>

#include "control/core/memory.hpp"
#include "machine/panel/argument.hpp"

namespace kerf::machine {

/// What a journal cannot hold, or does not: thrown by all that reads and writes its values, caught
/// by journal_text() and read_journal().
struct NoJournal {
  std::string sentence;
};

// Each throws NoJournal where the value is missing or of another kind; `where` names it.

[[nodiscard]] const Json& field(const Json& object, const char* key);
[[nodiscard]] double number_in(const Json& object, const char* key);
[[nodiscard]] std::uint64_t count_in(const Json& object, const char* key);
[[nodiscard]] const Json& list_in(const Json& object, const char* key, std::size_t most);
/// Text that is no UTF-8 stands as `{"latin1":…}`, a character for each byte.
[[nodiscard]] std::string text_in(const Json& object, const char* key);
[[nodiscard]] Json text_json(const std::string& text);

/// Numbers of all axes.
[[nodiscard]] Json axes_json(const base::AxisVector& values);
[[nodiscard]] base::AxisVector axes_in(const Json& object, const char* key);

/// All of it: what a state file keeps, and the variables that a reset empties.
[[nodiscard]] Json memory_json(const control::Memory& memory);
/// `memory`: one of the machine, new.
[[nodiscard]] control::Memory memory_in(const Json& object, const char* key,
                                        control::Memory memory);

}  // namespace kerf::machine
