#include "machine/panel/internal/console.hpp"

namespace kerf::machine {
namespace {

constexpr std::size_t kMostMessages = 50;

}  // namespace

void Console::say(std::string message) {
  if (!messages_.empty() && messages_.back() == message) return;
  messages_.push_back(std::move(message));
  if (messages_.size() > kMostMessages) messages_.pop_front();
}

void Console::print(std::string_view text) {
  printed_bytes_ += text.size();
  printed_ += text;
  if (printed_.size() > kept_bytes_) printed_.erase(0, printed_.size() - kept_bytes_);
}

std::optional<std::string> Console::next_line() {
  if (input_.empty()) return std::nullopt;
  std::string line = std::move(input_.front());
  input_.pop_front();
  return line;
}

void Console::reset() {
  forget_alarm();
  forget_messages();
  input_.clear();
}

}  // namespace kerf::machine
