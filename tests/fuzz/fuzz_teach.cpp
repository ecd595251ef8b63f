// Any bytes as taught points: reading and running them must end in a result or an alarm with a
// place, and what is read must be written and read again as the same records. The first byte
// chooses the length of the pages and the machine.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "lang/teach/record_reader.hpp"
#include "lang/teach/record_writer.hpp"
#include "machine/run/batch_run.hpp"

namespace {

using namespace kerf;

constexpr std::uint64_t kMostMotions = 2000;
constexpr std::uint64_t kMostSteps = 20000;
constexpr double kMostSeconds = 0.5;  // a line of a kilometre has millions of set-points

void require(bool condition) {
  if (!condition) std::abort();
}

struct Text {
  std::vector<teach::Record> records;
  std::string rewritten;
  std::size_t mistakes = 0;
};

Text read(const std::string& text) {
  const auto file = base::SourceFile::from_text("-", text);
  teach::RecordReader reader;
  reader.stand_at(*file, base::FileId{0}, {});
  Text result;
  for (teach::RecordReader::Line line; reader.next(line);) {
    const std::string_view comment = line.words.comment();
    teach::append_line(result.rewritten, line.record ? &*line.record : nullptr,
                       line.words.has_comment() ? &comment : nullptr);
    if (line.record) result.records.push_back(*line.record);
    if (!line.mistake) continue;
    ++result.mistakes;
    const base::Diagnostic told = reader.diagnostic(line);
    require(told.place.line > 0 && told.place.column > 0 && told.place.line_start <= text.size());
  }
  return result;
}

// Without its mistakes a file may be another one, so only whole files are compared.
void check_writer(const std::string& text) {
  const Text first = read(text);
  if (first.mistakes > 0) return;
  const Text again = read(first.rewritten);
  require(again.mistakes == 0 && again.records == first.records);
  require(again.rewritten == first.rewritten);
}

void check_run(const std::string& text, std::uint8_t choice) {
  static const auto head = *machine::find_machine("laser5");
  static const auto mill = *machine::find_machine("mill5");
  machine::Machine::Settings settings{.dialect = "teach"};
  settings.pages.lines_per_page = 1U << (choice & 7U);
  settings.pages.fresh_pages = 2;
  const machine::MachineDefinition& definition = (choice & 8U) != 0 ? mill : head;
  machine::BatchRun machine(definition, control::Memory(definition.parameters.n_offsets), settings);
  machine.load(base::SourceFile::from_text("-", text));
  static_cast<void>(machine.check());
  machine.control().set_single_block((choice & 16U) != 0);
  const machine::Budget budget{kMostSeconds, kMostMotions, kMostSteps};
  machine.run_to_end(budget);
  if (machine.alarm()) {
    require(!machine.alarm()->number.empty() && machine.alarm()->place.line > 0);
    require(machine.alarm()->place.line_start <= text.size());
  }
  if ((choice & 32U) == 0) return;
  machine.reset();
  machine.run_to_end(budget);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data + 1), size - 1);
  check_writer(text);
  check_run(text, data[0]);
  return 0;
}
