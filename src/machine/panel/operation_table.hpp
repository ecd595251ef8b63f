#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "machine/panel/argument.hpp"
#include "machine/panel/operation.hpp"

namespace kerf::machine {

/// How a key of the panel is written: `{"do":"jog","axis":"X","speed_mm_min":1000}`. The protocol
/// of the panel and journals speak so.
struct OperationRow {
  std::string_view name;
  std::vector<Argument> arguments;
  std::string_view sentence;  ///< what it does
  /// Of arguments that have passed check_arguments(). Failure (usage): they do not go together.
  base::Outcome<Operation> (*read)(const Arguments& arguments);
};

/// All keys but those that no operator presses by a word: Load, SetMemory, Raise.
[[nodiscard]] const std::vector<OperationRow>& operation_table();
/// Null: there is no such key.
[[nodiscard]] const OperationRow* find_operation(std::string_view name);

/// The key as its row reads it. Precondition: it has one.
[[nodiscard]] Json json_of(const Operation& key);

/// A breakpoint as an entry of `breakpoints`, and back.
[[nodiscard]] Json entry_of(const Breakpoint& breakpoint);
[[nodiscard]] Breakpoint breakpoint_of(const Arguments& entry);
[[nodiscard]] Argument breakpoint_list();

/// Levels of block skip as a list, and back.
[[nodiscard]] Json levels_of(std::uint32_t bits);
[[nodiscard]] std::uint32_t bits_of(const std::vector<std::int64_t>& levels);

}  // namespace kerf::machine
