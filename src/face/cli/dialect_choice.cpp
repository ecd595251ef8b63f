#include "face/cli/dialect_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "machine/definition/machine_definition.hpp"
#include "machine/dialect/motion_look.hpp"
#include "machine/dialect/program_look.hpp"
#include "output/writing/diagnostic_text.hpp"

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

std::string machine_of(const std::string& dialect, const base::SourceFile& program) {
  const machine::DialectRow* const row = machine::find_dialect(dialect);
  return std::string(
      machine::machine_for(row != nullptr ? *row : machine::usual_dialect(), program));
}

constexpr const char* kNamed = "named";

machine::ProgramLook look_at(const base::SourceFile& program) {
  machine::ProgramLook look = machine::look_of(program);
  look.word = output::printable(look.word);
  return look;
}

// Of a program for a lathe, without a machine that was named.
std::vector<control::Assumption> assumed_by(const machine::ProgramLook& look, bool by_dialect) {
  std::vector<control::Assumption> list;
  if (!by_dialect)
    list.push_back(
        {look.line, fmt::format("dialect {} (likely): {}", machine::kLatheDialect, look.word)});
  if (look.kind == machine::ProgramKind::lathe_c)
    list.push_back({look.line, fmt::format("machine {}: the program turns C or drives tools ({})",
                                           machine::usual_machine(look.kind), look.word)});
  return list;
}

// `--dialect` without `--machine`.
DialectChoice with_machine_for(const std::string& dialect, const base::SourceFile& program) {
  const machine::ProgramLook look = look_at(program);
  const bool turns_c =
      dialect == machine::kLatheDialect && look.kind == machine::ProgramKind::lathe_c;
  const std::string chosen(turns_c ? std::string(machine::usual_machine(look.kind))
                                   : machine_of(dialect, program));
  const std::string because =
      turns_c ? fmt::format(" and of {} in line {}", look.word, look.line) : "";
  return {dialect,
          chosen,
          "machine " + chosen + " because of --dialect " + dialect + because,
          {kNamed, turns_c ? "axes" : "dialect"},
          turns_c ? assumed_by(look, true) : std::vector<control::Assumption>()};
}

Outcome<DialectChoice> asked_for(const std::string& dialect, const std::string& machine,
                                 const base::SourceFile& program) {
  const DialectChoice choice = machine.empty()
                                   ? with_machine_for(dialect, program)
                                   : DialectChoice{dialect, machine, "", {kNamed, kNamed}, {}};
  return available(choice, Failure::Kind::usage, "--dialect " + dialect);
}

// By the ending of the file or its first lines; nothing: neither shows it.
std::optional<DialectChoice> shown_by(const base::SourceFile& program, const std::string& machine) {
  const machine::DialectRow* const ending = machine::dialect_by_ending(program.name());
  const machine::DialectRow* const row =
      ending != nullptr ? ending : machine::dialect_by_text(program);
  if (row == nullptr) return std::nullopt;
  const std::string chosen(machine.empty() ? machine::machine_for(*row, program) : machine);
  const char* const because =
      ending != nullptr ? " because of the file's ending" : " because of the first lines";
  return DialectChoice{std::string(row->name),
                       chosen,
                       (machine.empty() ? "machine " + chosen + " and dialect " : "dialect ") +
                           std::string(row->name) + because,
                       {"certain", machine.empty() ? "dialect" : kNamed},
                       {}};
}

// Nothing was named and nothing is certain.
DialectChoice by_words(const base::SourceFile& program) {
  const machine::ProgramLook look = look_at(program);
  const machine::DialectRow& usual = machine::usual_dialect();
  if (!machine::is_lathes(look.kind))
    return {std::string(usual.name),
            std::string(usual.machine),
            fmt::format("machine {} and dialect {} because nothing else was asked for",
                        usual.machine, usual.name),
            {"default", "default"},
            {}};
  const std::string chosen(machine::usual_machine(look.kind));
  const bool turns_c = look.kind == machine::ProgramKind::lathe_c;
  return {std::string(machine::kLatheDialect),
          chosen,
          fmt::format("machine {} and dialect {} because of {} in line {}", chosen,
                      machine::kLatheDialect, look.word, look.line),
          {"likely", turns_c ? "axes" : "dialect"},
          assumed_by(look, false)};
}

Outcome<DialectChoice> of_machine(const std::string& machine) {
  auto definition = machine::find_machine(machine);
  if (!definition) return tl::unexpected(definition.error());
  return available({definition->dialect, machine, "", {kNamed, kNamed}, {}}, Failure::Kind::input,
                   machine);
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
  if (!dialect.empty()) return asked_for(dialect, machine, program);
  if (machine::ends_as_pattern(program.name()))
    return available({kPatternDialect, "", "", {}, {}}, Failure::Kind::input, program.name());
  if (auto shown = shown_by(program, machine)) return *shown;
  return machine.empty() ? by_words(program) : of_machine(machine);
}

}  // namespace kerf::cli
