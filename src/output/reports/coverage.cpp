#include "output/reports/coverage.hpp"

#include <algorithm>

#include "base/text_window.hpp"
#include "output/writing/diagnostic_text.hpp"

namespace kerf::output {
namespace {

constexpr std::size_t kLongestLine = 4096;

std::string csv_field(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

// The beginning of a line, without the returns around it.
std::string text_of(const base::TextWindow::Line& line, const base::SourceFile& source) {
  if (line.too_long) return source.line_at(line.offset, kLongestLine);
  std::string_view text = line.text;
  text.remove_prefix(std::min(text.find_first_not_of('\r'), text.size()));
  text = text.substr(0, text.find_last_not_of('\r') + 1);
  return std::string(text.substr(0, kLongestLine));
}

// The program's own file is the one that assumptions are about.
std::string assumptions_of(std::uint32_t line, base::FileId file,
                           const std::vector<control::Assumption>& assumed) {
  std::string what;
  for (const control::Assumption& assumption : assumed) {
    if (assumption.line == line && file == base::FileId{0})
      what += (what.empty() ? "" : "; ") + assumption.what;
  }
  return what.empty() ? what : csv_field(what);
}

}  // namespace

void Coverage::count(base::FileId file, std::uint32_t line) {
  std::vector<std::uint64_t>& counts = counts_[file];
  if (counts.size() <= line) counts.resize(line + 1);
  ++counts[line];
}

void Coverage::write_csv(const base::SourceSet& sources,
                         const std::vector<control::Assumption>& assumed,
                         base::OutputFile& into) const {
  into.write("file,line,count,source,assumed\n");
  for (const auto& [file, counts] : counts_) write_file(sources, file, assumed, into);
}

void Coverage::write_file(const base::SourceSet& sources, base::FileId file,
                          const std::vector<control::Assumption>& assumed,
                          base::OutputFile& into) const {
  const base::SourceFile& source = sources[file];
  const std::vector<std::uint64_t>& counts = counts_.at(file);
  const std::string name = csv_field(printable(source.name())) + ",";
  base::TextWindow window;
  window.stand_at(source, file, 0, source.size());
  base::TextWindow::Line line;
  for (std::uint32_t number = 1; window.next(line) && into.good(); ++number) {
    const std::uint64_t count = number < counts.size() ? counts[number] : 0;
    into.write(name + std::to_string(number) + "," + std::to_string(count) + "," +
               csv_field(printable(text_of(line, source))) + "," +
               assumptions_of(number, file, assumed) + "\n");
  }
}

}  // namespace kerf::output
