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

// Where nothing else is asked for.
constexpr machine::Language kMill{"fanuc-mill", "", "mill3"};

bool is_available(std::string_view dialect) {
  const std::vector<std::string_view> all = machine::available_dialects();
  return std::find(all.begin(), all.end(), dialect) != all.end();
}

std::string list_of_available() {
  std::string text;
  for (const std::string_view name : machine::available_dialects())
    text += (text.empty() ? "; available: " : ", ") + std::string(name);
  return text;
}

Outcome<DialectChoice> available(DialectChoice choice, Failure::Kind kind,
                                 const std::string& source) {
  if (is_available(choice.dialect)) return choice;
  return tl::unexpected(Failure{kind, source + ": the dialect " + choice.dialect +
                                          " is not available" + list_of_available()});
}

std::string machine_of(const std::string& dialect) {
  return std::string(machine::language_of(dialect).value_or(kMill).machine);
}

}  // namespace

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
