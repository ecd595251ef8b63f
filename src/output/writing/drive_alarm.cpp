#include "output/writing/drive_alarm.hpp"

#include <utility>

#include "base/program_name.hpp"
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

base::Diagnostic at_line(base::Diagnostic finding, const base::SourceSet& sources) {
  base::Place& place = finding.place;
  if (sources.contains(place.file))
    place.line_start = offset_of_line(sources[place.file], place.file, place.line);
  return finding;
}

base::Diagnostic at_mark(base::Diagnostic alarm, const motion::Mark& mark,
                         const base::SourceSet& sources) {
  alarm.place = base::place_of(mark.block);
  alarm.block = mark.block;
  alarm.program = base::program_name(static_cast<std::uint32_t>(mark.block.program));
  return at_line(std::move(alarm), sources);
}

}  // namespace kerf::output
