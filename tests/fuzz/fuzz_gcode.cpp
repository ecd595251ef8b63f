// Any bytes as a program: reading them must end in a result or an alarm with a place, never in a
// crash, a hang or unbounded memory. The first byte chooses the length of the pages, the machine
// and the panel's switches, so that loops and jumps cross pages of one line as well as of many. For
// a lathe the second one chooses which and its parameters.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "machine/run/batch_run.hpp"

namespace {

using namespace kerf;

constexpr std::uint64_t kMostMotions = 2000;
constexpr std::uint64_t kMostSteps = 20000;

void require(bool condition) {
  if (!condition) std::abort();
}

void check_alarm(const base::Diagnostic& alarm, std::size_t size) {
  require(!alarm.number.empty() && !alarm.message.empty());
  require(alarm.place.line_start <= size);
}

// With the parameters that change what a block means.
machine::MachineDefinition lathe(unsigned choice) {
  machine::MachineDefinition definition =
      *machine::find_machine((choice & 1U) != 0 ? "lathe3c" : "lathe2");
  control::Parameters& parameters = definition.parameters;
  parameters.check_shapes = (choice & 2U) != 0;
  parameters.compensated_cycles = (choice & 4U) != 0;
  parameters.bare_corners = (choice & 8U) != 0;
  parameters.g_system = (choice & 16U) == 0 ? 'A' : (choice & 32U) == 0 ? 'B' : 'C';
  return definition;
}

std::array<machine::MachineDefinition, 64> all_lathes() {
  std::array<machine::MachineDefinition, 64> all;
  for (unsigned choice = 0; choice < all.size(); ++choice) all[choice] = lathe(choice);
  return all;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::uint8_t choice = data[0];
  const bool turns = (choice & 128U) != 0 && size > 1;
  // Made once: reading a machine takes longer than most programs.
  static const std::array<machine::MachineDefinition, 64> lathes = all_lathes();
  static const machine::MachineDefinition laser = *machine::find_machine("laser3");
  const machine::MachineDefinition& definition = turns ? lathes[data[1] % lathes.size()] : laser;
  const std::size_t begin = turns ? 2 : 1;
  machine::Machine::Settings settings;
  settings.pages.lines_per_page = 1U << (choice & 7U);
  settings.pages.fresh_pages = 2;
  settings.pages.most_pages = 64;
  machine::BatchRun machine(definition, control::Memory(definition.parameters.n_offsets), settings);
  machine.load(base::SourceFile::from_text(
      "-", {reinterpret_cast<const char*>(data + begin), size - begin}));
  machine.control().set_block_skip((choice & 8U) != 0 ? 0x3feU : 0);
  machine.control().set_optional_stop((choice & 16U) != 0);
  machine.control().set_single_block((choice & 32U) != 0);
  const machine::Budget budget{0, kMostMotions, kMostSteps};
  machine.run_to_end(budget);
  if (machine.alarm()) check_alarm(*machine.alarm(), size);
  if ((choice & 64U) != 0) {
    machine.reset();
    machine.run_to_end(budget);
  }
  return 0;
}
