#include "face/cli/dialect_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "machine/definition/machine_definition.hpp"

namespace kerf::cli {
namespace {

using base::Failure;
using base::Outcome;

bool is_available(std::string_view dialect) {
  const std::vector<std::string_view> all = machine::text_dialects();
  return std::find(all.begin(), all.end(), dialect) != all.end();
}

// Of a dialect that is not available.
std::string why_not(const std::string& dialect) {
  if (dialect == kPatternDialect)
    return "pattern bytes are run by `kerf pattern replay` and `kerf run --dialect pattern`";
  return "there is no dialect " + dialect;
}

Outcome<DialectChoice> available(DialectChoice choice, Failure::Kind kind,
                                 const std::string& source) {
  if (is_available(choice.dialect)) return choice;
  return tl::unexpected(
      Failure{kind, source + ": " + why_not(choice.dialect) + "; available: " + dialect_list()});
}

std::string machine_of(const std::string& dialect) {
  const machine::DialectRow* const row = machine::find_dialect(dialect);
  return std::string(row != nullptr ? row->machine : machine::usual_dialect().machine);
}

}  // namespace

bool is_pattern(const std::string& dialect, const std::string& path) {
  if (!dialect.empty()) return dialect == kPatternDialect;
  return machine::ends_as_pattern(path);
}

std::string dialect_list() {
  std::string text;
  for (const std::string_view name : machine::text_dialects()) {
    if (!text.empty()) text += ", ";
    text += name;
  }
  return text;
}

std::string usual_machines() {
  std::string text(machine::usual_dialect().machine);
  for (const machine::DialectRow& row : machine::dialects().subspan(1)) {
    if (row.language->is_listing) continue;
    text += ", ";
    text += row.machine;
    text += " for ";
    text += row.name;
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
  const machine::DialectRow* const ending = machine::dialect_by_ending(program.name());
  const machine::DialectRow* const row =
      ending != nullptr ? ending : machine::dialect_by_text(program);
  if (row != nullptr) {
    const std::string chosen(machine.empty() ? row->machine : machine);
    return DialectChoice{
        std::string(row->name), chosen,
        (machine.empty() ? "machine " + chosen + " and dialect " : "dialect ") +
            std::string(row->name) +
            (ending != nullptr ? " because of the file's ending" : " because of the first lines")};
  }
  if (machine.empty()) {
    const machine::DialectRow& usual = machine::usual_dialect();
    return DialectChoice{std::string(usual.name), std::string(usual.machine),
                         fmt::format("machine {} and dialect {} because nothing else was asked for",
                                     usual.machine, usual.name)};
  }
  auto definition = machine::find_machine(machine);
  if (!definition) return tl::unexpected(definition.error());
  return available({definition->dialect, machine, ""}, Failure::Kind::input, machine);
}

}  // namespace kerf::cli
