#include "face/cli/option_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/decimal.hpp"
#include "face/cli/dialect_choice.hpp"
#include "machine/definition/machine_definition.hpp"

namespace kerf::cli {
namespace {

// CLI11 itself reads a long double, which is a double on some processors and more on others.
double number_of(const std::string& text) { return base::read_number(text).value_or(0); }

std::string built_in_machines() {
  std::string text;
  for (const machine::BuiltinMachine& machine : machine::builtin_machines()) {
    if (!text.empty()) text += ", ";
    text += machine.name;
  }
  return text;
}

}  // namespace

CLI::Validator not_negative() {
  return CLI::Validator(
      [](const std::string& text) -> std::string {
        const auto value = base::read_number(text);
        return value && *value >= 0 ? "" : "a number that is not negative is expected";
      },
      "");
}

CLI::Validator whole_number() {
  return CLI::Validator(
      [](const std::string& text) -> std::string {
        const auto value = base::read_number(text);
        constexpr double kMost = 1e18;
        const bool whole = value && *value >= 0 && *value <= kMost && *value == std::floor(*value);
        return whole ? "" : "a whole number that is not negative is expected";
      },
      "");
}

CLI::Option* repeated(CLI::Option* option) { return option->allow_extra_args(false); }

void add_machine(CLI::App& app, std::string& machine, std::string& dialect, Patterns patterns) {
  const std::string pattern = std::string(", ") + kPatternDialect;
  const std::string_view counts = machine::find_dialect(kPatternDialect)->machine;
  const bool run = patterns == Patterns::run;
  app.add_option("--machine", machine,
                 "machine file or built-in machine: " + built_in_machines() + "; default " +
                     usual_machines() +
                     (run ? fmt::format(", {} for {}", counts, kPatternDialect) : ""))
      ->type_name("NAME|FILE.toml");
  app.add_option("--dialect", dialect,
                 "language: " + dialect_list() + (run ? pattern : "") +
                     "; default what the file's ending or its first lines tell, else that of the "
                     "machine")
      ->type_name("NAME");
}

void add_preparation(CLI::App& run, RunOptions& o, Patterns patterns) {
  add_machine(run, o.machine, o.dialect, patterns);
  repeated(run.add_option("--library", o.libraries, "folder of further programs; may be repeated"))
      ->type_name("FOLDER");
  repeated(run.add_option("--set", o.variables,
                          "sets a variable before the start: '#100=5', in laser BASIC x=5; may be "
                          "repeated"))
      ->type_name("NAME=VALUE");
  repeated(run.add_option("--param", o.parameters,
                          "changes a parameter of the control: DPI=1; may be repeated"))
      ->type_name("KEY=VALUE");
  repeated(run.add_option("--machine-set", o.machine_keys,
                          "changes a key of the machine: axis.X.velocity=12000; may be repeated"))
      ->type_name("KEY=VALUE");
  run.add_option("--decimal-point", o.decimal_point,
                 "X20 without a point is 0.020 mm (increment) or 20 mm (calculator); default that "
                 "of the machine")
      ->type_name("KIND")
      ->check(CLI::IsMember({"increment", "calculator"}));
  repeated(run.add_option("--skip-at", o.skip_at,
                          "the skip signal of G31 comes on there: X=7.2; may be repeated"))
      ->type_name("AXIS=VALUE");
  repeated(run.add_option_function<std::vector<std::string>>(
               "--interrupt-at",
               [&times = o.interrupt_at](const std::vector<std::string>& texts) {
                 std::transform(texts.begin(), texts.end(), std::back_inserter(times), number_of);
               },
               "the interrupt signal of M96 comes at this time of the run; may be repeated"))
      ->type_name("SECONDS")
      ->check(not_negative());
  run.add_option("--tools", o.tools, "tools: TOML, G10 blocks, tool.tbl, a library of a CAM system")
      ->type_name("FILE");
  run.add_option("--tools-unit", o.tools_unit, "unit of a tool table that says none: mm or inch")
      ->type_name("UNIT")
      ->check(CLI::IsMember({"mm", "inch"}));
  run.add_option("--offsets", o.offsets, "offsets as TOML or G10 blocks")->type_name("FILE");
  run.add_option(
         "--state", o.state,
         "permanent memory of the control, read before the run; kerf run writes it behind that")
      ->type_name("FILE");
  run.add_option("--block-skip", o.block_skip, "block skip levels that are on: 1,3 or all")
      ->type_name("LIST");
  run.add_flag("--optional-stop", o.optional_stop, "M01 ends the run");
}

void add_max_seconds(CLI::App& app, double& seconds) {
  app.add_option_function<std::string>(
         "--max-seconds", [&seconds](const std::string& text) { seconds = number_of(text); },
         "computing time allowed; default 60, 0: any")
      ->type_name("N")
      ->check(not_negative());
}

void add_budget(CLI::App& app, double& seconds, std::uint64_t& motions) {
  add_max_seconds(app, seconds);
  app.add_option("--max-motions", motions, "motions allowed; default 50000000, 0: any number")
      ->type_name("N")
      ->check(whole_number());
}

void add_diagnostics(CLI::App& app, DiagnosticFormat& diagnostics) {
  app.add_option_function<std::string>(
         "--diagnostics",
         [&diagnostics](const std::string& form) {
           diagnostics = form == "json" ? DiagnosticFormat::json : DiagnosticFormat::text;
         },
         "alarms and warnings as text or as one JSON object a line; default text")
      ->type_name("FORM")
      ->check(CLI::IsMember({"text", "json"}));
}

}  // namespace kerf::cli
