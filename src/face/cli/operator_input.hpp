#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace kerf::cli {

/// The next line of standard input, for INPUT; nothing when it is closed. On a terminal a line that
/// is no number is asked for again. Everything printed so far is put out first.
[[nodiscard]] std::optional<std::string> operator_input();

/// The same for a program that runs more than once: what was entered is kept.
class KeptInput {
 public:
  /// By its number from 0.
  [[nodiscard]] std::optional<std::string> line(std::size_t number);

 private:
  std::vector<std::string> lines_;
};

}  // namespace kerf::cli
