// Any bytes as motion records: reading and running them must end in a result or an alarm with a
// place, and what they make must be written and read again as the same bytes. The first byte
// chooses the length of the pages and the machine.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "base/output_file.hpp"
#include "base/source_file.hpp"
#include "machine/run/batch_run.hpp"
#include "output/records/motion_json.hpp"

namespace {

using namespace kerf;

constexpr std::uint64_t kMostMotions = 2000;
constexpr std::uint64_t kMostSteps = 20000;
constexpr double kMostSeconds = 0.5;  // a line of a kilometre has millions of set-points
constexpr const char* kWritten = "fuzz_motion.tmp";

void require(bool condition) {
  if (!condition) std::abort();
}

const machine::MachineDefinition& definition(std::uint8_t choice) {
  static const std::array machines = {
      *machine::find_machine("mill3"), *machine::find_machine("laser5"),
      *machine::find_machine("lathe3c"), *machine::find_machine("arm4")};
  return machines[choice >> 3U & 3U];
}

// The records of a run; `went_well`: it came to an end.
std::string made_of(const std::string& text, std::uint8_t choice, bool& went_well) {
  machine::Machine::Settings settings{.dialect = "motion"};
  settings.pages.lines_per_page = 1U << (choice & 7U);
  settings.pages.fresh_pages = 2;
  const machine::MachineDefinition& of = definition(choice);
  machine::BatchRun machine(of, control::Memory(of.parameters.n_offsets), settings);
  auto file = base::OutputFile::create(kWritten);
  require(file.has_value());
  machine.load(base::SourceFile::from_text("-", text));
  output::MotionJson records(of.axes, &machine.sources(), **file);
  machine.add_sink(records);
  static_cast<void>(machine.check());
  machine.control().set_single_block((choice & 32U) != 0);
  machine.run_to_end({kMostSeconds, kMostMotions, kMostSteps});
  if (machine.alarm()) {
    require(!machine.alarm()->number.empty() && machine.alarm()->place.line > 0);
    require(machine.alarm()->place.line_start <= text.size());
  }
  went_well = machine.status() == machine::RunStatus::end;
  require((*file)->commit().has_value());
  const auto written = base::SourceFile::open(kWritten);
  require(written.has_value());
  std::string bytes((*written)->size(), '\0');
  bytes.resize((*written)->read(0, bytes));
  std::remove(kWritten);
  return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data + 1), size - 1);
  bool went_well = false;
  const std::string first = made_of(text, data[0], went_well);
  if (!went_well) return 0;
  const std::string again = made_of(first, data[0], went_well);
  require(went_well && again == first);
  return 0;
}
