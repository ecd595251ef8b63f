#include "machine/dialect/program_look.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include "control/gcode/codes/code_table.hpp"
#include "machine/definition/pattern_machine.hpp"
#include "machine/dialect/internal/lathe_signs.hpp"
#include "machine/dialect/internal/line_words.hpp"
#include "machine/dialect/registry.hpp"

namespace kerf::machine {
namespace {

using control::Function;
using control::Meaning;
using Word = LookedAtWord;

// So much of a program is looked at.
constexpr std::size_t kLook = 65'536;

// What a G code means on a mill, none where it has no such code.
Meaning meaning_of(const Word& word) {
  const auto number = code_number(word.value, 10);
  if (!number || *number > std::numeric_limits<control::GCode>::max()) return Meaning::none;
  const auto* const row = control::mill_codes().find(static_cast<control::GCode>(*number));
  return row == nullptr ? Meaning::none : row->meaning;
}

Function function_of(const Word& word) {
  const auto number = code_number(word.value);
  const auto* const row = number ? control::mill_codes().find_function(*number) : nullptr;
  return row == nullptr ? Function::passed_on : row->function;
}

// Roughing of a lathe; null: there is none.
const Word* turning_cycle_of(const LineWords& line) {
  const Word* const along_z = line.find_code(710);
  return along_z != nullptr ? along_z : line.find_code(720);
}

// The signs of a program in G-code.
class Signs {
 public:
  void read(std::uint32_t number, std::string_view text) {
    const LineWords line(text);
    for (const Word& word : line.all()) see(number, word);
    see_power(number, line);
    const Word* const cycle = turning_cycle_of(line);
    if (cycle != nullptr && line.has('Q')) turning_.see(number, cycle->text);
    lathe_.read(number, line);
  }

  // A beam has neither tools nor cutting depths.
  [[nodiscard]] ProgramLook look() const {
    if (lathe_.is_lathe()) return look_of_lathe();
    if (milling_.seen()) return told(ProgramKind::mill, milling_);
    if (tool_change_.seen() && y_) return told(ProgramKind::mill, tool_change_);
    const bool beams = beam_.seen() || powered_moves_ >= 2;
    if (beams && !turning_.seen() && !tool_ && !goes_below_)
      return told(ProgramKind::laser, beam_.seen() ? beam_ : power_);
    return {};
  }

 private:
  static ProgramLook told(ProgramKind kind, const SeenSign& sign) {
    return {kind, sign.line, sign.word};
  }

  [[nodiscard]] ProgramLook look_of_lathe() const {
    if (lathe_.c_axis().seen()) return told(ProgramKind::lathe_c, lathe_.c_axis());
    return told(ProgramKind::lathe, lathe_.strongest());
  }

  void see_power(std::uint32_t number, const LineWords& line) {
    const Word* const power = line.find('S');
    if (power == nullptr || power->text.size() < 2 || !line.has_any("XYZ")) return;
    ++powered_moves_;
    power_.see(number, power->text);
  }

  void see(std::uint32_t line, const Word& word) {
    switch (word.letter) {
      case 'Y': y_ = true; break;
      case 'Z': goes_below_ |= word.value < 0; break;
      case 'T':
        tool_ = true;
        if (word.value >= 100 && word.text.size() >= 4) turning_.see(line, word.text);
        break;
      case 'G': see_code(line, word); break;
      case 'M':
        if (function_of(word) == Function::tool_change) tool_change_.see(line, word.text);
        if (function_of(word) == Function::spindle_counterclockwise) beam_.see(line, word.text);
        break;
      default: break;
    }
  }

  void see_code(std::uint32_t line, const Word& word) {
    switch (meaning_of(word)) {
      case Meaning::surface_speed:
      case Meaning::constant_rpm: turning_.see(line, word.text); break;
      case Meaning::length_plus:
      case Meaning::drill:
      case Meaning::counterbore:
      case Meaning::peck:
      case Meaning::tap_right:
      case Meaning::bore:
      case Meaning::bore_spindle_stop:
      case Meaning::back_bore:
      case Meaning::bore_by_hand:
      case Meaning::bore_dwell: milling_.see(line, word.text); break;
      default: break;
    }
  }

  SeenSign milling_, tool_change_, turning_, beam_, power_;
  LatheSigns lathe_;
  std::size_t powered_moves_ = 0;
  bool y_ = false, tool_ = false, goes_below_ = false;
};

ProgramLook look_of_gcode(const base::SourceFile& program) {
  std::string text(std::min<std::uint64_t>(kLook, program.size()), '\0');
  text.resize(program.read(0, text));
  Signs signs;
  std::uint32_t number = 1;
  for (std::size_t begin = 0; begin < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    signs.read(number, std::string_view(text).substr(begin, end - begin));
    begin = end + 1;
  }
  return signs.look();
}

ProgramKind kind_of(DialectRow::Kind dialect) {
  switch (dialect) {
    case DialectRow::Kind::gcode: break;
    case DialectRow::Kind::basic: return ProgramKind::laser_basic;
    case DialectRow::Kind::teach: return ProgramKind::teach;
    case DialectRow::Kind::motion: return ProgramKind::motion;
    case DialectRow::Kind::pattern: return ProgramKind::pattern;
  }
  return ProgramKind::any;
}

bool has_axes(const MachineDefinition& machine, std::string_view letters) {
  return std::all_of(letters.begin(), letters.end(),
                     [&](char letter) { return machine.axes.find(letter).has_value(); });
}

bool turns(const MachineDefinition& machine) { return machine.dialect == kLatheDialect; }

}  // namespace

std::string_view name_of(ProgramKind kind) {
  constexpr std::array<std::string_view, 9> kNames = {
      "any", "mill", "lathe", "lathe-c", "laser", "laser-basic", "teach", "motion", "pattern"};
  return kNames[static_cast<std::size_t>(kind)];
}

ProgramLook look_of(const base::SourceFile& program) {
  const DialectRow* row = dialect_by_ending(program.name());
  if (row == nullptr) row = dialect_by_text(program);
  if (row == nullptr) return look_of_gcode(program);
  return {kind_of(row->kind), 0, {}};
}

bool suits(const MachineDefinition& machine, ProgramKind kind) {
  const bool is_arm = machine.linkage == "arm";
  const bool beams = machine.drive.laser.fitted();
  switch (kind) {
    case ProgramKind::any:
    case ProgramKind::motion: return true;
    case ProgramKind::mill: return !beams && !is_arm && !turns(machine) && has_axes(machine, "XYZ");
    case ProgramKind::lathe: return turns(machine);
    case ProgramKind::lathe_c: return turns(machine) && has_axes(machine, "C");
    case ProgramKind::laser: return beams;
    case ProgramKind::laser_basic: return beams && has_axes(machine, "XY");
    case ProgramKind::teach: return beams && has_axes(machine, "XYZAC");
    case ProgramKind::pattern: return PatternMachine::of(machine).has_value();
  }
  return false;
}

std::string_view usual_machine(ProgramKind kind) {
  switch (kind) {
    case ProgramKind::any:
    case ProgramKind::mill: return usual_dialect().machine;
    case ProgramKind::lathe: return find_dialect(kLatheDialect)->machine;
    case ProgramKind::lathe_c: return "lathe3c";
    case ProgramKind::laser: return "laser3";
    case ProgramKind::laser_basic:
    case ProgramKind::teach:
    case ProgramKind::motion:
    case ProgramKind::pattern: return find_dialect(name_of(kind))->machine;
  }
  return {};
}

}  // namespace kerf::machine
