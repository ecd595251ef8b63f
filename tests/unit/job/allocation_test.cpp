// In the steady state a block allocates nothing: this program counts every call of operator new.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <functional>
#include <new>

#include "allocation_count.hpp"
#include "base/output_file.hpp"
#include "drive/pulse_csv.hpp"
#include "drive/pulse_vcd.hpp"
#include "job/facts_of_run.hpp"
#include "machine/run/batch_run.hpp"
#include "output/programs/post.hpp"
#include "output/programs/taught_program.hpp"
#include "output/records/motion_json.hpp"
#include "output/records/row_csv.hpp"
#include "output/records/set_point_csv.hpp"
#include "output/records/step_pulses.hpp"
#include "output/reports/coverage.hpp"

namespace {
std::atomic<std::uint64_t> allocations{0};

void* counted(std::size_t size) {
  ++allocations;
  if (void* const memory = std::malloc(size != 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return counted(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace kerf::test {

std::uint64_t allocations_so_far() { return allocations; }

namespace {

constexpr std::uint64_t kPasses = 100'000;
/// What may still grow now and then, whatever the number of blocks: tables that double.
constexpr std::uint64_t kConstant = 32;

/// Reads the counter when the steady state begins, and at the end.
class Watch : public motion::MotionSink {
 public:
  explicit Watch(std::uint64_t begin_at) : begin_at_(begin_at) {}
  void take(const motion::Motion&) override {
    ++motions_;
    if (motions_ == begin_at_) begin_ = allocations;
    end_ = allocations;
  }
  [[nodiscard]] std::uint64_t motions() const { return motions_; }
  [[nodiscard]] std::uint64_t allocated() const { return end_ - begin_; }

 private:
  std::uint64_t begin_at_;
  std::uint64_t motions_ = 0;
  std::uint64_t begin_ = 0;
  std::uint64_t end_ = 0;
};

struct Outputs {
  bool motion = false;
  bool post = false;
  bool coverage = false;
  bool points = false;
  bool pulses = false;
  bool rows = false;
  bool taught = false;
  std::string machine = "mill3";
  std::string dialect{};
};

// Runs a program and expects nothing to be allocated in its last three quarters.
void expect_no_allocation(const std::string& program, const Outputs& outputs = {},
                          std::uint64_t least_motions = kPasses) {
  const machine::MachineDefinition definition = *machine::find_machine(outputs.machine);
  control::Memory memory(definition.parameters.n_offsets);
  memory.tools[1].radius_geometry = 3;
  machine::BatchRun machine(definition, std::move(memory), {.dialect = outputs.dialect});
  Watch watch(least_motions / 4);
  const auto nowhere = std::move(*base::OutputFile::create("/dev/null"));
  output::MotionJson motion(machine.definition().axes, &machine.sources(), *nowhere);
  output::Post post(machine.definition(), "part", *nowhere);
  output::Coverage coverage;
  output::SetPointCsv points(machine.definition(), *nowhere);
  drive::PulseCsv csv({"X", "Y", "Z"}, *nowhere);
  drive::PulseVcd vcd({"X", "Y", "Z"}, definition.drive.timing.direction_setup_ns, *nowhere);
  const output::DriveFault fault = job::alarm_of(machine);
  output::StepPulses csv_pulses(definition, fault, csv);
  output::StepPulses vcd_pulses(definition, fault, vcd);
  if (outputs.points) machine.add_point_sink(points);
  if (outputs.pulses) {
    machine.add_point_sink(csv_pulses);
    machine.add_point_sink(vcd_pulses);
  }
  output::RowCsv rows(machine.definition().axes, machine.memory(), *nowhere);
  if (outputs.rows) machine.add_sink(rows);
  if (outputs.motion) machine.add_sink(motion);
  if (outputs.post) machine.add_sink(post);
  output::TaughtProgram taught(definition.axes, {}, fault, *nowhere);
  if (outputs.taught) machine.add_sink(taught);
  if (outputs.coverage) {
    machine.observe_blocks(
        [&](base::FileId file, std::uint32_t line) { coverage.count(file, line); });
  }
  machine.set_print_output([&](std::string_view text) { nowhere->write(text); });
  machine.add_sink(watch);
  machine.load(base::SourceFile::from_text("part.nc", program));
  const auto status = machine.run_to_end({.seconds = 0, .motions = 0});
  ASSERT_EQ(status, machine::RunStatus::end)
      << (machine.alarm() ? machine.alarm()->number + " " + machine.alarm()->message : "");
  ASSERT_GE(watch.motions(), least_motions);
  EXPECT_LE(watch.allocated(), kConstant)
      << static_cast<double>(watch.allocated()) / (0.75 * static_cast<double>(watch.motions()))
      << " allocations per motion";
}

std::string loop(const std::string& blocks, std::uint64_t passes = kPasses) {
  return "O1\nG21G90G17G94F500S100\n#1=0\nWHILE[#1LT" + std::to_string(passes) + "]DO1\n" + blocks +
         "#1=#1+1\nEND1\nM30\nO2\nG01X[#1/1000]\nM99\nO3\nG01X#24Y#25\nM99\n";
}

TEST(NoAllocation, InALoopOfLines) { expect_no_allocation(loop("G01X[#1/1000]Y1.\n")); }

TEST(NoAllocation, InALoopOfArcs) { expect_no_allocation(loop("G02X10.Y0R5.\nG03X0Y0I-5.J0\n")); }

TEST(NoAllocation, InALoopOfModalCodesAndMiscellaneousFunctions) {
  expect_no_allocation(loop("G91G01X.001\nG90G55\nG54M08\nG00X0\nM09T5\nM60\n"));
}

TEST(NoAllocation, InALoopOfCannedCycles) {
  expect_no_allocation(loop("G99G83X[#1/1000]Z-10.R2.Q4.\nG80\n", kPasses / 5));
}

TEST(NoAllocation, InALoopThatCompensatesTheCutter) {
  expect_no_allocation(loop("G41D1G01X0Y0\nY50.\nX50.\nM08\nY0\nX0\nG40X-20.Y-10.\n", kPasses / 5));
}

TEST(NoAllocation, InALoopThatCallsSubprograms) { expect_no_allocation(loop("M98P2\n")); }

TEST(NoAllocation, InALoopThatCallsMacros) { expect_no_allocation(loop("G65P3X[#1/1000]Y2.\n")); }

TEST(NoAllocation, InALoopUnderAModalCall) {
  expect_no_allocation("O1\nG21G90G17G94F500\nG66P3X1.Y2.\n#1=0\nWHILE[#1LT" +
                       std::to_string(kPasses) +
                       "]DO1\nG01X[#1/1000]\n#1=#1+1\nEND1\nG67\nM30\nO3\nG01Z#24\nM99\n");
}

TEST(NoAllocation, InALoopThatJumps) {
  expect_no_allocation(loop("IF[#1GT-1]GOTO7\nN6G01Y1.\nGOTO8\nN7G01X[#1/1000]\nGOTO6\nN8\n"));
}

TEST(NoAllocation, InALoopThatComputesItsJumps) {
  expect_no_allocation(loop("GOTO[6+[#1MOD2]]\nN6G01X[#1/1000]\nGOTO8\nN7G01X-[#1/1000]\nN8\n"));
}

TEST(NoAllocation, InALoopThatTurnsScalesAndMirrors) {
  expect_no_allocation(
      loop("G68X0Y0R[#1/1000]\nG01X10.Y[#1/1000]\nG69\nG51X0Y0P2000\nG01X1.\nG50\n"));
}

TEST(NoAllocation, InALoopThatUsesFunctionsAndSystemVariables) {
  expect_no_allocation(
      loop("#2=SIN[#1]*COS[#1]+ATAN[#1]/[2]+SQRT[#1]\n#5221=#1/10000\n#3=#5001+#4003\n"
           "G01X[#2]Y[#1/1000]\n#[100+[#1MOD50]]=#2\n"));
}

TEST(NoAllocation, InALoopThatPrints) {
  expect_no_allocation(loop("DPRNT[PASS*#1[60]*AT*X#5001[43]]\nG01X[#1/1000]\n"));
}

// Arithmetic, conditions, routines with variables of their own, inner loops, prints and motions.
TEST(NoAllocation, InALoopOfLaserBasic) {
  expect_no_allocation(
      "speed(50);power(60)\nfor i=1 to 20000\nx=i/1000;y=10*sin(x)^2\n"
      "if x>1 and y<>0 then line(x,y) else move(x,0)\nprint i;x,\"text\"\ngosub sub\nnext\nend\n"
      "sub: local x,y\nfor j=1 to 2\nx=j+mod(i,3)+dist(0,0)\narc(j,j,2,0,90)\nnext\nreturn\n",
      {.machine = "laser3", .dialect = "laser-basic"});
}

TEST(NoAllocation, InALoopOverManyPages) {
  std::string blocks;
  for (int i = 0; i < 3000; ++i) blocks += "G01X[#1+" + std::to_string(i) + ".]\n";
  expect_no_allocation(loop(blocks, 100), {}, 200'000);
}

std::string straight(std::uint64_t lines, const std::function<std::string(std::uint64_t)>& block) {
  std::string text = "O1\nG21G90G17G94F500\n";
  for (std::uint64_t i = 0; i < lines; ++i) text += block(i);
  return text + "M30\n";
}

TEST(NoAllocation, InAStraightProgram) {
  expect_no_allocation(straight(kPasses + 1, [](std::uint64_t i) {
    return "G01X" + std::to_string(i % 397) + ".Y-" + std::to_string(i % 241) + ".5\n";
  }));
}

TEST(NoAllocation, InAStraightProgramWithNumbersCommentsAndArcs) {
  expect_no_allocation(straight(kPasses, [](std::uint64_t i) {
    const std::string line = "N" + std::to_string(i + 1) + " (STEP " + std::to_string(i) +
                             ") G01 X" + std::to_string(i % 397) + ". F" +
                             std::to_string(100 + i % 5) + "\n";
    return i % 3 == 0 ? line + "G02 I5.\n" : line;
  }));
}

std::string taught(std::uint64_t passes) {
  std::string text = "TEACH 1\nPOINT 0 0 0 0 0 here\nFEED 600\n";
  for (std::uint64_t i = 0; i < passes; ++i)
    text += "LINE " + std::to_string(i % 97 + 1) +
            " 3 1 0.5 2 ; along\nARC 1 2 3 4 5 7 3 3 0 1\nLASER ON " + std::to_string(i % 100) +
            "\nDWELL 0.1\nCIRCLE 2 2 2 0 0 3 3 5 1 1\nPOINT 0 0 0 0 0 there\n";
  return text + "END\n";
}

TEST(NoAllocation, OfTaughtPoints) {
  expect_no_allocation(taught(kPasses / 6 + 1), {.machine = "laser5", .dialect = "teach"});
}

TEST(NoAllocation, WhileTaughtPointsAreWritten) {
  expect_no_allocation(taught(kPasses / 6 + 1),
                       {.taught = true, .machine = "mill5", .dialect = "teach"});
  expect_no_allocation(loop("G01X[#1/997]Y1.\nG02I5.\nG03X0Y0R60.\n"), {.taught = true});
}

TEST(NoAllocation, WhileMotionsAreWritten) {
  expect_no_allocation(loop("G01X[#1/997]Y1.\nG02I5.\n"), {.motion = true});
}

TEST(NoAllocation, WhilePlainCodeIsWritten) {
  expect_no_allocation(loop("G01X[#1/997]Y1.\nG02I5.\n"), {.post = true});
}

TEST(NoAllocation, WhileSetPointsAreWritten) {
  expect_no_allocation(loop("G01X[#1/97]Y[#1/83]F6000\n"), {.points = true});
}

TEST(NoAllocation, WhilePulsesAreWritten) {
  expect_no_allocation(loop("G01X[#1/97]Y[#1/83]F6000\n"), {.pulses = true});
}

TEST(NoAllocation, WhileRowsAreWritten) {
  expect_no_allocation(loop("G01X[#1/997]Y1.\nG02I5.\n"), {.rows = true});
}

TEST(NoAllocation, WhileLinesAreCounted) {
  expect_no_allocation(loop("G01X[#1/997]Y1.\n"), {.coverage = true});
}

}  // namespace
}  // namespace kerf::test
