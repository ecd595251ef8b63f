// Runs every program of tests/text as a test of its own name; what it expects stands in its
// comments.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/decimal.hpp"
#include "expectations.hpp"
#include "face/cli/arguments.hpp"
#include "face/cli/ready_run.hpp"
#include "fanuc.hpp"
#include "lang/vm/value.hpp"
#include "observer.hpp"
#include "temporary_folder.hpp"

namespace kerf::test {
namespace {

namespace fs = std::filesystem;
using machine::BatchRun;
using Status = machine::RunStatus;

constexpr double kVariableTolerance = 1e-6;

std::string read_file(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

const char* status_name(Status status) {
  switch (status) {
    case Status::end: return "end";
    case Status::alarm: return "alarm";
    case Status::budget: return "budget";
    default: return "stopped";
  }
}

std::string capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

double named_variable(BatchRun& machine, const std::string& name) {
  for (const machine::Variable& variable : machine.variables()) {
    if (variable.name == capitals(name)) return variable.value;
  }
  return vm::kNull;
}

// #1 to #33 of the main program's level, #100 to #199, #500 to #999; of laser BASIC by name.
double variable(BatchRun& machine, const std::string& name) {
  if (name[0] != '#') return named_variable(machine, name);
  const auto number = static_cast<std::size_t>(std::stoul(name.substr(1)));
  if (number < gcode::kLocals) return fanuc(machine).first_level_locals()[number];
  if (number < 200) return machine.memory().commons[number - 100];
  return machine.memory().commons[number - 500 + gcode::kVolatileCommons];
}

std::string value_text(double value) {
  return vm::is_null(value) ? "null" : base::number_text(value);
}

class TextTest : public testing::Test {
 public:
  explicit TextTest(fs::path path) : path_(std::move(path)) {}
  void TestBody() override;

 private:
  void prepare();
  void run();
  void check_variables(const std::vector<WantedVariable>& wanted, const std::string& when);
  void check_alarm();
  void check_end();
  void check_moves();
  void check_list(const std::vector<std::string>& wanted, const std::vector<Observed>& got,
                  const std::string& what);
  void check_counts();
  void check_records();
  void check_warnings();
  [[nodiscard]] std::string text_at(const base::Place& place) const;
  void check_assumed();
  void check_positions();
  double local(const std::string& name);

  fs::path path_;
  Expectations expected_;
  cli::RunOptions options_;
  std::unique_ptr<job::Run> run_;
  BatchRun* machine_ = nullptr;  // of the run
  std::unique_ptr<Recorder> recorder_;
  std::string printed_;
  TemporaryFolder folder_;
  std::uint32_t line_ = 0;  // of the block that began last
};

void TextTest::prepare() {
  expected_ = read_expectations(read_file(path_));
  for (const std::string& mistake : expected_.mistakes)
    ADD_FAILURE() << "not understood: " << mistake;
  ASSERT_GT(expected_.count, 0U) << "the program expects nothing";
  // In a folder of its own: the programs of the same folder can be called.
  const std::string program =
      folder_.write("program" + path_.extension().string(), read_file(path_));
  std::vector<std::string> words = {"run", program};
  words.insert(words.end(), expected_.options.begin(), expected_.options.end());
  auto request = cli::parse_arguments(words);
  ASSERT_TRUE(request) << request.error().message;
  options_ = std::get<cli::RunOptions>(*request);
  auto ready = cli::make_ready(options_);
  ASSERT_TRUE(ready) << ready.error().message;
  run_ = std::move(ready->run);
  machine_ = &run_->machine();
  recorder_ = std::make_unique<Recorder>(machine_->definition().axes);
  machine_->add_sink(*recorder_);
  machine_->set_input(reader_of(expected_.input));
  machine_->set_print_output([this](std::string_view text) { printed_ += text; });
}

// A line is over when the next block begins, and at the end of the run.
void TextTest::run() {
  machine_->observe_blocks([this](base::FileId, std::uint32_t line) {
    const auto wanted = expected_.variables_after_line.find(line_);
    if (wanted != expected_.variables_after_line.end())
      check_variables(wanted->second, "after line " + std::to_string(line_));
    line_ = line;
  });
  run_->go();
  const auto wanted = expected_.variables_after_line.find(line_);
  if (wanted != expected_.variables_after_line.end())
    check_variables(wanted->second, "after line " + std::to_string(line_));
}

double TextTest::local(const std::string& name) {
  if (name[0] != '#') return variable(*machine_, name);
  const auto number = static_cast<std::size_t>(std::stoul(name.substr(1)));
  if (number < gcode::kLocals) return fanuc(*machine_).running_locals()[number];
  return variable(*machine_, name);
}

void TextTest::check_variables(const std::vector<WantedVariable>& wanted, const std::string& when) {
  for (const WantedVariable& item : wanted) {
    const double got = when == "finally" ? variable(*machine_, item.name) : local(item.name);
    const bool same =
        item.value ? std::fabs(got - *item.value) <= kVariableTolerance : vm::is_null(got);
    EXPECT_TRUE(same) << item.name << " is " << value_text(got) << " " << when << ", wanted "
                      << (item.value ? base::number_text(*item.value) : "null");
  }
}

void TextTest::check_alarm() {
  const auto& alarm = machine_->alarm();
  if (!expected_.alarm) {
    EXPECT_FALSE(alarm) << "unexpected alarm "
                        << (alarm ? alarm->number + " " + alarm->message : "") << " in line "
                        << (alarm ? alarm->place.line : 0);
    return;
  }
  const WantedAlarm& wanted = *expected_.alarm;
  ASSERT_TRUE(alarm) << "wanted alarm " << wanted.number << ", got none";
  EXPECT_EQ(alarm->number, wanted.number) << alarm->message;
  EXPECT_GT(alarm->place.line, 0U);
  EXPECT_GT(alarm->place.column, 0U);
  if (wanted.line != 0) {
    EXPECT_EQ(alarm->place.line, wanted.line);
  }
  if (wanted.column != 0) {
    EXPECT_EQ(alarm->place.column, wanted.column);
  }
  EXPECT_NE(alarm->message.find(wanted.says), std::string::npos) << alarm->message;
  if (wanted.at.empty()) return;
  EXPECT_EQ(text_at(alarm->place), wanted.at);
}

std::string TextTest::text_at(const base::Place& place) const {
  return read_file(path_).substr(place.line_start + place.column - 1, std::max(1U, place.length));
}

// In the order of their lines; no others.
void TextTest::check_warnings() {
  std::vector<base::Diagnostic> got = machine_->control().warnings();
  std::stable_sort(got.begin(), got.end(),
                   [](const auto& a, const auto& b) { return a.place.line < b.place.line; });
  std::string list;
  for (const base::Diagnostic& warning : got)
    list += "\n    line " + std::to_string(warning.place.line) + " " + warning.number + " " +
            warning.message;
  ASSERT_EQ(got.size(), expected_.warnings.size()) << "warnings:" << list;
  for (std::size_t i = 0; i < got.size(); ++i) {
    const WantedWarning& wanted = expected_.warnings[i];
    EXPECT_EQ(got[i].number, wanted.number) << list;
    EXPECT_EQ(got[i].place.line, wanted.line) << list;
    if (wanted.at.empty()) continue;
    EXPECT_EQ(text_at(got[i].place), wanted.at);
  }
}

void TextTest::check_end() {
  const std::string wanted = !expected_.status.empty() ? expected_.status
                             : expected_.alarm         ? "alarm"
                                                       : "end";
  EXPECT_EQ(status_name(machine_->status()), wanted);
  check_variables(expected_.variables, "finally");
  std::string prints;
  for (const std::string& line : expected_.prints) prints += line + "\n";
  if (!expected_.prints.empty()) {
    EXPECT_EQ(printed_, prints);
  }
  if (!expected_.printed) return;
  std::string printed = printed_;
  std::replace(printed.begin(), printed.end(), '\n', '|');
  EXPECT_EQ(printed, *expected_.printed);
}

void TextTest::check_list(const std::vector<std::string>& wanted, const std::vector<Observed>& got,
                          const std::string& what) {
  std::string list;
  for (const Observed& item : got) list += "\n    " + item.text;
  EXPECT_EQ(wanted.size(), got.size()) << what << ":" << list;
  for (std::size_t i = 0; i < std::min(wanted.size(), got.size()); ++i) {
    EXPECT_EQ(difference(wanted[i], got[i], machine_->definition().axes), "")
        << what << ", number " << i + 1 << ": wanted " << wanted[i] << ", got" << list;
  }
}

void TextTest::check_moves() {
  std::vector<Observed> all;
  for (const Observed& item : recorder_->observed()) {
    if (item.moves) all.push_back(item);
  }
  if (expected_.moves) check_list(*expected_.moves, all, "all moves");
  for (const auto& [line, wanted] : expected_.moves_of_line) {
    std::vector<Observed> of_line;
    std::copy_if(all.begin(), all.end(), std::back_inserter(of_line),
                 [&, at = line](const Observed& item) { return item.line == at; });
    check_list(wanted, of_line, "moves of line " + std::to_string(line));
  }
}

void TextTest::check_counts() {
  std::map<std::string, std::size_t> counts;
  double lines_mm = 0;
  base::TipPoint from = machine_->definition().axes.start;
  for (const Observed& item : recorder_->observed()) {
    if (!item.moves) continue;
    ++counts[item.text.substr(0, item.text.find(' '))];
    const base::TipPoint to = *motion::target_of(item.motion);
    const base::AxisVector way = to - from;
    if (std::holds_alternative<motion::Line>(item.motion.action))
      lines_mm += std::hypot(way.values[0], way.values[1], way.values[2]);
    from = to;
  }
  if (!expected_.counts.empty()) {
    EXPECT_EQ(counts, expected_.counts);
  }
  if (expected_.lines_mm) {
    EXPECT_NEAR(lines_mm, *expected_.lines_mm, kVariableTolerance);
  }
}

// The wanted records in this order, others between them.
void TextTest::check_records() {
  if (!expected_.records) return;
  std::string list;
  for (const Observed& item : recorder_->observed()) list += "\n    " + item.text;
  auto at = recorder_->observed().begin();
  for (const std::string& wanted : *expected_.records) {
    at = std::find_if(at, recorder_->observed().end(),
                      [&](const Observed& item) { return item.text == wanted; });
    ASSERT_NE(at, recorder_->observed().end())
        << "no record " << wanted << " (in this order) among" << list;
    ++at;
  }
}

void TextTest::check_assumed() {
  const auto& list = machine_->control().assumptions().list();
  for (const auto& [line, text] : expected_.assumed_in_line) {
    const bool found = std::any_of(
        list.begin(), list.end(),
        [&, at = line, what = text](const control::Assumption& assumption) {
          return assumption.line == at && assumption.what.find(what) != std::string::npos;
        });
    EXPECT_TRUE(found) << "line " << line << " does not assume: " << text;
  }
  for (const control::Assumption& assumption : list) {
    EXPECT_FALSE(expected_.nothing_assumed)
        << "line " << assumption.line << ": " << assumption.what;
  }
}

void TextTest::check_positions() {
  const base::AxisVector machine = machine_->control().machine_position();
  const base::AxisVector work = machine - machine_->control().work_origin();
  const auto check = [&](const std::vector<WantedPosition>& wanted, const base::AxisVector& got,
                         const char* system) {
    for (const WantedPosition& item : wanted) {
      const auto axis = machine_->definition().axes.find(item.axis);
      ASSERT_TRUE(axis) << item.axis;
      const double count = machine_->definition().axes[*axis].count_per_mm();
      EXPECT_NEAR(got[*axis] * count, item.value, 6e-4) << system << " " << item.axis;
    }
  };
  check(expected_.machine, machine, "machine");
  check(expected_.work, work, "work");
}

void TextTest::TestBody() {
  prepare();
  if (HasFatalFailure()) return;
  run();
  check_alarm();
  check_end();
  check_moves();
  check_counts();
  check_records();
  check_warnings();
  check_assumed();
  check_positions();
}

std::string name_of(const fs::path& path) {
  std::string name = path.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0 && c != '_'; },
      '_');
  return name;
}

// One test per program; a folder without programs is a mistake.
void register_folder(const fs::path& folder) {
  std::vector<fs::path> programs;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const fs::path& path = entry.path();
    if (is_program(path)) programs.push_back(path);
  }
  std::sort(programs.begin(), programs.end());
  const std::string area = folder.filename().string();
  if (programs.empty()) {
    std::fprintf(stderr, "no programs in %s\n", folder.c_str());
    std::exit(1);
  }
  for (const fs::path& program : programs) {
    testing::RegisterTest(area.c_str(), name_of(program).c_str(), nullptr, nullptr, program.c_str(),
                          1, [=]() -> testing::Test* { return new TextTest(program); });
  }
}

}  // namespace
}  // namespace kerf::test

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  std::vector<std::filesystem::path> folders;
  for (const auto& entry : std::filesystem::directory_iterator(KERF_TEXT_TESTS)) {
    if (entry.is_directory()) folders.push_back(entry.path());
  }
  std::sort(folders.begin(), folders.end());
  for (const auto& folder : folders) kerf::test::register_folder(folder);
  return RUN_ALL_TESTS();
}
