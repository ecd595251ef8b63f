#include "face/cli/dialect_choice.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include "machine/dialect/dialect.hpp"
#include "machine/dialect/language.hpp"

namespace kerf::cli {
namespace {

using base::Failure;
using base::Outcome;

// Where nothing else is asked for.
constexpr machine::Language kMill{"fanuc-mill", "", "mill3"};

// Those of texts: a replay runs the bytes of a pattern.
std::vector<std::string_view> text_dialects() {
  std::vector<std::string_view> all = machine::available_dialects();
  std::erase(all, kPatternDialect);
  return all;
}

bool is_available(std::string_view dialect) {
  const std::vector<std::string_view> all = text_dialects();
  return std::find(all.begin(), all.end(), dialect) != all.end();
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
  return machine::ends_as_pattern(path);
}

std::string dialect_list() {
  std::string text;
  for (const std::string_view name : text_dialects()) {
    if (!text.empty()) text += ", ";
    text += name;
  }
  return text;
}

std::string usual_machines() {
  std::string text(kMill.machine);
  for (const machine::Language& language : machine::languages()) {
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
  if (machine::ends_as_pattern(program.name()))
    return available({kPatternDialect, "", ""}, Failure::Kind::input, program.name());
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
