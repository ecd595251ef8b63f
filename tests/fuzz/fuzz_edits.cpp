// Any bytes as an edits file: reading it must end in edits or in a sentence with a place, and what
// is read, made on a small program, in a program that was verified or in a refusal. The first byte
// chooses the program.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "job/edit_run.hpp"
#include "job/edits_file.hpp"

namespace {

using namespace kerf;

void require(bool condition) {
  if (!condition) std::abort();
}

// Two pockets of two layers, one within the other, a profile, a ring of arcs, holes by a cycle.
constexpr std::string_view kMilled =
    "%\nO1000\nN10 G21 G90 G17\nN20 T1 M06\nN30 G00 X0. Y0. Z5. S3000 M03\nN40 X20. Y20.\n"
    "N50 G01 Z-2. F100\nN60 X40. F300\nN70 Y28.\nN80 X20.\nN90 Y20.\nN100 X15. Y15.\nN110 X45.\n"
    "N120 Y33.\nN130 X15.\nN140 Y15.\nN150 G00 Z5.\nN160 X20. Y20.\nN170 G01 Z-4. F100\n"
    "N180 X40. F300\nN190 Y28.\nN200 X20.\nN210 Y20.\nN220 X15. Y15.\nN230 X45.\nN240 Y33.\n"
    "N250 X15.\nN260 Y15.\nN270 G00 Z5.\nN280 X80. Y10.\nN290 G01 Z-6. F100\nN300 X110. F250\n"
    "N310 G03 X115. Y15. J5.\nN320 G01 Y35.\nN330 G03 X110. Y40. I-5.\nN340 G01 X80.\n"
    "N350 G03 X75. Y35. J-5.\nN360 G01 Y15.\nN370 G03 X80. Y10. I5.\nN380 G00 Z5.\n"
    "N390 M98 P20\nN400 T2 M06\nN410 G98 G83 X10. Y50. Z-12. R2. Q3. F80\nN420 X30.\nN430 G80\n"
    "N440 M30\nO0020\nG00 X65. Y60.\nG01 Z-3. F100\nG02 I-3. F250\nG00 Z5.\nM99\n%\n";

// A diameter in three passes with a shoulder, a groove, a bore.
constexpr std::string_view kTurned =
    "%\nO2000\nG99 G97 S1000 M03\nT0101\nG00 X52. Z0.\nG01 X-1. F0.2\nG00 Z2.\nX46.\nG01 Z-60.\n"
    "G00 X48. Z2.\nX42.\nG01 Z-60.\nG00 X44. Z2.\nX40.\nG01 Z-60.\nX50.\nT0303\nG00 X42. Z-30.\n"
    "G01 X34. F0.05\nG00 X42.\nT0505\nG00 X0. Z2.\nG01 Z-25. F0.1\nG00 Z2.\nG28 U0. W0.\nM30\n%\n";

job::StockJob job_of(bool turns) {
  static const machine::MachineDefinition mill = *machine::find_machine("mill3");
  static const machine::MachineDefinition lathe = *machine::find_machine("lathe2");
  const machine::MachineDefinition& machine = turns ? lathe : mill;
  job::StockJob job{
      .job = {.definition = machine, .memory = control::Memory(machine.parameters.n_offsets)}};
  job.job.program = base::ProgramText::of("-", std::string(turns ? kTurned : kMilled));
  job.job.budget = {.seconds = 5, .motions = 20000, .steps = 200000};
  job.knows_stock = false;
  return job;
}

void check(const job::EditRun& ran, std::size_t edits) {
  require(ran.status == machine::RunStatus::end);
  if (!ran.edited) {
    require(!ran.edited.error().sentence.empty() && ran.edited.error().edit <= edits);
    return;
  }
  const job::EditReport& report = ran.edited->report;
  require(report.edits == edits && report.verified.recognised && report.verified.others_unchanged);
  for (const job::EditedText& text : ran.edited->texts) require(!text.after.empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const bool turns = (data[0] & 1U) != 0;
  const std::string text(reinterpret_cast<const char*>(data + 1), size - 1);
  const auto edits = job::read_edits(text, turns);
  if (!edits) {
    require(!edits.error().sentence.empty() && edits.error().line > 0 && edits.error().column > 0);
    return 0;
  }
  if (edits->size() > 8) return 0;
  const job::EditWishes wishes{*edits, (data[0] & 2U) != 0, (data[0] & 4U) != 0};
  const auto ran = job::edit_features(job_of(turns), wishes);
  require(ran.has_value());
  check(*ran, edits->size());
  return 0;
}
