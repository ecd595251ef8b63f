#include "output/programs/unified_diff.hpp"

#include <algorithm>
#include <vector>

#include "base/decimal.hpp"

namespace kerf::output {
namespace {

constexpr std::size_t kContext = 3;

using Lines = std::vector<std::string_view>;  // with their ends

Lines lines_of(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return lines;
}

// Whole lines that others take the place of.
struct Group {
  std::size_t first = 0;
  std::size_t end = 0;
  std::string text{};                // instead of them
  std::vector<std::string> lines{};  // of that
};

/// Makes groups of stretches: whole lines, apart from each other.
class Grouping {
 public:
  Grouping(std::string_view before, const Lines& lines) : before_(before) {
    starts_.reserve(lines.size() + 1);
    std::size_t at = 0;
    for (const std::string_view line : lines) {
      starts_.push_back(at);
      at += line.size();
    }
    starts_.push_back(at);
  }

  std::vector<Group> groups(std::span<const base::TextStretch> stretches) {
    std::vector<Group> all;
    while (!stretches.empty()) {
      Group group;
      stretches = stretches.subspan(take(stretches, group));
      all.push_back(std::move(group));
    }
    return all;
  }

 private:
  [[nodiscard]] std::size_t line_at(std::size_t byte) const {
    const auto behind = std::upper_bound(starts_.begin(), starts_.end() - 1, byte);
    return behind == starts_.begin() ? 0 : static_cast<std::size_t>(behind - starts_.begin()) - 1;
  }
  // The first line that begins there or behind it.
  [[nodiscard]] std::size_t line_from(std::size_t byte) const {
    return static_cast<std::size_t>(std::lower_bound(starts_.begin(), starts_.end(), byte) -
                                    starts_.begin());
  }

  // A group begins between two lines, or with the line that is changed.
  [[nodiscard]] Group begun_at(std::size_t byte) const {
    const std::size_t next = line_from(byte);
    const bool between = starts_[next] == byte && (byte == 0 || before_[byte - 1] == '\n');
    const std::size_t first = between ? next : line_at(byte);
    return {.first = first, .end = between ? first : first + 1};
  }

  // What follows belongs to the last line, unless that has an end.
  [[nodiscard]] bool joins_next(const Group& group, std::size_t at) const {
    return at == starts_[group.end] && !group.text.empty() && group.text.back() != '\n' &&
           group.end + 1 < starts_.size();
  }

  // Takes the stretches that lie in neighbouring lines; returns how many.
  std::size_t take(std::span<const base::TextStretch> stretches, Group& group) const {
    group = begun_at(stretches.front().at);
    std::size_t at = starts_[group.first];
    std::size_t taken = 0;
    for (bool goes_on = true; goes_on;) {
      while (taken < stretches.size() && stretches[taken].at <= starts_[group.end]) {
        const base::TextStretch& next = stretches[taken++];
        group.text += before_.substr(at, next.at - at);
        group.text += next.text;
        at = next.at + next.size;
        group.end = std::max(group.end, line_from(at));
      }
      goes_on = joins_next(group, at);
      if (goes_on) ++group.end;
    }
    group.text += before_.substr(at, starts_[group.end] - at);
    return taken;
  }

  std::string_view before_;
  std::vector<std::size_t> starts_;  // of lines, and the end
};

// Lines at either end that stay as they are belong to no group.
void trim(Group& group, const Lines& before) {
  const Lines lines = lines_of(group.text);
  const auto same = [&](std::size_t old_line, std::size_t new_line) {
    return before[old_line] == lines[new_line];
  };
  std::size_t begin = 0;
  while (group.first < group.end && begin < lines.size() && same(group.first, begin)) {
    ++group.first;
    ++begin;
  }
  std::size_t end = lines.size();
  while (group.first < group.end && end > begin && same(group.end - 1, end - 1)) {
    --group.end;
    --end;
  }
  group.lines.assign(lines.begin() + static_cast<std::ptrdiff_t>(begin),
                     lines.begin() + static_cast<std::ptrdiff_t>(end));
}

std::string range_text(std::size_t first, std::size_t count) {
  std::string text;
  base::append_integer(text, static_cast<std::int64_t>(count == 0 ? first : first + 1));
  if (count == 1) return text;
  text += ',';
  base::append_integer(text, static_cast<std::int64_t>(count));
  return text;
}

void append_line(std::string& out, char sign, std::string_view line) {
  out += sign;
  out += line;
  if (!line.ends_with('\n')) out += "\n\\ No newline at end of file\n";
}

/// Groups so near to each other that their contexts meet.
class Hunk {
 public:
  Hunk(std::span<const Group> groups, const Lines& before)
      : groups_(groups),
        before_(before),
        first_(groups.front().first - std::min(kContext, groups.front().first)),
        end_(std::min(before.size(), groups.back().end + kContext)) {}

  // `moved`: where the first line stands in the new text.
  [[nodiscard]] std::string text(std::size_t moved) const {
    std::string out = "@@ -" + range_text(first_, end_ - first_) + " +" +
                      range_text(moved, end_ - first_ + added() - removed()) + " @@\n";
    std::size_t line = first_;
    for (const Group& group : groups_) {
      while (line < group.first) append_line(out, ' ', before_[line++]);
      while (line < group.end) append_line(out, '-', before_[line++]);
      for (const std::string_view added : group.lines) append_line(out, '+', added);
    }
    while (line < end_) append_line(out, ' ', before_[line++]);
    return out;
  }
  [[nodiscard]] std::size_t first() const { return first_; }
  [[nodiscard]] std::size_t added() const {
    std::size_t count = 0;
    for (const Group& group : groups_) count += group.lines.size();
    return count;
  }
  [[nodiscard]] std::size_t removed() const {
    std::size_t count = 0;
    for (const Group& group : groups_) count += group.end - group.first;
    return count;
  }

 private:
  std::span<const Group> groups_;
  const Lines& before_;
  std::size_t first_;
  std::size_t end_;
};

// As `patch` and git read it: in quotes where it has what ends a name, else with a tab behind it
// where it has a blank.
std::string header_name(const std::string& name) {
  std::string text;
  bool quoted = false;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool control = byte < 0x20 || byte == 0x7f;
    quoted = quoted || control || c == '"' || c == '\\';
    if (control) {
      text += {'\\', static_cast<char>('0' + (byte >> 6U)),
               static_cast<char>('0' + ((byte >> 3U) & 7U)), static_cast<char>('0' + (byte & 7U))};
    } else {
      if (c == '"' || c == '\\') text += '\\';
      text += c;
    }
  }
  if (quoted) return "\"" + text + "\"\n";
  return text + (name.find(' ') == std::string::npos ? "\n" : "\t\n");
}

}  // namespace

std::string unified_diff(const std::string& name, std::string_view before,
                         std::span<const base::TextStretch> stretches) {
  const Lines lines = lines_of(before);
  std::vector<Group> groups = Grouping(before, lines).groups(stretches);
  for (Group& group : groups) trim(group, lines);
  std::erase_if(groups,
                [](const Group& group) { return group.first == group.end && group.lines.empty(); });
  if (groups.empty()) return {};
  const std::string below = name.substr(std::min(name.find_first_not_of('/'), name.size()));
  std::string out = "--- " + header_name("a/" + below) + "+++ " + header_name("b/" + below);
  std::size_t added = 0;
  std::size_t removed = 0;
  for (std::size_t i = 0; i < groups.size();) {
    std::size_t end = i + 1;
    while (end < groups.size() && groups[end].first <= groups[end - 1].end + 2 * kContext) ++end;
    const Hunk hunk(std::span<const Group>(groups).subspan(i, end - i), lines);
    out += hunk.text(hunk.first() + added - removed);
    added += hunk.added();
    removed += hunk.removed();
    i = end;
  }
  return out;
}

}  // namespace kerf::output
