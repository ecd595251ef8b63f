#include "face/cli/operator_input.hpp"

#include <unistd.h>

#include <cstdio>
#include <memory>
#include <utility>
#include <vector>

#include "base/decimal.hpp"

namespace kerf::cli {
namespace {

// Longest line that is kept: no number is longer; and that is read: it may have no end.
constexpr std::size_t kMostKept = 1000;
constexpr std::size_t kMostRead = 1 << 20;

std::optional<std::string> read_line() {
  std::string line;
  int c = std::getchar();
  if (c == EOF) return std::nullopt;
  for (std::size_t read = 0; c != EOF && c != '\n' && read < kMostRead;
       c = std::getchar(), ++read) {
    if (line.size() < kMostKept) line += static_cast<char>(c);
  }
  return line;
}

bool is_number(const std::string& line) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  if (first == std::string::npos) return false;
  return base::read_number(line.substr(first, line.find_last_not_of(" \t\r") - first + 1))
      .has_value();
}

}  // namespace

std::optional<std::string> operator_input() {
  std::fflush(stdout);
  std::optional<std::string> line = read_line();
  const bool terminal = isatty(STDIN_FILENO) == 1;
  while (terminal && line && !is_number(*line)) {
    std::fputs("a number is expected: ", stderr);
    line = read_line();
  }
  return line;
}

std::function<std::optional<std::string>(std::size_t)> kept_operator_input() {
  return [lines = std::make_shared<std::vector<std::string>>()](
             std::size_t number) -> std::optional<std::string> {
    while (lines->size() <= number) {
      auto entered = operator_input();
      if (!entered) return std::nullopt;
      lines->push_back(std::move(*entered));
    }
    return (*lines)[number];
  };
}

}  // namespace kerf::cli
