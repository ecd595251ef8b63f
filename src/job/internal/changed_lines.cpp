#include "job/internal/changed_lines.hpp"

#include <algorithm>

namespace kerf::job {
namespace {

using features::Replacement;

/// Where the lines of a text begin, and where it ends.
std::vector<std::uint64_t> starts_of(const std::string& text) {
  std::vector<std::uint64_t> starts{0};
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1))
    starts.push_back(at + 1);
  return starts;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    const std::size_t next = end == std::string::npos ? text.size() : end + 1;
    lines.push_back(text.substr(at, next - at));
    at = next;
  }
  return lines;
}

/// Whole lines around replacements that touch each other.
struct ChangedLines {
  std::uint64_t from = 0;
  std::uint64_t to = 0;
  std::size_t line = 0;
  std::vector<Replacement> parts{};
};

ChangedLines group_of(const Replacement& each, const std::vector<std::uint64_t>& starts,
                      std::uint64_t size) {
  const auto behind = std::upper_bound(starts.begin(), starts.end(), each.from);
  const auto line = static_cast<std::size_t>(behind - starts.begin()) - 1;
  ChangedLines group{.from = starts[line], .line = line, .parts = {each}};
  const bool comes_in = each.length == 0 && each.from == group.from && each.text.ends_with('\n');
  const std::uint64_t last = each.from + (each.length > 0 ? each.length - 1 : 0);
  const auto end = std::upper_bound(starts.begin(), starts.end(), last);
  group.to = comes_in ? group.from : (end == starts.end() ? size : *end);
  return group;
}

}  // namespace

std::vector<TextChange> changes_of(const std::string& file, const std::string& text,
                                   const std::vector<Replacement>& replacements) {
  const std::vector<std::uint64_t> starts = starts_of(text);
  std::vector<ChangedLines> groups;
  for (const Replacement& each : replacements) {
    ChangedLines group = group_of(each, starts, text.size());
    if (groups.empty() || group.from > groups.back().to ||
        (group.from == groups.back().to && group.to > group.from &&
         groups.back().to > groups.back().from)) {
      groups.push_back(std::move(group));
      continue;
    }
    groups.back().to = std::max(groups.back().to, group.to);
    groups.back().parts.push_back(each);
  }
  std::vector<TextChange> changes;
  for (ChangedLines& group : groups) {
    const std::string old_text = text.substr(group.from, group.to - group.from);
    for (Replacement& part : group.parts) part.from -= group.from;
    changes.push_back({.file = file,
                       .first = static_cast<std::uint32_t>(group.line + 1),
                       .old_lines = lines_of(old_text),
                       .new_lines = lines_of(features::replaced(old_text, group.parts))});
  }
  return changes;
}

}  // namespace kerf::job
