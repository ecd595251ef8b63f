#include "job/text_changes.hpp"

#include "base/source_file.hpp"
#include "base/text_window.hpp"

namespace kerf::job {
namespace {

// Where the lines of a program begin, and its end.
std::vector<std::size_t> line_starts(const base::SourceFile& file) {
  std::vector<std::size_t> starts;
  base::TextWindow window;
  window.stand_at(file, base::FileId{0}, 0, file.size());
  base::TextWindow::Line line;
  while (window.next(line)) starts.push_back(static_cast<std::size_t>(line.offset));
  starts.push_back(static_cast<std::size_t>(file.size()));
  return starts;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line;
  return text;
}

}  // namespace

tl::expected<std::vector<base::TextStretch>, std::uint32_t> stretches_of(
    std::string text, std::span<const TextChange> changes) {
  const auto shared = std::make_shared<const std::string>(std::move(text));
  const auto file = base::SourceFile::from_shared({}, shared);
  const std::vector<std::size_t> starts = line_starts(*file);
  std::vector<base::TextStretch> stretches;
  std::size_t free_from = 0;
  for (const TextChange& change : changes) {
    if (change.first == 0 || change.first > starts.size()) return tl::unexpected(change.first);
    const std::size_t at = starts[change.first - 1];
    const std::string old = joined(change.old_lines);
    if (at < free_from || shared->compare(at, old.size(), old) != 0)
      return tl::unexpected(change.first);
    stretches.push_back({at, old.size(), joined(change.new_lines)});
    free_from = at + old.size();
  }
  return stretches;
}

std::size_t start_of_line(std::string text, std::uint32_t line) {
  const auto file = base::SourceFile::from_text({}, std::move(text));
  const std::vector<std::size_t> starts = line_starts(*file);
  return line > 0 && line <= starts.size() ? starts[line - 1] : starts.back();
}

std::string with_stretches(std::string_view text, std::span<const base::TextStretch> stretches) {
  std::string result;
  std::size_t at = 0;
  for (const base::TextStretch& stretch : stretches) {
    result += text.substr(at, stretch.at - at);
    result += stretch.text;
    at = stretch.at + stretch.size;
  }
  result += text.substr(at);
  return result;
}

std::vector<TextChange> taken_back(std::span<const TextChange> changes) {
  std::vector<TextChange> back;
  std::uint32_t added = 0;  // of lines, before the change; may be less than nothing
  for (const TextChange& change : changes) {
    back.push_back({change.file, change.first + added, change.new_lines, change.old_lines});
    added += static_cast<std::uint32_t>(change.new_lines.size() - change.old_lines.size());
  }
  return back;
}

}  // namespace kerf::job
