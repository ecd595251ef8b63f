#include <algorithm>
#include <atomic>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli/commands.hpp"
#include "cli/machine_setup.hpp"
#include "output/diagnostic_text.hpp"

namespace kerf::cli {
namespace {

using base::Diagnostic;
using Json = nlohmann::ordered_json;

/// What is wrong with one file. Diagnostics are kept as text because their places point into
/// sources that go with the machine.
struct FileReport {
  std::string text;
  std::vector<Json> findings;
  std::optional<base::Failure> failure;
};

// Every block that does not compile, whether it is reached or not, then what the run itself raises.
std::vector<Diagnostic> find_all(machine::VirtualMachine& machine) {
  std::vector<Diagnostic> found = machine.library().findings();
  for (std::size_t program = 0; program < machine.library().program_count(); ++program) {
    for (Diagnostic& diagnostic : machine.library().check(vm::CodeId(program))) {
      found.push_back(std::move(diagnostic));
    }
  }
  const auto same_place = [](const Diagnostic& a, const Diagnostic& b) {
    return a.place.file == b.place.file && a.place.line == b.place.line && a.number == b.number;
  };
  machine.run_to_end();
  if (machine.alarm()) {
    const bool known = std::any_of(found.begin(), found.end(), [&](const Diagnostic& d) {
      return same_place(d, *machine.alarm());
    });
    if (!known) found.push_back(*machine.alarm());
  }
  if (machine.status() == machine::VirtualMachine::Status::budget) {
    Diagnostic endless = base::make_error(base::Code::end_of_record, {});
    endless.number = "BUDGET";
    endless.message = "the program did not end within the execution budget";
    found.push_back(endless);
  }
  return found;
}

FileReport check_file(const std::string& path, const CheckOptions& options) {
  FileReport report;
  auto ready = set_up({.machine = options.machine, .parameters = options.parameters}, path);
  if (!ready) {
    report.failure = ready.error();
    return report;
  }
  machine::VirtualMachine& machine = *ready->machine;
  for (const std::string& folder : options.libraries) machine.add_library_folder(folder);
  auto file = base::SourceFile::open(path);
  if (!file) {
    report.failure = file.error();
    return report;
  }
  machine.load(std::move(*file));
  for (const Diagnostic& diagnostic : find_all(machine)) {
    report.text += output::diagnostic_text(diagnostic, machine.sources());
    report.findings.push_back(Json::parse(output::diagnostic_json(diagnostic, machine.sources())));
  }
  return report;
}

std::vector<FileReport> check_all(const CheckOptions& options) {
  std::vector<FileReport> reports(options.files.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < options.files.size(); i = next++)
      reports[i] = check_file(options.files[i], options);
  };
  std::vector<std::jthread> workers;
  for (unsigned i = 1; i < std::min<std::size_t>(options.jobs, options.files.size()); ++i)
    workers.emplace_back(work);
  work();
  workers.clear();
  return reports;
}

std::string sarif(const std::vector<FileReport>& reports) {
  Json results = Json::array();
  for (const FileReport& report : reports) {
    for (const Json& finding : report.findings) {
      Json region = {{"startLine", std::max(1, finding["line"].get<int>())},
                     {"startColumn", std::max(1, finding["column"].get<int>())}};
      Json location = {{"physicalLocation",
                        {{"artifactLocation", {{"uri", finding["file"]}}}, {"region", region}}}};
      results.push_back({{"ruleId", finding["code"]},
                         {"level", "error"},
                         {"message", {{"text", finding["message"]}}},
                         {"locations", Json::array({location})}});
    }
  }
  Json run = {{"tool", {{"driver", {{"name", "kerf"}}}}}, {"results", results}};
  return Json{{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
              {"version", "2.1.0"},
              {"runs", Json::array({run})}}
             .dump(2) +
         "\n";
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      default: result += c;
    }
  }
  return result;
}

std::string junit(const std::vector<FileReport>& reports, const CheckOptions& options) {
  std::size_t failed = 0;
  std::string cases;
  for (std::size_t i = 0; i < reports.size(); ++i) {
    const std::string name = "  <testcase classname=\"kerf check\" name=\"" +
                             escaped(output::printable(options.files[i])) + "\"";
    if (reports[i].findings.empty() && !reports[i].failure) {
      cases += name + "/>\n";
      continue;
    }
    ++failed;
    const std::string text = reports[i].failure ? reports[i].failure->message : reports[i].text;
    cases += name + ">\n    <failure message=\"" +
             escaped(output::printable(text.substr(0, text.find('\n')))) + "\">" + escaped(text) +
             "</failure>\n  </testcase>\n";
  }
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"kerf check\" tests=\"" +
         std::to_string(reports.size()) + "\" failures=\"" + std::to_string(failed) + "\">\n" +
         cases + "</testsuite>\n";
}

std::string in_format(const std::vector<FileReport>& reports, const CheckOptions& options) {
  if (options.format == "sarif") return sarif(reports);
  if (options.format == "junit") return junit(reports, options);
  std::string text;
  for (const FileReport& report : reports) {
    if (options.format == "text") {
      text += report.text;
      continue;
    }
    for (const Json& finding : report.findings) text += finding.dump() + "\n";
  }
  return text;
}

}  // namespace

ExitStatus check(const CheckOptions& options) {
  const std::vector<FileReport> reports = check_all(options);
  const std::string text = in_format(reports, options);
  std::fwrite(text.data(), 1, text.size(), stdout);
  ExitStatus status = ExitStatus::well;
  for (const FileReport& report : reports) {
    if (!report.findings.empty() && status == ExitStatus::well) status = ExitStatus::findings;
    if (!report.failure) continue;
    std::fprintf(stderr, "kerf: %s\n", report.failure->message.c_str());
    status = status_of(*report.failure);
  }
  return status;
}

}  // namespace kerf::cli
