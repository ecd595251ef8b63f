// How a program is cut into pages changes nothing that it does: every program of tests/text runs
// with pages of 1, 2, 7 and 256 lines, and with room for one page alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/decimal.hpp"
#include "expectations.hpp"
#include "face/cli/arguments.hpp"
#include "face/cli/ready_run.hpp"
#include "observer.hpp"
#include "temporary_folder.hpp"

namespace kerf::test {
namespace {

namespace fs = std::filesystem;
using machine::BatchRun;
using Settings = vm::PageSettings;

// Long enough for every program of the text tests that ends, short for those that do not.
const machine::Budget kBudget{.seconds = 0, .motions = 20'000, .steps = 400'000};

std::string read_file(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// A machine as the options of the program want it, with pages of its own.
std::unique_ptr<job::Run> make_run(const cli::RunOptions& options, const Settings& settings) {
  auto program = *base::SourceFile::open(options.program);
  auto ordered = cli::job_of(options, *program);
  if (!ordered) {
    ADD_FAILURE() << ordered.error().message;
    return nullptr;
  }
  ordered->job.settings.pages = settings;
  ordered->job.budget = kBudget;
  auto run = job::Run::of(ordered->job, std::move(program));
  if (!run) {
    ADD_FAILURE() << run.error().message;
    return nullptr;
  }
  return std::move(*run);
}

struct Program {
  cli::RunOptions options;
  std::vector<std::string> input;
};

// Everything that a run shows, as text.
std::vector<std::string> story_of(const Program& program, const Settings& settings, bool tracing) {
  std::vector<std::string> story;
  const auto run = make_run(program.options, settings);
  if (run == nullptr) return story;
  BatchRun* const machine = &run->machine();
  Recorder recorder(machine->definition().axes);
  std::string printed;
  machine->add_sink(recorder);
  machine->set_input(reader_of(program.input));
  machine->set_print_output([&](std::string_view text) { printed += text; });
  if (tracing) machine->observe_blocks([](base::FileId, std::uint32_t) {});
  const auto status = run->go();
  // Where a budget ends a run depends on the pages: only the way there is compared.
  const bool ended = status != machine::RunStatus::budget;
  for (const Observed& observed : recorder.observed())
    story.push_back("line " + std::to_string(observed.line) + ": " + observed.text);
  if (!ended) {
    story.resize(std::min<std::size_t>(story.size(), 1000));
    story.push_back("budget");
    return story;
  }
  if (machine->alarm()) {
    const base::Diagnostic& alarm = *machine->alarm();
    story.push_back("alarm " + alarm.number + " " + alarm.message + " at " +
                    std::to_string(alarm.place.line) + ":" + std::to_string(alarm.place.column) +
                    "+" + std::to_string(alarm.place.length) + " byte " +
                    std::to_string(alarm.place.line_start) + " in " + alarm.program);
  }
  for (const base::Diagnostic& warning : machine->control().warnings())
    story.push_back("warning " + warning.number + " at " + std::to_string(warning.place.line) +
                    ":" + std::to_string(warning.place.column));
  for (const machine::Variable& variable : machine->variables())
    story.push_back(variable.name + "=" + base::number_text(variable.value));
  story.push_back("printed " + printed);
  story.push_back("blocks " + std::to_string(machine->control().blocks()));
  story.push_back("status " + std::to_string(static_cast<int>(status)));
  return story;
}

std::string first_difference(const std::vector<std::string>& got,
                             const std::vector<std::string>& wanted) {
  const auto [a, b] = std::mismatch(got.begin(), got.end(), wanted.begin(), wanted.end());
  if (a == got.end() && b == wanted.end()) return {};
  return "got    " + (a == got.end() ? "nothing more" : *a) + "\nwanted " +
         (b == wanted.end() ? "nothing more" : *b);
}

// Runs a program cut in other ways; empty: nothing differs.
std::string difference_of_pages(const Program& program, const std::vector<std::string>& wanted) {
  for (const std::uint32_t lines : {1U, 2U, 7U, 256U}) {
    const Settings usual{.lines_per_page = lines};
    const Settings tight{.lines_per_page = lines, .fresh_pages = 1, .most_pages = 1};
    const std::string pages = " with " + std::to_string(lines) + " lines a page";
    std::string what = first_difference(story_of(program, usual, false), wanted);
    if (!what.empty()) return pages + ":\n" + what;
    what = first_difference(story_of(program, tight, false), wanted);
    if (!what.empty()) return pages + " and room for one page:\n" + what;
    what = first_difference(story_of(program, usual, true), wanted);
    if (!what.empty()) return pages + ", watched block by block:\n" + what;
  }
  return {};
}

class PageSize : public testing::TestWithParam<fs::path> {};

TEST_P(PageSize, DoesNotMatter) {
  std::vector<fs::path> programs;
  for (const auto& entry : fs::directory_iterator(GetParam())) {
    const fs::path& path = entry.path();
    if (is_program(path)) programs.push_back(path);
  }
  std::sort(programs.begin(), programs.end());
  ASSERT_FALSE(programs.empty());
  // In a folder of its own: the programs of the same folder can be called.
  const TemporaryFolder folder;
  for (const fs::path& program : programs) {
    const Expectations expected = read_expectations(read_file(program));
    std::vector<std::string> words = {
        "run", folder.write("program" + program.extension().string(), read_file(program))};
    words.insert(words.end(), expected.options.begin(), expected.options.end());
    auto request = cli::parse_arguments(words);
    ASSERT_TRUE(request) << request.error().message;
    const Program runnable{std::get<cli::RunOptions>(*request), expected.input};
    const std::vector<std::string> wanted = story_of(runnable, {}, false);
    ASSERT_FALSE(wanted.empty()) << program;
    const std::string what = difference_of_pages(runnable, wanted);
    EXPECT_TRUE(what.empty()) << program.filename().string() << what;
  }
}

std::vector<fs::path> folders() {
  std::vector<fs::path> result;
  for (const auto& entry : fs::directory_iterator(KERF_TEXT_TESTS)) {
    if (entry.is_directory()) result.push_back(entry.path());
  }
  std::sort(result.begin(), result.end());
  return result;
}

INSTANTIATE_TEST_SUITE_P(TextTests, PageSize, testing::ValuesIn(folders()),
                         [](const auto& folder) { return folder.param.filename().string(); });

}  // namespace
}  // namespace kerf::test
