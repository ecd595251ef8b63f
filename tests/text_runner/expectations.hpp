#pragma once

#include <cstdint>
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
  std::uint32_t line = 0;  ///< 0: any
  std::string at;          ///< text under the caret; empty: any
  std::string says;        ///< part of the message
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
  std::vector<WantedVariable> variables;
  std::vector<WantedPosition> machine;
  std::vector<WantedPosition> work;
  std::string status;
  std::vector<std::string> prints;
  std::optional<std::vector<std::string>> moves;
  std::optional<std::vector<std::string>> records;
  std::size_t count = 0;              ///< of expectations
  std::vector<std::string> mistakes;  ///< comments that look like expectations and are none
};

[[nodiscard]] Expectations read_expectations(const std::string& text);

}  // namespace kerf::test
