#include "output/drive_alarm.hpp"

#include <fmt/format.h>

#include "base/text_window.hpp"

namespace kerf::output {
namespace {

std::uint64_t offset_of_line(const base::SourceFile& source, base::FileId file,
                             std::uint32_t wanted) {
  base::TextWindow window;
  window.stand_at(source, file, 0, source.size());
  base::TextWindow::Line line;
  for (std::uint32_t number = 1; window.next(line); ++number) {
    if (number == wanted) return line.offset;
  }
  return source.size();
}

}  // namespace

base::Diagnostic at_mark(base::Diagnostic alarm, const motion::Mark& mark,
                         const base::SourceSet& sources) {
  alarm.place = {.file = mark.file, .line = mark.line, .column = 1};
  if (sources.contains(mark.file))
    alarm.place.line_start = offset_of_line(sources[mark.file], mark.file, mark.line);
  alarm.program = fmt::format("O{:04}", static_cast<std::uint32_t>(mark.program));
  return alarm;
}

}  // namespace kerf::output
