// What was done in a run can be written, read and done again: the same points, bytes and memory.
#include <bit>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>

#include "bench.hpp"
#include "machine/definition/state_file.hpp"
#include "random_operator.hpp"

namespace kerf::test {
namespace {

/// The points of the run under way.
class PointsOfRun : public motion::AxisPointSink {
 public:
  void start(const motion::AxisPoint& at) override {
    all.clear();
    is_whole = at.tip.time_s == 0;
  }
  void take(const motion::AxisPoint& point) override { all.push_back(point); }
  std::vector<motion::AxisPoint> all;
  bool is_whole = true;  ///< behind a step back it begins in the middle
};

bool same_points(const PointsOfRun& a, const PointsOfRun& b) {
  return std::equal(a.all.begin(), a.all.end(), b.all.begin(), b.all.end(),
                    [](const motion::AxisPoint& one, const motion::AxisPoint& other) {
                      return one.tip.time_s == other.tip.time_s && one.tip.tip == other.tip.tip &&
                             one.joints == other.joints;
                    });
}

base::Outcome<LiveMachine> made_again(const std::string& journal, PointsOfRun& points) {
  return LiveMachine::from_journal(journal, {}, {.motions = {}, .points = {&points}}, {});
}

void expect_same(LiveMachine& a, LiveMachine& b) {
  const auto one = a.snapshot();
  const auto other = b.snapshot();
  EXPECT_EQ(one->status, other->status);
  EXPECT_EQ(one->time_s, other->time_s);
  EXPECT_EQ(one->run, other->run);
  EXPECT_EQ(one->line, other->line);
  EXPECT_EQ(one->joints, other->joints);
  EXPECT_EQ(one->machine, other->machine);
  EXPECT_EQ(one->modal, other->modal);
  EXPECT_EQ(one->panel, other->panel);
  EXPECT_EQ(one->alarm, other->alarm);
  EXPECT_EQ(one->stack, other->stack);
  EXPECT_EQ(one->printed, other->printed);
  EXPECT_EQ(one->inputs, other->inputs);
  EXPECT_EQ(machine::state_text(a.memory()), machine::state_text(b.memory()));
}

std::string journal_of(LiveMachine& machine) {
  const auto text = machine.journal();
  EXPECT_TRUE(text) << (text ? "" : text.error().message);
  return text.value_or("");
}

std::string refusal_of(const std::string& journal) {
  PointsOfRun points;
  const auto made = made_again(journal, points);
  return made ? "" : made.error().message;
}

/// With `what` replaced, once.
std::string with(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

TEST(Journal, WhatARandomOperatorDidIsMadeAgain) {
  constexpr int kOperators = 16;
  constexpr int kActions = 60;
  for (int seed = 1; seed <= kOperators; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Bench bench;
    PointsOfRun points;
    bench->add_point_sink(points);
    bench.load(kOperatedProgram);
    Operator person(bench, static_cast<unsigned>(seed));
    for (int i = 0; i < kActions; ++i) {
      person.act();
      bench->advance(person.pause_s());
      if (i % 12 != 11) continue;
      const std::string text = journal_of(*bench);
      PointsOfRun again;
      auto other = made_again(text, again);
      ASSERT_TRUE(other) << other.error().message;
      EXPECT_TRUE(!points.is_whole || same_points(points, again)) << person.trail();
      expect_same(*bench, *other);
      EXPECT_EQ(journal_of(*other), text) << person.trail();
      ASSERT_FALSE(testing::Test::HasFailure()) << text;
    }
  }
}

TEST(Journal, AMachineMadeAgainGoesOnAsTheOther) {
  Bench bench;
  bench.start("O1\nN1G90G94G01X10.F600\nDPRNT[X#500[31]]\nM00\nX20.\n#500=5\nM30\n", 0.4);
  PointsOfRun points;
  auto other = made_again(journal_of(*bench), points);
  ASSERT_TRUE(other);
  for (LiveMachine* const machine : {&*bench, &*other}) {
    machine->advance(60);
    EXPECT_DONE(machine->perform(CycleStart{}));
    machine->advance(60);
  }
  EXPECT_EQ(bench.status(), Status::end);
  expect_same(*bench, *other);
}

TEST(Journal, EveryKeyIsWritten) {
  Bench bench;
  bench.load("O1\n/1G90G94G01X10.F600\n#100=[#1000]\nG01X20.\nM30\n");
  EXPECT_DONE(bench->perform(SetBreakpoints{{{"part.nc", 4, "#100GT5", ""}, {"", 0, "", "#101"}}}));
  EXPECT_DONE(bench->perform(SetDials{50, {}, 110}));
  EXPECT_DONE(bench->perform(SetInput{"#1003", 1}));
  EXPECT_DONE(bench->perform(SetVariable{"#101", 0.1, {}}));
  EXPECT_DONE(bench->perform(SetVariable{"#102", {}, {}}));
  EXPECT_DONE(bench->perform(SetOffset{"G54", "X", -12.5}));
  EXPECT_DONE(bench->perform(SetOffset{"tool.5.length_wear", "", 0.25}));
  EXPECT_DONE(bench->perform(TurnSwitch{Switch::dry_run, true}));
  EXPECT_DONE(bench->perform(SetBlockSkip{1U << 1U | 1U << 9U}));
  EXPECT_DONE(bench->perform(EnterLine{"12"}));
  EXPECT_DONE(bench->perform(SetMode{Mode::jog}));
  EXPECT_DONE(bench->perform(JogBy{"Y", -4}));
  bench->advance(10);
  EXPECT_DONE(bench->perform(Jog{"X", 500}));
  bench->advance(0.5);
  EXPECT_DONE(bench->perform(JogStop{}));
  bench->advance(10);
  EXPECT_DONE(bench->perform(SetMemory{bench->memory()}));
  EXPECT_DONE(bench->perform(SetMode{Mode::mdi}));
  EXPECT_DONE(bench->perform(EnterBlocks{"G91G01X1.F500"}));
  EXPECT_DONE(bench->perform(FeedHold{}));
  bench->advance(10);
  EXPECT_DONE(bench->perform(Reset{}));
  bench->advance(10);
  EXPECT_DONE(bench->perform(SetMode{Mode::reference}));
  EXPECT_DONE(bench->perform(Home{}));
  bench->advance(60);
  const std::string text = journal_of(*bench);
  PointsOfRun points;
  auto other = made_again(text, points);
  ASSERT_TRUE(other) << other.error().message;
  expect_same(*bench, *other);
  EXPECT_EQ(journal_of(*other), text);
}

TEST(Journal, TextThatIsNoUtf8StaysAsItIs) {
  Bench bench;
  bench.start("O1\n(\xa4\x51)\nDPRNT[\xe9]\nM30\n");
  bench.settle();
  PointsOfRun points;
  auto other = made_again(journal_of(*bench), points);
  ASSERT_TRUE(other) << other.error().message;
  EXPECT_EQ(*other->program()->text, *bench->program()->text);
  EXPECT_EQ(other->snapshot()->printed, bench.now().printed);
}

TEST(Journal, WhatIsNoJournalIsRefusedInASentence) {
  Bench bench;
  bench.load("O1\n/1G01X10.F600\nM30\n");
  EXPECT_DONE(bench->perform(SetDials{50, {}, {}}));
  const std::string text = journal_of(*bench);
  ASSERT_EQ(refusal_of(text), "");
  const auto refused = [&](const std::string& journal, const std::string& words) {
    const std::string why = refusal_of(journal);
    EXPECT_TRUE(why.starts_with("journal: ")) << why;
    EXPECT_NE(why.find(words), std::string::npos) << why;
  };
  refused("", "not a journal");
  refused("{}", "not a journal");
  refused("[1, 2", "not a journal");
  refused(text.substr(0, text.size() / 2), "not a journal");
  refused(std::string(100'000, '['), "too deep");
  refused(with(text, "\"kerf_journal\": 1", "\"kerf_journal\": 2"), "version");
  refused(with(text, "\"override\"", "\"overtake\""), "no key overtake");
  refused(with(text, "\"feed\": 50", "\"feed\": 201"), "0 to 200");
  refused(with(text, "\"feed\": 50", "\"feed\": 50, \"before_block\": 2"), "before_block");
  refused(with(text, "\"do\": \"override\",", "\"do\": \"step\", \"how\": \"back\", \"x\": 1,"),
          "");
  refused(with(text, "\"until\"", "\"unto\""), "until is missing");
  refused(with(text, "\"mode\": \"auto\"", "\"mode\": \"fly\""), "mode");
  refused(with(text, "\"printed\"", "\"painted\""), "printed is missing");
  refused(with(text, "\"machine\": \"", "\"machine\": \"["), "machine");
  refused(std::string(LiveMachine::kMostJournalBytes + 1, ' '), "bytes");
}

// Each time another byte is another one: it is refused in a sentence, or a run like any other.
TEST(Journal, DamagedAnywhereItEndsInASentence) {
  Bench bench;
  bench.load("O1\n/1G01X10.F600\nM30\n");
  EXPECT_DONE(bench->perform(SetBlockSkip{1U << 1U}));
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(0.2);
  const std::string text = journal_of(*bench);
  std::mt19937 random(1);
  const auto number = [&](std::size_t below) {
    return std::uniform_int_distribution<std::size_t>(0, below - 1)(random);
  };
  const std::size_t machine = text.find("\"joints\"");
  for (int i = 0; i < 100; ++i) {
    std::string damaged = text;
    damaged[machine + number(text.size() - machine)] = "0123456789-.e\"[]{},x\xff"[number(21)];
    const auto made = LiveMachine::from_journal(damaged, {}, {}, base::WorkLimit(0.05));
    if (!made) {
      EXPECT_FALSE(made.error().message.empty()) << damaged;
    }
  }
}

TEST(Journal, WhatItCannotHoldIsSaid) {
  Bench bench;
  const auto why = [&] {
    const auto text = bench->journal();
    return text ? std::string() : text.error().message;
  };
  bench.load(std::string(LiveMachine::kMostJournalProgramBytes + 1, '\n'));
  EXPECT_NE(why().find("8 MiB"), std::string::npos) << why();
  bench.start("O1\nM30\n");
  EXPECT_EQ(why(), "");
  Bench nameless("mill3");
  const auto definition = *machine::find_machine("mill3");
  LiveMachine machine(definition, control::Memory(definition.parameters.n_offsets));
  ASSERT_FALSE(machine.journal());
  EXPECT_NE(machine.journal().error().message.find("machine has no file"), std::string::npos);
}

TEST(Journal, TheLimitEndsWhatGoesOnForEver) {
  Bench bench;
  bench.start("O1\nN1G04X1000.\nGOTO1\nM30\n", 0.1);
  const std::string text =
      with(journal_of(*bench), "\"until\": [", "\"until\": [\n 90000000000],\n \"x\": [");
  const auto made = LiveMachine::from_journal(text, {}, {}, base::WorkLimit(0.2));
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, "takes-too-long");
}

// A run with all that is done again in a way of its own: a hold, a switch and a variable that act
// on later blocks, a step back, an alarm at its end.
std::string operated_journal() {
  Bench bench;
  bench.load(
      "O1\nN1G90G94G00X5.Y0Z2.\nDPRNT[START]\nG01Z-1.F1500\nG91G64\n#100=0\nWHILE[#100LT20]DO1\n"
      "X1.Y0.5\n/X0.3Y1.\nX[#101/10]\n#100=#100+1\nEND1\nM00\nG90G04X0.2\n#102=1/0\nM30\n");
  EXPECT_DONE(bench->perform(SetDials{80, {}, {}}));
  EXPECT_DONE(bench->perform(CycleStart{}));
  bench->advance(0.4);
  EXPECT_DONE(bench->perform(SetBlockSkip{1U << 1U}));
  EXPECT_DONE(bench->perform(FeedHold{}));
  bench->advance(1);
  EXPECT_DONE(bench->perform(SetVariable{"#101", 4, {}}));
  EXPECT_DONE(bench->perform(TakeStep{machine::Step::into}));
  EXPECT_EQ(bench.settle(), Status::step);
  EXPECT_DONE(bench->perform(CycleStart{}));
  EXPECT_EQ(bench.settle(), Status::stopped);
  EXPECT_DONE(bench->perform(StepBack{}));
  EXPECT_DONE(bench->perform(SetDials{100, {}, {}}));
  EXPECT_DONE(bench->perform(CycleStart{}));
  EXPECT_EQ(bench.settle(), Status::stopped);
  EXPECT_DONE(bench->perform(CycleStart{}));
  EXPECT_EQ(bench.settle(), Status::alarm);
  return journal_of(*bench);
}

// The file is made anew by KERF_WRITE_JOURNAL=tests/live/journals/operated.journal.json.
TEST(Journal, AnOperatedRunIsMadeAgain) {
  const std::string text = operated_journal();
  PointsOfRun points;
  auto machine = made_again(text, points);
  ASSERT_TRUE(machine) << machine.error().message;
  EXPECT_EQ(journal_of(*machine), text);
  EXPECT_NE(text.find("before_block"), std::string::npos);
  EXPECT_NE(text.find("last_block"), std::string::npos);
  if (const char* const path = std::getenv("KERF_WRITE_JOURNAL")) std::ofstream(path) << text;
}

// FNV-1a of the bits of all joints.
std::uint64_t fingerprint(const PointsOfRun& points) {
  std::uint64_t hash = 14695981039346656037U;
  for (const motion::AxisPoint& point : points.all) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      hash = (hash ^ std::bit_cast<std::uint64_t>(point.joints.values[axis])) * 1099511628211U;
  }
  return hash;
}

TEST(Journal, ThatOfAFileIsMadeAgainToTheSamePoints) {
  std::ifstream file(KERF_JOURNALS "/operated.journal.json");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  PointsOfRun points;
  auto machine = made_again(text, points);
  ASSERT_TRUE(machine) << machine.error().message;
  EXPECT_EQ(journal_of(*machine), text);
  const auto end = machine->snapshot();
  EXPECT_EQ(end->status, Status::alarm);
  EXPECT_EQ(end->alarm->code, "PS0112");
  EXPECT_EQ(end->printed, "START\n");
  EXPECT_EQ(points.all.size(), 2046U);
  EXPECT_EQ(fingerprint(points), 5699341555863685081U);
}

}  // namespace
}  // namespace kerf::test
