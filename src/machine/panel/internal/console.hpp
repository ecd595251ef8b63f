#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostic.hpp"

namespace kerf::machine {

/// What a machine and its operator say to each other: messages, the panel's own alarm, printed text
/// and the lines for INPUT. It stays from program to program.
class Console {
 public:
  /// Keeps the last `printed_bytes` of what is printed; it begins with `printed`, the end of
  /// `all_printed` bytes.
  Console(std::size_t printed_bytes, std::string printed, std::uint64_t all_printed)
      : kept_bytes_(printed_bytes), printed_(std::move(printed)), printed_bytes_(all_printed) {}

  /// A message; not twice in a row.
  void say(std::string message);
  [[nodiscard]] const std::deque<std::string>& messages() const { return messages_; }
  void forget_messages() { messages_.clear(); }

  /// An alarm that is not the control's: the end of a travel.
  void raise(base::Code code, const std::string& sentence) {
    alarm_ = base::make_error(code, {}, sentence);
  }
  [[nodiscard]] const std::optional<base::Diagnostic>& alarm() const { return alarm_; }
  void forget_alarm() { alarm_.reset(); }

  void print(std::string_view text);
  [[nodiscard]] const std::string& printed() const { return printed_; }
  /// All that was ever printed.
  [[nodiscard]] std::uint64_t printed_bytes() const { return printed_bytes_; }

  void enter(std::string line) { input_.push_back(std::move(line)); }
  [[nodiscard]] bool has_line() const { return !input_.empty(); }
  [[nodiscard]] std::optional<std::string> next_line();

  /// Alarm, messages and lines that nobody has read go.
  void reset();

 private:
  std::size_t kept_bytes_;
  std::string printed_;
  std::uint64_t printed_bytes_;
  std::deque<std::string> messages_;
  std::optional<base::Diagnostic> alarm_;
  std::deque<std::string> input_;
};

}  // namespace kerf::machine
