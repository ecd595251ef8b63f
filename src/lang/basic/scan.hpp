#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/source_file.hpp"

namespace kerf::basic {

/// Where a page's text begins.
struct PageStart {
  std::uint64_t offset = 0;  ///< byte in the file
  std::uint32_t line = 1;
  std::uint32_t loops = 0;  ///< FORs before it
  std::uint32_t nexts = 0;  ///< NEXTs before it
};

/// What is known of a program before any of it is compiled: the interpreter's first pass over the
/// text (docs/laser-basic.md, Before the run). Its size is that of the labels, variables and loops.
struct Scan {
  static constexpr std::uint32_t kNoNext = ~0U;

  struct PlacedLabel {
    std::uint32_t number = 0;  ///< from 0 in the order of the text
    std::uint32_t line = 0;
  };

  std::unordered_map<std::string, PlacedLabel> labels;  ///< by name, in capitals
  std::vector<std::uint32_t> label_lines;               ///< by number
  std::unordered_map<std::string, std::uint32_t> variables;
  std::vector<std::string> variable_names;  ///< by number; those of FORs come first
  std::vector<std::uint32_t> next_of_loop;  ///< of each FOR the number of its NEXT
  std::uint32_t nexts = 0;
  std::vector<PageStart> pages;
  std::vector<base::Diagnostic> findings;  ///< that keep it from running: in the order of the text

  /// The label behind the end of a loop: where a loop without a pass goes on.
  [[nodiscard]] std::uint32_t label_behind(std::uint32_t next) const {
    return static_cast<std::uint32_t>(label_lines.size()) + next;
  }
};

/// Name of the label that a number is: "100" for 100 and 100.0.
[[nodiscard]] std::string label_name(double number);

/// Reads the whole text once. Findings: LB0007, LB0014, LB0020, LB0021, LB0026, BLOCK_TOO_LONG.
[[nodiscard]] Scan scan(const base::SourceFile& file, base::FileId id,
                        std::uint32_t lines_per_page);

}  // namespace kerf::basic
