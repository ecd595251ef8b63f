#include "machine/dialect/program_look.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "base/decimal.hpp"
#include "base/text_window.hpp"
#include "control/gcode/codes/code_table.hpp"
#include "lang/gcode/language.hpp"
#include "lang/gcode/lexer.hpp"
#include "machine/definition/pattern_machine.hpp"
#include "machine/dialect/registry.hpp"

namespace kerf::machine {
namespace {

using base::TokenKind;
using control::Function;
using control::Meaning;

// So much of a program is looked at.
constexpr std::size_t kLook = 65'536;

struct Word {
  char letter = 0;
  double value = 0;
  std::string_view text;
};

// The words of one line of G-code up to a semicolon, behind which others write comments.
class Words {
 public:
  explicit Words(std::string_view line)
      : line_(base::without_byte_order_mark(line)),
        tokens_(base::tokens_of(gcode::language(), line_)) {}

  std::optional<Word> next() {
    while (at_ < tokens_.size()) {
      const base::Token& token = tokens_[at_++];
      const std::string_view text = line_.substr(token.begin, token.length);
      if (text == ";") return std::nullopt;
      if (is_address(token.kind) && gcode::is_letter(gcode::Cursor::fold(text[0])))
        return word(text);
    }
    return std::nullopt;
  }

 private:
  static bool is_address(TokenKind kind) {
    return kind == TokenKind::command || kind == TokenKind::switching ||
           kind == TokenKind::dimension || kind == TokenKind::technology;
  }

  static Word word(std::string_view text) {
    return {gcode::Cursor::fold(text[0]), base::read_number(text.substr(1)).value_or(0), text};
  }

  std::string_view line_;
  std::vector<base::Token> tokens_;
  std::size_t at_ = 0;
};

// Nothing: it is no number of a code.
std::optional<std::int64_t> code_number(double value) {
  constexpr double kMost = 100'000;
  if (!(value >= 0 && value < kMost && value == std::floor(value))) return std::nullopt;
  return static_cast<std::int64_t>(value);
}

// What a G code means on a mill, none where it has no such code.
Meaning meaning_of(const Word& word) {
  const auto number = code_number(word.value * 10);
  if (!number || *number > std::numeric_limits<control::GCode>::max()) return Meaning::none;
  const auto* const row = control::mill_codes().find(static_cast<control::GCode>(*number));
  return row == nullptr ? Meaning::none : row->meaning;
}

Function function_of(const Word& word) {
  const auto number = code_number(word.value);
  const auto* const row = number ? control::mill_codes().find_function(*number) : nullptr;
  return row == nullptr ? Function::passed_on : row->function;
}

// Roughing of a lathe, for which there is no table.
bool is_turning_cycle(const Word& word) {
  return word.letter == 'G' && (word.value == 71 || word.value == 72);
}

// Where a sign was seen first.
struct Sign {
  std::uint32_t line = 0;
  std::string word;

  void see(std::uint32_t at, std::string_view text) {
    if (line == 0) *this = {at, std::string(text)};
  }
  [[nodiscard]] bool seen() const { return line > 0; }
};

// The signs of a program in G-code.
class Signs {
 public:
  void read(std::uint32_t number, std::string_view line) {
    Words words(line);
    std::string_view power;
    std::string_view turning_cycle;
    bool moves = false;
    bool has_q = false;
    while (const auto word = words.next()) {
      has_q |= word->letter == 'Q';
      if (word->letter == 'S' && word->text.size() > 1) power = word->text;
      if (is_turning_cycle(*word)) turning_cycle = word->text;
      moves |= std::string_view("XYZ").find(word->letter) != std::string::npos;
      see(number, *word);
    }
    if (moves && !power.empty()) ++powered_moves_, power_.see(number, power);
    if (has_q && !turning_cycle.empty()) turning_.see(number, turning_cycle);
  }

  // A lathe has no Y, but a mill may have T101 and G97, and a lathe T01M06; a beam has neither
  // tools nor cutting depths.
  [[nodiscard]] ProgramLook look() const {
    const bool turns = turning_.seen() && x_ && z_ && !y_;
    if (turns && !milling_.seen()) return told(ProgramKind::lathe, turning_);
    if (milling_.seen()) return told(ProgramKind::mill, milling_);
    if (tool_change_.seen() && y_) return told(ProgramKind::mill, tool_change_);
    const bool beams = beam_.seen() || powered_moves_ >= 2;
    if (beams && !turning_.seen() && !tool_ && !goes_below_)
      return told(ProgramKind::laser, beam_.seen() ? beam_ : power_);
    return {};
  }

 private:
  static ProgramLook told(ProgramKind kind, const Sign& sign) {
    return {kind, sign.line, sign.word};
  }

  void see(std::uint32_t line, const Word& word) {
    switch (word.letter) {
      case 'X': x_ = true; break;
      case 'Y': y_ = true; break;
      case 'Z':
        z_ = true;
        goes_below_ |= word.value < 0;
        break;
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

  Sign milling_, tool_change_, turning_, beam_, power_;
  std::size_t powered_moves_ = 0;
  bool x_ = false, y_ = false, z_ = false, tool_ = false, goes_below_ = false;
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
    case DialectRow::Kind::pattern: return ProgramKind::pattern;
  }
  return ProgramKind::any;
}

bool has_axes(const MachineDefinition& machine, std::string_view letters) {
  return std::all_of(letters.begin(), letters.end(),
                     [&](char letter) { return machine.axes.find(letter).has_value(); });
}

}  // namespace

std::string_view name_of(ProgramKind kind) {
  constexpr std::array<std::string_view, 7> kNames = {"any",         "mill",  "lathe",  "laser",
                                                      "laser-basic", "teach", "pattern"};
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
    case ProgramKind::any: return true;
    case ProgramKind::mill: return !beams && !is_arm && has_axes(machine, "XYZ");
    case ProgramKind::laser: return beams;
    case ProgramKind::laser_basic: return beams && has_axes(machine, "XY");
    case ProgramKind::teach: return beams && has_axes(machine, "XYZAC");
    case ProgramKind::pattern: return PatternMachine::of(machine).has_value();
    case ProgramKind::lathe: break;
  }
  return false;
}

std::string_view usual_machine(ProgramKind kind) {
  switch (kind) {
    case ProgramKind::any:
    case ProgramKind::mill: return usual_dialect().machine;
    case ProgramKind::laser: return "laser3";
    case ProgramKind::laser_basic:
    case ProgramKind::teach:
    case ProgramKind::pattern: return find_dialect(name_of(kind))->machine;
    case ProgramKind::lathe: break;
  }
  return {};
}

}  // namespace kerf::machine
