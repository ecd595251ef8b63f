#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace kerf::test {

/// A variable and the value that it must have; nothing: vacant.
struct WantedVariable {
  std::string name;
  std::optional<double> value;
};

struct WantedAlarm {
  std::string number;
  std::uint32_t line = 0;    ///< 0: any
  std::uint32_t column = 0;  ///< 0: any
  std::string at;            ///< text under the caret; empty: any
  std::string says;          ///< part of the message
};

struct WantedWarning {
  std::string number;
  std::uint32_t line = 0;
  std::string at;  ///< text under the caret; empty: any
};

struct WantedPosition {
  char axis = 'X';
  double value = 0;
};

/// What the comments of a program expect (tests/text/README.md).
struct Expectations {
  std::vector<std::string> options;  ///< of `kerf run`
  std::map<std::uint32_t, std::vector<WantedVariable>> variables_after_line;
  std::map<std::uint32_t, std::vector<std::string>> moves_of_line;
  std::map<std::uint32_t, std::string> assumed_in_line;
  bool nothing_assumed = false;
  std::optional<WantedAlarm> alarm;
  std::vector<WantedWarning> warnings;  ///< all that there are
  std::vector<WantedVariable> variables;
  std::vector<WantedPosition> machine;
  std::vector<WantedPosition> work;
  std::string status;
  std::vector<std::string> prints;
  std::optional<std::vector<std::string>> moves;
  std::map<std::string, std::size_t> counts;  ///< of moves, by their kinds
  std::optional<double> lines_mm;             ///< length of all lines together
  std::optional<std::string> printed;         ///< the whole text, its ends of lines as "|"
  std::vector<std::string> input;             ///< lines that INPUT reads
  std::optional<std::vector<std::string>> records;
  std::size_t count = 0;              ///< of expectations
  std::vector<std::string> mistakes;  ///< comments that look like expectations and are none
};

[[nodiscard]] Expectations read_expectations(const std::string& text);

/// Whether the file is one of the programs of the text tests.
[[nodiscard]] bool is_program(const std::filesystem::path& path);

/// What INPUT reads: these lines one after the other, then nothing.
[[nodiscard]] std::function<std::optional<std::string>()> reader_of(std::vector<std::string> lines);

}  // namespace kerf::test
