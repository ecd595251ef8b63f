// A program that runs by simulated time does what it does in a batch run: the same set-points, byte
// by byte, the same variables, the same place and time, however time is cut.
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <sstream>

#include "bench.hpp"
#include "machine/run/batch_run.hpp"

namespace kerf::test {
namespace {

namespace fs = std::filesystem;

struct Program {
  std::string path;
  std::string machine;
  std::string dialect;
};

std::vector<Program> examples() {
  std::vector<Program> programs;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(KERF_EXAMPLES)) {
    const std::string ending = entry.path().extension();
    if (ending == ".nc") programs.push_back({entry.path(), "mill3", ""});
    if (ending == ".bas") programs.push_back({entry.path(), "laser3", "laser-basic"});
    if (ending == ".tch") programs.push_back({entry.path(), "laser5", "teach"});
  }
  std::sort(programs.begin(), programs.end(),
            [](const Program& a, const Program& b) { return a.path < b.path; });
  return programs;
}

// What is left of a run, as far as a second one can be held against it.
struct Result {
  std::size_t count = 0;
  std::uint64_t hash = 1469598103934665603ULL;
  std::string variables;
  double time_s = 0;
  base::AxisVector position;
  std::string end;
};

class Fingerprint : public motion::AxisPointSink {
 public:
  void take(const motion::AxisPoint& point) override {
    ++result.count;
    add(point.tip.time_s);
    for (const double value : point.tip.tip.values) add(value);
    for (const double value : point.joints.values) add(value);
    add(static_cast<double>(point.tip.mark.block.line));
    add(static_cast<double>(point.tip.mark.motion));
  }
  Result result;

 private:
  void add(double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    result.hash = (result.hash ^ bits) * 1099511628211ULL;
  }
};

std::string text_of(const std::vector<std::pair<std::string, double>>& values) {
  std::ostringstream text;
  text.precision(17);
  for (const auto& [name, value] : values) text << name << '=' << value << ' ';
  return text.str();
}

Result run_batch(const machine::MachineDefinition& definition, const Program& program) {
  machine::BatchRun machine(definition, control::Memory(definition.parameters.n_offsets),
                            {.dialect = program.dialect});
  Fingerprint print;
  machine.add_point_sink(print);
  machine.load(std::move(*base::SourceFile::open(program.path)));
  using BatchStatus = machine::RunStatus;
  BatchStatus status = BatchStatus::running;
  while (status == BatchStatus::running || status == BatchStatus::stopped)
    status = machine.cycle_start({.seconds = 0});
  std::vector<std::pair<std::string, double>> values;
  for (const auto& variable : machine.variables())
    values.emplace_back(variable.name, variable.value);
  print.result.variables = text_of(values);
  print.result.time_s = machine.time_s();
  print.result.position = machine.position();
  print.result.end = status == BatchStatus::end ? "end" : "alarm";
  if (machine.alarm()) print.result.end += " " + machine.alarm()->number;
  return print.result;
}

Result run_live(const machine::MachineDefinition& definition, const Program& program,
                const std::function<double()>& step_s) {
  LiveMachine::Settings settings;
  settings.dialect = program.dialect;
  LiveMachine machine(definition, control::Memory(definition.parameters.n_offsets), settings);
  Fingerprint print;
  machine.add_point_sink(print);
  EXPECT_DONE(machine.perform(Load{base::ProgramText::at_path(program.path)}));
  EXPECT_DONE(machine.perform(CycleStart{}));
  for (Status status = Status::running; status == Status::running || status == Status::stopped;) {
    if (status == Status::stopped) {
      EXPECT_DONE(machine.perform(CycleStart{}));
    }
    machine.advance(step_s());
    status = machine.snapshot()->status;
  }
  std::vector<std::pair<std::string, double>> values;
  for (const auto& row : machine.variables(0).rows) {
    if (row.value == row.value) values.emplace_back(row.name, row.value);
  }
  const machine::Snapshot shown = *machine.snapshot();
  print.result.variables = text_of(values);
  print.result.time_s = shown.time_s;
  print.result.position = shown.machine;
  print.result.end = name_of(shown.status);
  if (shown.alarm) print.result.end += " " + shown.alarm->code;
  return print.result;
}

class EveryExample : public ::testing::TestWithParam<Program> {};

TEST_P(EveryExample, DoesTheSameLive) {
  machine::MachineDefinition definition = *machine::find_machine(GetParam().machine);
  definition.interpolator.period_s = 0.004;  // fewer points to make
  const Result batch = run_batch(definition, GetParam());
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(1e-4, 3);
  const std::vector<std::pair<std::string, std::function<double()>>> cuts = {
      {"7 ms", [] { return 0.007; }}, {"1 s", [] { return 1.0; }}, {"random", [&] {
                                                                      return any(random);
                                                                    }}};
  for (const auto& [name, step_s] : cuts) {
    const Result live = run_live(definition, GetParam(), step_s);
    EXPECT_EQ(live.count, batch.count) << name;
    EXPECT_EQ(live.hash, batch.hash) << name;
    EXPECT_EQ(live.variables, batch.variables) << name;
    EXPECT_EQ(live.end, batch.end) << name;
    EXPECT_EQ(live.position, batch.position) << name;
    if (batch.count > 0) {
      EXPECT_DOUBLE_EQ(live.time_s, batch.time_s) << name;
    }
  }
}

std::string name_of_case(const ::testing::TestParamInfo<Program>& info) {
  std::string name = fs::path(info.param.path).parent_path().filename().string() + "_" +
                     fs::path(info.param.path).stem().string();
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Examples, EveryExample, ::testing::ValuesIn(examples()), name_of_case);

// Clocks, dwells, stops and calls in small: what the examples may not have.
TEST(LiveMachine, AClockThatAProgramReadsIsThatOfTheBatchRun) {
  const std::string text =
      "O1\nG91G01X10.F600\n#500=#3001\nX5.\nG04X0.5\n#501=#3001\n#3001=0\nX1.\n#502=#3001\nM30\n";
  const fs::path path = fs::path(::testing::TempDir()) / "clock.nc";
  std::ofstream(path) << text;
  const machine::MachineDefinition definition = *machine::find_machine("mill3");
  const Program program{path, "mill3", ""};
  const Result batch = run_batch(definition, program);
  const Result live = run_live(definition, program, [] { return 0.0031; });
  EXPECT_EQ(live.variables, batch.variables);
  EXPECT_EQ(live.hash, batch.hash);
  EXPECT_EQ(live.time_s, batch.time_s);
  EXPECT_NE(batch.variables.find("#501="), std::string::npos);
}

TEST(LiveMachine, TheLineShownIsThatOfTheAxesNotThatOfTheControl) {
  Bench bench;
  bench.start("O1\nG91G94G01X10.F600\nX10.\nX10.\nX10.\nM30\n");
  for (int i = 0; i < 600; ++i) {
    bench->advance(0.01);
    const machine::Snapshot shown = bench.now();
    if (shown.status != Status::running) break;
    const double at = shown.machine.values[0];
    if (at < 0.5 || std::fabs(at - 10 * std::round(at / 10)) < 0.5) continue;
    EXPECT_EQ(shown.line, 2 + static_cast<std::uint32_t>(at / 10)) << at;
    EXPECT_EQ(shown.motion, 1 + static_cast<std::uint64_t>(at / 10)) << at;
    EXPECT_EQ(shown.text, shown.line == 2 ? "G91G94G01X10.F600" : "X10.");
    EXPECT_NEAR(shown.feed_programmed_mm_min, 600, 1e-4);
    EXPECT_NEAR(shown.distance.values[0], 10 * std::ceil(at / 10) - at, 0.02);
  }
  EXPECT_EQ(bench.status(), Status::end);
  EXPECT_EQ(bench.x(), 40);
}

TEST(LiveMachine, ModalCodesAreThoseOfTheMotionUnderWay) {
  Bench bench;
  bench.start("O1\nG91G01X10.F600\nG90G00X20.\nG55\nM30\n", 0.5);
  const auto has = [&](const std::string& code) {
    const auto modal = bench.now().modal;
    return std::find(modal.begin(), modal.end(), code) != modal.end();
  };
  EXPECT_TRUE(has("G91") && has("G01") && has("G54"));
  EXPECT_EQ(bench.settle(), Status::end);
  EXPECT_TRUE(has("G90") && has("G00") && has("G55"));
}

}  // namespace
}  // namespace kerf::test
