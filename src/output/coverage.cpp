#include "output/coverage.hpp"

#include "output/diagnostic_text.hpp"

namespace kerf::output {
namespace {

constexpr std::size_t kLongestLine = 4096;

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

}  // namespace

void Coverage::count(base::FileId file, std::uint32_t line) {
  std::vector<std::uint64_t>& counts = counts_[file];
  if (counts.size() <= line) counts.resize(line + 1);
  ++counts[line];
}

std::string Coverage::csv(const base::SourceSet& sources,
                          const std::vector<control::Assumption>& assumed) const {
  std::string text = "file,line,count,source,assumed\n";
  for (const auto& [file, counts] : counts_) {
    const base::SourceFile& source = sources[file];
    std::uint64_t offset = 0;
    for (std::uint32_t line = 1; offset < source.size(); ++line) {
      const std::string content = source.line_at(offset, kLongestLine);
      const std::uint64_t count = line < counts.size() ? counts[line] : 0;
      text += quoted(printable(source.name())) + "," + std::to_string(line) + "," +
              std::to_string(count) + "," + quoted(printable(content)) + ",";
      std::string what;
      for (const control::Assumption& assumption : assumed) {
        if (assumption.line == line && file == base::FileId{0})
          what += (what.empty() ? "" : "; ") + assumption.what;
      }
      text += what.empty() ? "\n" : quoted(what) + "\n";
      offset += content.size();
      std::string end(2, '\0');
      end.resize(source.read(offset, end));
      if (end.empty()) break;
      offset += end == "\r\n" ? 2U : 1U;
    }
  }
  return text;
}

}  // namespace kerf::output
