#include "cli/arguments.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <thread>

#include "cli/machine_setup.hpp"

namespace kerf::cli {
namespace {

// CLI11's own sentences about numbers print the largest double in full.
const CLI::Validator kNotNegative(
    [](const std::string& text) -> std::string {
      const auto value = parse_number(text);
      return value && *value >= 0 ? "" : "a number that is not negative is expected";
    },
    "");
const CLI::Validator kWholeNumber(
    [](const std::string& text) -> std::string {
      const auto value = parse_number(text);
      constexpr double kMost = 1e18;
      const bool whole = value && *value >= 0 && *value <= kMost && *value == std::floor(*value);
      return whole ? "" : "a whole number that is not negative is expected";
    },
    "");

void add_run(CLI::App& app, RunOptions& o) {
  CLI::App* run =
      app.add_subcommand("run", "runs a program on a virtual machine and prints a summary");
  run->add_option("program", o.program, "program file; - is standard input")->required();
  run->add_option("--machine", o.machine, "built-in machine or machine file (.toml)");
  run->add_option("--dialect", o.dialect, "language of the program: fanuc-mill");
  run->add_option("--library", o.libraries, "folder of further programs")->allow_extra_args(false);
  run->add_option("--set", o.variables, "sets a variable before the start: '#100=5'")
      ->allow_extra_args(false);
  run->add_option("--param", o.parameters, "changes a parameter of the control: KEY=VALUE")
      ->allow_extra_args(false);
  run->add_option("--machine-set", o.machine_keys,
                  "changes a key of the machine file: axis.X.velocity=12000")
      ->allow_extra_args(false);
  run->add_option("--decimal-point", o.decimal_point,
                  "numbers without a point: increment or calculator")
      ->check(CLI::IsMember({"increment", "calculator"}));
  run->add_option("--skip-at", o.skip_at, "skip signal at a machine position: X=7.2")
      ->allow_extra_args(false);
  run->add_option("--tools", o.tools, "tools as TOML or G10 blocks");
  run->add_option("--offsets", o.offsets, "offsets as TOML or G10 blocks");
  run->add_option("--state", o.state,
                  "permanent memory of the control, read before and written behind");
  run->add_option("--block-skip", o.block_skip, "block skip levels that are on: 1,3 or all");
  run->add_flag("--optional-stop", o.optional_stop, "M01 ends the run");
  run->add_option("--max-seconds", o.max_seconds, "computing time allowed, 0: any")
      ->check(kNotNegative);
  run->add_option("--max-motions", o.max_motions, "motions allowed, 0: any number")
      ->check(kWholeNumber);
  run->add_flag("--keep-partial", o.keep_partial,
                "writes --post also when the run does not reach its end");
  run->add_option("--summary", o.summary, "summary as JSON");
  run->add_option("--motion", o.motion, "motions as JSON Lines");
  run->add_option("--plot", o.plot, "picture of the path: .svg or .png");
  run->add_option("--dprnt", o.dprnt, "what the program prints; default standard output");
  run->add_option("--post", o.post, "the path as plain G-code without macros");
  run->add_option("--coverage", o.coverage, "how often each source line ran, as CSV");
  run->add_option_function<std::string>(
         "--diagnostics",
         [&o](const std::string& form) {
           o.diagnostics = form == "json" ? DiagnosticFormat::json : DiagnosticFormat::text;
         },
         "text or json")
      ->check(CLI::IsMember({"text", "json"}));
}

void add_check(CLI::App& app, CheckOptions& o) {
  CLI::App* check =
      app.add_subcommand("check", "compiles and runs files and prints what is wrong with them");
  check->add_option("files", o.files, "program files")->required();
  check->add_option("--machine", o.machine, "built-in machine or machine file (.toml)");
  check->add_option("--dialect", o.dialect, "language of the programs: fanuc-mill");
  check->add_option("--library", o.libraries, "folder of further programs")
      ->allow_extra_args(false);
  check->add_option("--param", o.parameters, "changes a parameter of the control: KEY=VALUE")
      ->allow_extra_args(false);
  check->add_option("--max-seconds", o.max_seconds, "computing time allowed for a file, 0: any")
      ->check(kNotNegative);
  check->add_option("--max-motions", o.max_motions, "motions allowed for a file, 0: any number")
      ->check(kWholeNumber);
  check->add_option("--jobs", o.jobs, "files checked at the same time")
      ->check(CLI::Range(1U, 256U));
  check->add_option("--format", o.format, "text, json, sarif or junit")
      ->check(CLI::IsMember({"text", "json", "sarif", "junit"}));
}

// CLI11 wants the words in reverse order.
std::vector<std::string> reversed(std::vector<std::string> words) {
  std::reverse(words.begin(), words.end());
  return words;
}

}  // namespace

base::Outcome<Request> parse_arguments(const std::vector<std::string>& words) {
  CLI::App app("Kerf runs CNC programs: FANUC G-code with Custom Macro B", "kerf");
  app.require_subcommand(1);
  app.set_version_flag("--version", "kerf 0.1.0");
  RunOptions run_options;
  CheckOptions check_options;
  check_options.jobs = std::max(1U, std::thread::hardware_concurrency());
  MachinesOptions machines_options;
  add_run(app, run_options);
  add_check(app, check_options);
  app.add_subcommand("machines", "lists the built-in machines, or prints the file of one")
      ->add_option("name", machines_options.name);
  try {
    app.parse(reversed(words));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
      std::ostringstream text;
      app.exit(error, text, text);
      return Answer{text.str()};
    }
    return tl::unexpected(
        base::Failure{base::Failure::Kind::usage,
                      std::string(error.what()) +
                          "; `kerf --help` and `kerf COMMAND --help` list what there is"});
  }
  if (app.got_subcommand("run")) return run_options;
  if (app.got_subcommand("check")) return check_options;
  return machines_options;
}

}  // namespace kerf::cli
