#include "output/drawings/draw_summary.hpp"

#include <fmt/format.h>

#include "output/writing/diagnostic_text.hpp"

namespace kerf::output {
namespace {

std::string file_line(const DrawFacts& facts, const drawing::FileFacts& file) {
  const auto index = static_cast<std::size_t>(file.file);
  const std::string name = index < facts.files.size() ? facts.files[index] : "";
  std::string line =
      fmt::format("  {}: {}{}{}, unit {} ({})\n", printable(name), file.format,
                  file.version.empty() ? "" : " ", file.version, file.unit, file.unit_from);
  for (const drawing::Ignored& ignored : file.ignored)
    line += fmt::format("    not drawn: {} x {}{}\n", ignored.count, printable(ignored.what),
                        ignored.why.empty() ? "" : ": " + ignored.why);
  return line;
}

std::string contours_line(const DrawFacts& facts) {
  std::size_t closed = 0;
  double sum = 0;
  for (const drawing::Chain& chain : facts.cleaned.chains) {
    if (chain.path.is_closed) ++closed;
    sum += length(chain.path);
  }
  const drawing::Cleaned& cleaned = facts.cleaned;
  return fmt::format(
      "  {} contours ({} closed), {:.3f} mm; joined {}, twice {}, without length {}, gaps {}\n",
      cleaned.chains.size(), closed, sum, cleaned.joined, cleaned.duplicates, cleaned.zero_length,
      cleaned.gaps);
}

std::string plan_lines(const DrawFacts& facts) {
  const Made& made = facts.made;
  std::string lines;
  for (std::size_t i = 0; i < facts.plan->operations.size(); ++i) {
    const process::PlannedOperation& planned = facts.plan->operations[i];
    const Made& of = facts.made_by_operation[i];
    lines += fmt::format(
        "  {:<16} {:<8} {:>10.1f} mm {:>9.1f} s {:>9.1f} J\n", printable(planned.operation.name),
        process::word_of(planned.operation.process), of.beam_mm, of.time_s, of.energy_j);
  }
  lines += fmt::format("  time {:.1f} s, beam {:.1f} mm, travel {:.1f} mm (as drawn {:.1f})\n",
                       made.time_s, made.beam_mm, made.travel_mm,
                       made.travel_mm - facts.plan->travel_order_mm + facts.plan->travel_file_mm);
  return lines;
}

}  // namespace

std::string draw_summary(const DrawFacts& facts) {
  std::string text;
  for (const drawing::FileFacts& file : facts.drawing.files) text += file_line(facts, file);
  text += contours_line(facts);
  if (facts.plan != nullptr) text += plan_lines(facts);
  for (const std::string& assumed : facts.assumed)
    text += "  assumed: " + printable(assumed) + "\n";
  for (const DrawTarget& target : facts.targets)
    text += fmt::format("  wrote {}\n", printable(target.file));
  return text;
}

}  // namespace kerf::output
