// Random programs without an end, each run on a machine of its own and cancelled after some
// milliseconds: it must come to an end within a second of computing, whatever it is doing.
#include <pthread.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <thread>

#include "endless_program.hpp"
#include "machine/dialect/registry.hpp"
#include "machine/run/batch_run.hpp"
#include "motion/axis_point.hpp"

namespace kerf::test {
namespace {

using machine::BatchRun;

// Of computing, not of the clock on the wall: other processes do not count.
constexpr double kMost_s = 1;

double seconds_of(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

struct NoSink : motion::AxisPointSink {
  void start(const motion::AxisPoint& /*at*/) override {}
  void take(const motion::AxisPoint& /*point*/) override {}
};

// How a run is begun and looked at.
struct Manner {
  bool with_points = false;
  bool single_block = false;
  int cancel_after_ms = 0;
};

struct Result {
  machine::RunStatus status{};
  double late_s = 0;  // of computing, behind the cancellation
};

Result run_cancelled(const EndlessProgram& program, const Manner& manner) {
  const auto definition = machine::find_machine(program.machine);
  const auto* const shown = machine::dialect_by_ending(program.name);
  const std::string dialect(shown != nullptr ? shown->name : machine::usual_dialect().name);
  NoSink sink;
  BatchRun machine(*definition, control::Memory(definition->parameters.n_offsets),
                   {.dialect = dialect});
  machine.set_input([] { return std::optional<std::string>("1"); });
  machine.control().set_single_block(manner.single_block);
  if (manner.with_points) machine.add_point_sink(sink);
  machine.load(base::SourceFile::from_text(program.name, program.text));
  std::stop_source unwanted;
  Result result;
  double end_s = 0;
  std::thread run([&] {
    result.status =
        machine.run_to_end({.seconds = 600, .motions = 0, .unwanted = unwanted.get_token()});
    end_s = seconds_of(CLOCK_THREAD_CPUTIME_ID);
  });
  clockid_t clock{};
  pthread_getcpuclockid(run.native_handle(), &clock);
  std::this_thread::sleep_for(std::chrono::milliseconds(manner.cancel_after_ms));
  const double cancelled_s = seconds_of(clock);
  unwanted.request_stop();
  run.join();
  result.late_s = end_s - cancelled_s;
  return result;
}

}  // namespace
}  // namespace kerf::test

int main(int count, char** words) {
  using namespace kerf::test;
  unsigned long programs = 1000;
  unsigned seed = kSeed;
  for (int i = 1; i + 1 < count; ++i) {
    if (std::strcmp(words[i], "--programs") == 0)
      programs = std::strtoul(words[i + 1], nullptr, 10);
    if (std::strcmp(words[i], "--seed") == 0)
      seed = static_cast<unsigned>(std::strtoul(words[i + 1], nullptr, 10));
  }
  int failures = 0;
  unsigned long by_themselves = 0;
  double latest_s = 0;
  for (unsigned long i = 0; i < programs && failures < 5; ++i) {
    SeededRandom random(seed + static_cast<unsigned>(i));
    const EndlessProgram program = endless_program(random);
    const Manner manner{random.coin(), random.count(0, 3) == 0, random.count(0, 20)};
    const Result result = run_cancelled(program, manner);
    if (result.status != kerf::machine::RunStatus::budget) ++by_themselves;
    latest_s = std::max(latest_s, result.late_s);
    if (result.late_s <= kMost_s) continue;
    std::printf("seed %lu computes for %.2f s behind its cancellation:\n%s\n", seed + i,
                result.late_s, program.text.substr(0, 2000).c_str());
    ++failures;
  }
  // Most of them are to be cancelled, or this shows nothing.
  if (by_themselves > programs / 3) {
    std::printf("%lu of %lu programs ended by themselves\n", by_themselves, programs);
    ++failures;
  }
  std::printf(
      "%lu programs from seed %u, %lu ended by themselves, the latest %.3f s late: %d failures\n",
      programs, seed, by_themselves, latest_s, failures);
  return failures == 0 ? 0 : 1;
}
