#include "face/cli/check_report.hpp"

#include <algorithm>

#include "output/writing/diagnostic_text.hpp"

namespace kerf::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const FileReport& report) {
  std::string text;
  for (const Finding& finding : report.findings) text += finding.text;
  return text;
}

std::string json_lines(const std::vector<FileReport>& reports) {
  std::string text;
  for (const FileReport& report : reports) {
    for (const Finding& finding : report.findings) text += finding.object.dump() + "\n";
  }
  return text;
}

// A relative reference (RFC 3986): what may not stand in a path is written as %XX.
std::string uri(const std::string& path) {
  constexpr std::string_view kAlsoAllowed = "/-._~!$&'()*+,;=@";
  constexpr const char* kDigits = "0123456789ABCDEF";
  std::string result;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool alphanumeric =
        (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    if (alphanumeric || kAlsoAllowed.find(c) != std::string_view::npos) {
      result += c;
    } else {
      result += {'%', kDigits[byte >> 4U], kDigits[byte & 15U]};
    }
  }
  return result;
}

// SARIF and Kerf have the same three words for how grave a finding is: error, warning, note.
Json sarif_result(const Finding& finding) {
  const Json region = {{"startLine", std::max(1, finding.object["line"].get<int>())},
                       {"startColumn", std::max(1, finding.object["column"].get<int>())}};
  const Json location = {
      {"physicalLocation",
       {{"artifactLocation", {{"uri", uri(finding.file)}}}, {"region", region}}}};
  return {{"ruleId", finding.object["code"]},
          {"level", finding.object["severity"]},
          {"message", {{"text", finding.object["message"]}}},
          {"locations", Json::array({location})}};
}

std::string sarif(const std::vector<FileReport>& reports) {
  Json results = Json::array();
  for (const FileReport& report : reports) {
    for (const Finding& finding : report.findings) results.push_back(sarif_result(finding));
  }
  const Json run = {{"tool", {{"driver", {{"name", "kerf"}}}}}, {"results", results}};
  return Json{{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
              {"version", "2.1.0"},
              {"runs", Json::array({run})}}
             .dump(2) +
         "\n";
}

// XML 1.0 has no control characters but tab and line end, and not U+FFFE and U+FFFF.
std::string xml(const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    for (const char c : output::printable(text.substr(at, end - at))) {
      switch (c) {
        case '&': result += "&amp;"; break;
        case '<': result += "&lt;"; break;
        case '>': result += "&gt;"; break;
        case '"': result += "&quot;"; break;
        default: result += c;
      }
    }
    if (end < text.size()) result += '\n';
    at = end + 1;
  }
  for (const char* const none : {"\xef\xbf\xbe", "\xef\xbf\xbf"}) {
    for (std::size_t at = 0; (at = result.find(none, at)) != std::string::npos;)
      result.replace(at, 3, "?");
  }
  return result;
}

std::string test_case(const FileReport& report) {
  const std::string head =
      "  <testcase classname=\"kerf check\" name=\"" + xml(output::printable(report.file)) + "\"";
  if (report.findings.empty() && !report.failure) return head + "/>\n";
  const std::string text = report.failure ? report.failure->message : text_of(report);
  if (!report.fails())
    return head + ">\n    <system-out>" + xml(text) + "</system-out>\n  </testcase>\n";
  return head + ">\n    <failure message=\"" + xml(text.substr(0, text.find('\n'))) + "\">" +
         xml(text) + "</failure>\n  </testcase>\n";
}

std::string junit(const std::vector<FileReport>& reports) {
  const auto failed = std::count_if(reports.begin(), reports.end(),
                                    [](const FileReport& report) { return report.fails(); });
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"kerf check\" tests=\"" +
      std::to_string(reports.size()) + "\" failures=\"" + std::to_string(failed) + "\">\n";
  for (const FileReport& report : reports) text += test_case(report);
  return text + "</testsuite>\n";
}

}  // namespace

void FileReport::add(const base::Diagnostic& diagnostic, const base::SourceSet& sources,
                     bool counts) {
  findings.push_back({output::file_name(diagnostic, sources),
                      output::diagnostic_text(diagnostic, sources),
                      Json::parse(output::diagnostic_json(diagnostic, sources)), counts});
}

bool FileReport::fails() const {
  const auto counts = [](const Finding& finding) { return finding.counts; };
  return failure || std::any_of(findings.begin(), findings.end(), counts);
}

std::string in_format(const std::vector<FileReport>& reports, const std::string& format) {
  if (format == "sarif") return sarif(reports);
  if (format == "junit") return junit(reports);
  if (format == "json") return json_lines(reports);
  std::string text;
  for (const FileReport& report : reports) text += text_of(report);
  return text;
}

}  // namespace kerf::cli
