#include "cli/dialect_choice.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include "machine/dialect.hpp"
#include "machine/language.hpp"

namespace kerf::cli {
namespace {

using base::Failure;
using base::Outcome;

<<<<<<< HEAD
// So much of a text is looked at.
constexpr std::size_t kLook = 4096;

// What the ending of a file or the first lines of a text tell, and where such programs run.
struct Language {
  std::string_view dialect;
  std::string_view ending;
  std::string_view machine;
};
constexpr std::array kLanguages = {Language{"laser-basic", ".bas", "laser3"},
                                   Language{"teach", ".tch", "laser5"}};
constexpr Language kPattern{kPatternDialect, ".pat", "arm4"};
constexpr Language kMill{"fanuc-mill", "", "mill3"};

// Words that begin a statement of laser BASIC and no block of G-code.
constexpr std::array<std::string_view, 14> kBasicWords = {"LET",  "REM",  "PRINT",  "INPUT", "FOR",
                                                          "NEXT", "HOME", "SPEED",  "POWER", "MOVE",
                                                          "LINE", "ARC",  "CIRCLE", "GOSUB"};
=======
// Where nothing else is asked for.
constexpr machine::Language kMill{"fanuc-mill", "", "mill3"};
>>>>>>> server

bool is_available(std::string_view dialect) {
  const std::vector<std::string_view> all = machine::available_dialects();
  return std::find(all.begin(), all.end(), dialect) != all.end();
}

<<<<<<< HEAD
std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::optional<Language> by_ending(const std::string& path) {
  const std::string ending = upper(std::filesystem::path(path).extension().string());
  for (const Language& language : {kLanguages[0], kLanguages[1], kPattern}) {
    if (ending == upper(std::string(language.ending))) return language;
  }
  return std::nullopt;
}

// The first word of a line in capitals, and the character behind it.
struct FirstWord {
  std::string word;
  char next = 0;
};

FirstWord first_word(std::string_view line) {
  FirstWord first;
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (line.starts_with(kByteOrderMark)) line.remove_prefix(kByteOrderMark.size());
  std::size_t at = line.find_first_not_of(" \t\r");
  if (at == std::string_view::npos) return first;
  const auto in_word = [&] {
    return at < line.size() &&
           (std::isalnum(static_cast<unsigned char>(line[at])) != 0 || line[at] == '_');
  };
  for (; in_word(); ++at) first.word += line[at];
  first.word = upper(first.word);
  at = line.find_first_not_of(" \t", at);
  if (at != std::string_view::npos) first.next = line[at];
  return first;
}

bool looks_like_basic(const FirstWord& first) {
  const bool name = !first.word.empty() && std::isalpha(static_cast<unsigned char>(first.word[0]));
  return name && (first.next == '=' || std::find(kBasicWords.begin(), kBasicWords.end(),
                                                 first.word) != kBasicWords.end());
}

// By the first line that only one language has.
std::optional<Language> by_text(const base::SourceFile& program) {
  std::string text(std::min<std::uint64_t>(kLook, program.size()), '\0');
  text.resize(program.read(0, text));
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    const FirstWord first = first_word(std::string_view(text).substr(begin, end - begin));
    if (first.word == "TEACH") return kLanguages[1];
    if (looks_like_basic(first)) return kLanguages[0];
    if (first.next == '%' || first.next == '(' || !first.word.empty()) return std::nullopt;
    begin = end + 1;
  }
  return std::nullopt;
}

// Of a dialect that is not available.
std::string why_not(const std::string& dialect) {
  if (dialect == kPatternDialect)
    return "pattern bytes are run by `kerf pattern replay` and `kerf run --dialect pattern`";
  const bool known = std::find(machine::kDialects.begin(), machine::kDialects.end(), dialect) !=
                     machine::kDialects.end();
  return known ? "the dialect " + dialect + " is not available yet"
               : "there is no dialect " + dialect;
}

=======
std::string list_of_available() {
  std::string text;
  for (const std::string_view name : machine::available_dialects())
    text += (text.empty() ? "; available: " : ", ") + std::string(name);
  return text;
}

>>>>>>> server
Outcome<DialectChoice> available(DialectChoice choice, Failure::Kind kind,
                                 const std::string& source) {
  if (is_available(choice.dialect)) return choice;
  return tl::unexpected(
      Failure{kind, source + ": " + why_not(choice.dialect) + "; available: " + dialect_list()});
}

std::string machine_of(const std::string& dialect) {
  return std::string(machine::language_of(dialect).value_or(kMill).machine);
}

}  // namespace

bool is_pattern(const std::string& dialect, const std::string& path) {
  if (!dialect.empty()) return dialect == kPatternDialect;
  const auto language = by_ending(path);
  return language && language->dialect == kPatternDialect;
}

std::string dialect_list() {
  std::string text;
  for (const std::string_view name : machine::available_dialects()) {
    if (!text.empty()) text += ", ";
    text += name;
  }
  return text;
}

std::string usual_machines() {
  std::string text(kMill.machine);
  for (const Language& language : kLanguages) {
    text += ", ";
    text += language.machine;
    text += " for ";
    text += language.dialect;
  }
  return text;
}

Outcome<DialectChoice> choose_dialect(const std::string& machine, const std::string& dialect,
                                      const base::SourceFile& program) {
  if (!dialect.empty()) {
    const std::string chosen = machine.empty() ? machine_of(dialect) : machine;
    const std::string why =
        machine.empty() ? "machine " + chosen + " because of --dialect " + dialect : "";
    return available({dialect, chosen, why}, Failure::Kind::usage, "--dialect " + dialect);
  }
  const auto ending = machine::language_by_ending(program.name());
  const auto language = ending ? ending : machine::language_by_text(program);
  if (language && is_available(language->dialect)) {
    const std::string chosen = machine.empty() ? std::string(language->machine) : machine;
    return DialectChoice{
        std::string(language->dialect), chosen,
        (machine.empty() ? "machine " + chosen + " and dialect " : std::string("dialect ")) +
            std::string(language->dialect) +
            (ending ? " because of the file's ending" : " because of the first lines")};
  }
  if (language && ending)
    return available({std::string(language->dialect), "", ""}, Failure::Kind::input,
                     program.name());
  if (machine.empty()) {
    return DialectChoice{std::string(kMill.dialect), std::string(kMill.machine),
                         "machine mill3 and dialect fanuc-mill because nothing else was asked for"};
  }
  auto definition = machine::find_machine(machine);
  if (!definition) return tl::unexpected(definition.error());
  return available({definition->dialect, machine, ""}, Failure::Kind::input, machine);
}

}  // namespace kerf::cli
