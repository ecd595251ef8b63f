#include "drawing/trace/internal/trace.hpp"

#include <algorithm>

#include "base/decimal.hpp"

namespace kerf::drawing::trace {
namespace {

constexpr std::size_t kMostNumbers = 20'000;  // what is more is wrong anyway

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

void append_numbers(std::string_view value, std::vector<double>& numbers, bool& is_readable) {
  for (const std::string_view part : parted(value)) {
    if (part.empty()) continue;  // behind the last semicolon of a line
    const auto number = base::read_number(part);
    is_readable = is_readable && number.has_value();
    if (numbers.size() < kMostNumbers) numbers.push_back(number.value_or(0));
  }
}

Trace trace_of(const Entry& entry) {
  const std::vector<std::string_view> fields = parted(entry.value);
  const auto field = [&](std::size_t i) {
    return i < fields.size() ? fields[i] : std::string_view();
  };
  Trace trace;
  trace.line = entry.line;
  trace.format = field(0);
  trace.count = field(1);
  trace.has_angles = field(2) == "U";
  if (!field(3).empty()) trace.side = field(3).front();
  return trace;
}

bool is_something(std::string_view field) { return base::read_number(field).value_or(0) != 0; }

bool asks_for_something(std::string_view value) {
  const std::vector<std::string_view> fields = parted(value);
  return std::any_of(fields.begin(), fields.end(), is_something);
}

}  // namespace

std::vector<std::string_view> parted(std::string_view value) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = std::min(value.find(';'), value.size());
    parts.push_back(trimmed(value.substr(0, end)));
    if (end == value.size()) return parts;
    value.remove_prefix(end + 1);
  }
}

Entry entry_of(std::string_view line, std::uint32_t number) {
  std::string clean;
  for (const char c : line)
    if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7F)
      clean += static_cast<unsigned char>(c) < 0x80 ? c : '?';  // records are of ASCII alone
  const std::size_t equals = clean.find('=');
  if (equals == std::string::npos) return {};
  Entry entry{std::string(trimmed(std::string_view(clean).substr(0, equals))),
              std::string(trimmed(std::string_view(clean).substr(equals + 1))), number};
  for (char& c : entry.label)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return entry;
}

void Records::take(const Entry& entry) {
  constexpr std::size_t kMostTraces = 100;
  if (entry.label == "TRCFMT") {
    if (traces.size() < kMostTraces) traces.push_back(trace_of(entry));
  } else if (entry.label == "R" && !traces.empty()) {
    append_numbers(entry.value, traces.back().radii, traces.back().is_readable);
  } else if (entry.label == "A" && !traces.empty()) {
    append_numbers(entry.value, traces.back().angles, traces.back().is_readable);
  } else if (entry.label == "HBOX" || entry.label == "VBOX") {
    boxes.push_back(entry);
  } else if (entry.label.starts_with("BEV") || entry.label.starts_with("DRILL")) {
    if (asks_for_something(entry.value)) unmade.push_back(entry);
  }
}

}  // namespace kerf::drawing::trace
