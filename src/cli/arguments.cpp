#include "cli/arguments.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <thread>

#include "base/decimal.hpp"
#include "cli/machine_setup.hpp"

namespace kerf::cli {
namespace {

// CLI11's own sentences about numbers print the largest double in full.
const CLI::Validator kNotNegative(
    [](const std::string& text) -> std::string {
      const auto value = base::parse_number(text);
      return value && *value >= 0 ? "" : "a number that is not negative is expected";
    },
    "");
const CLI::Validator kWholeNumber(
    [](const std::string& text) -> std::string {
      const auto value = base::parse_number(text);
      constexpr double kMost = 1e18;
      const bool whole = value && *value >= 0 && *value <= kMost && *value == std::floor(*value);
      return whole ? "" : "a whole number that is not negative is expected";
    },
    "");

// One value a time: `--set A B` is no way to write two.
CLI::Option* repeated(CLI::Option* option) { return option->allow_extra_args(false); }

void add_machine(CLI::App& app, std::string& machine, std::string& dialect) {
  app.add_option("--machine", machine, "built-in machine or machine file; default mill3")
      ->type_name("NAME|FILE.toml");
  app.add_option("--dialect", dialect, "language; default that of the machine: fanuc-mill")
      ->type_name("NAME");
}

void add_preparation(CLI::App& run, RunOptions& o) {
  add_machine(run, o.machine, o.dialect);
  repeated(run.add_option("--library", o.libraries, "folder of further programs; may be repeated"))
      ->type_name("FOLDER");
  repeated(run.add_option("--set", o.variables,
                          "sets a variable before the start: '#100=5'; may be repeated"))
      ->type_name("#N=VALUE");
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
  run.add_option("--tools", o.tools, "tools as TOML or G10 blocks")->type_name("FILE");
  run.add_option("--offsets", o.offsets, "offsets as TOML or G10 blocks")->type_name("FILE");
  run.add_option("--state", o.state,
                 "permanent memory of the control, read before and written after the run")
      ->type_name("FILE");
  run.add_option("--block-skip", o.block_skip, "block skip levels that are on: 1,3 or all")
      ->type_name("LIST");
  run.add_flag("--optional-stop", o.optional_stop, "M01 ends the run");
}

void add_budget(CLI::App& app, double& seconds, std::uint64_t& motions) {
  app.add_option("--max-seconds", seconds, "computing time allowed; default 60, 0: any")
      ->type_name("N")
      ->check(kNotNegative);
  app.add_option("--max-motions", motions, "motions allowed; default 50000000, 0: any number")
      ->type_name("N")
      ->check(kWholeNumber);
}

void add_outputs(CLI::App& run, RunOptions& o) {
  const auto file = [&](const char* name, std::string& path, const char* what) {
    run.add_option(name, path, what)->type_name("FILE");
  };
  file("--summary", o.summary, "summary as JSON");
  file("--motion", o.motion, "motions as JSON Lines");
  file("--points", o.points, "where the axes are at every period of the servo, as CSV");
  file("--pulses", o.pulses, "step pulses of the motors: .csv or .vcd");
  file("--pwm", o.pwm, "changes of a laser's pulses and their timer, as CSV");
  file("--rows", o.rows, "moves and tool changes as rows of feature recognition, as CSV");
  file("--plot", o.plot, "picture of the path: .svg or .png");
  run.add_flag("--plot-speed", o.plot_speed,
               "colours the cuts of --plot by the speed that was really reached");
  file("--dprnt", o.dprnt, "what the program prints; default standard output");
  file("--post", o.post, "the path as plain G-code without macros");
  file("--teach", o.teach, "the path as taught points, a .tch file");
  file("--coverage", o.coverage, "how often each source line ran, as CSV");
  run.add_flag("--keep-partial", o.keep_partial,
               "writes --post, --teach and --pulses also when the run does not reach its end");
  run.add_option_function<std::string>(
         "--diagnostics",
         [&o](const std::string& form) {
           o.diagnostics = form == "json" ? DiagnosticFormat::json : DiagnosticFormat::text;
         },
         "alarms and warnings as text or as one JSON object a line; default text")
      ->type_name("FORM")
      ->check(CLI::IsMember({"text", "json"}));
}

void add_run(CLI::App& app, RunOptions& o) {
  CLI::App* run =
      app.add_subcommand("run", "runs a program on a virtual machine and prints a summary");
  run->group("Commands");
  run->add_option("program", o.program, "program file; - is standard input")
      ->type_name("PROGRAM")
      ->required();
  run->option_defaults()->group("Machine, memory, panel");
  add_preparation(*run, o);
  run->option_defaults()->group("Limits");
  add_budget(*run, o.max_seconds, o.max_motions);
  run->option_defaults()->group("Outputs (- is standard output)");
  add_outputs(*run, o);
  run->footer("Example: kerf run part.nc --plot part.svg --set '#100=5'");
}

void add_time(CLI::App& app, TimeOptions& o) {
  CLI::App* time = app.add_subcommand("time", "runs a program and prints where its time goes");
  time->group("Commands");
  time->add_option("program", o.run.program, "program file; - is standard input")
      ->type_name("PROGRAM")
      ->required();
  time->option_defaults()->group("Machine, memory, panel");
  add_preparation(*time, o.run);
  time->option_defaults()->group("Limits");
  add_budget(*time, o.run.max_seconds, o.run.max_motions);
  time->option_defaults()->group("Output");
  time->add_option("--format", o.format, "text or json; default text")
      ->type_name("FORM")
      ->check(CLI::IsMember({"text", "json"}));
  time->footer("Example: kerf time part.nc --machine-set axis.X.acceleration=1500");
}

void add_check(CLI::App& app, CheckOptions& o) {
  CLI::App* check =
      app.add_subcommand("check", "compiles and runs files and prints what is wrong with them");
  check->group("Commands");
  check->add_option("files", o.files, "program files")->type_name("FILE")->required();
  add_machine(*check, o.machine, o.dialect);
  repeated(
      check->add_option("--library", o.libraries, "folder of further programs; may be repeated"))
      ->type_name("FOLDER");
  repeated(check->add_option("--param", o.parameters,
                             "changes a parameter of the control: DPI=1; may be repeated"))
      ->type_name("KEY=VALUE");
  add_budget(*check, o.max_seconds, o.max_motions);
  check->add_option("--jobs", o.jobs, "files checked at the same time; default one a processor")
      ->type_name("N")
      ->check(CLI::Range(1U, 256U));
  check->add_option("--format", o.format, "text, json, sarif or junit; default text")
      ->type_name("FORM")
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
  app.get_formatter()->label("SUBCOMMAND", "COMMAND");
  app.set_version_flag("--version", "kerf 0.1.0");
  RunOptions run_options;
  TimeOptions time_options;
  CheckOptions check_options;
  check_options.jobs = std::max(1U, std::thread::hardware_concurrency());
  MachinesOptions machines_options;
  add_run(app, run_options);
  add_time(app, time_options);
  add_check(app, check_options);
  app.add_subcommand("machines", "lists the built-in machines, or prints the file of one")
      ->group("Commands")
      ->add_option("name", machines_options.name, "the machine whose file is printed")
      ->type_name("NAME");
  app.footer(
      "Exit status: 0 all well, 1 the program is wrong, 2 wrong usage, 3 a file cannot be read or "
      "written, 4 a fault of Kerf, 5 a budget used up.");
  if (words.empty()) {
    return tl::unexpected(base::Failure{
        base::Failure::Kind::usage,
        "a command is needed: run, time, check or machines; `kerf --help` lists them"});
  }
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
  if (app.got_subcommand("time")) return time_options;
  if (app.got_subcommand("check")) return check_options;
  return machines_options;
}

}  // namespace kerf::cli
