#include "machine/dialect/program_look.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>

#include "base/decimal.hpp"
#include "base/text_window.hpp"
#include "machine/definition/pattern_machine.hpp"
#include "machine/dialect/language.hpp"

namespace kerf::machine {
namespace {

// So much of a program is looked at.
constexpr std::size_t kLook = 65'536;

struct Word {
  char letter = 0;
  double value = 0;
  std::string_view text;
};

// The words of one line of G-code, comments left out; of what is no word, nothing.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(base::without_byte_order_mark(line)) {}

  std::optional<Word> next() {
    while (!rest_.empty()) {
      const char c = rest_.front();
      if (c == ';') return std::nullopt;
      if (c == '(') {
        rest_.remove_prefix(std::min(rest_.find(')'), rest_.size() - 1) + 1);
      } else if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
        return word();
      } else {
        rest_.remove_prefix(1);
      }
    }
    return std::nullopt;
  }

 private:
  Word word() {
    const std::size_t sign = rest_.substr(1).find_first_not_of("+-") == 1 ? 1 : 0;
    const std::size_t end =
        std::min(rest_.find_first_not_of("0123456789.", 1 + sign), rest_.size());
    Word word;
    word.letter = static_cast<char>(std::toupper(static_cast<unsigned char>(rest_[0])));
    word.text = rest_.substr(0, end);
    word.value = base::read_number(word.text.substr(1)).value_or(0);
    rest_.remove_prefix(end);
    return word;
  }

  std::string_view rest_;
};

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
      if (word->letter == 'G' && (word->value == 71 || word->value == 72))
        turning_cycle = word->text;
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
      case 'G':
        if (word.value == 96 || word.value == 97) turning_.see(line, word.text);
        if (word.value == 43 || (word.value >= 81 && word.value <= 89))
          milling_.see(line, word.text);
        break;
      case 'M':
        if (word.value == 6) tool_change_.see(line, word.text);
        if (word.value == 4 && word.text.size() > 1) beam_.see(line, word.text);
        break;
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
  if (ends_as_pattern(program.name())) return {ProgramKind::pattern, 0, {}};
  auto language = language_by_ending(program.name());
  if (!language) language = language_by_text(program);
  if (!language) return look_of_gcode(program);
  return {language->dialect == "teach" ? ProgramKind::teach : ProgramKind::laser_basic, 0, {}};
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
    case ProgramKind::mill: return "mill3";
    case ProgramKind::laser: return "laser3";
    case ProgramKind::laser_basic: return language_of("laser-basic")->machine;
    case ProgramKind::teach: return language_of("teach")->machine;
    case ProgramKind::pattern: return language_of(kPatternDialect)->machine;
    case ProgramKind::lathe: break;
  }
  return {};
}

}  // namespace kerf::machine
