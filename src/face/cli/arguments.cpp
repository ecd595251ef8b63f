#include "face/cli/arguments.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <thread>

#include "base/notices.hpp"
#include "face/cli/internal/draw_arguments.hpp"
#include "face/cli/internal/edit_arguments.hpp"
#include "face/cli/option_groups.hpp"
#include "face/cli/stock_arguments.hpp"

namespace kerf::cli {
namespace {

// How --post is written.
void add_post(CLI::App& command, CommonOptions& o) {
  command.add_option("--flavour", o.flavour, "of --post: plain, grbl, linuxcnc or fanuc")
      ->type_name("NAME");
  command
      .add_option("--axes", o.post_axes,
                  "axes of --post besides X Y Z, as AC; default: all that the flavour has")
      ->type_name("LETTERS");
  command
      .add_option("--post-tools", o.post_tools,
                  "the table of tools that --post asks its control for: linuxcnc, fanuc")
      ->type_name("FILE");
  command.add_flag("--post-strict", o.post_strict,
                   "--post is not written, and the exit status is 1, where it lost something");
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
  file("--pattern", o.pattern, "the pattern of an engraving arm that cuts the path");
  file("--pattern-plot", o.pattern_plot,
       "picture of the wheel's path on the true one: .svg or .png");
  file("--plot", o.plot, "picture of the path: .svg or .png");
  run.add_flag("--plot-speed", o.plot_speed,
               "colours the cuts of --plot by the speed that was really reached");
  run.add_flag("--plot-energy", o.plot_energy,
               "colours the cuts of --plot by the energy of the laser on each millimetre");
  file("--dprnt", o.dprnt, "what the program prints; default standard output");
  file("--post", o.post, "the path as plain G-code without macros");
  add_post(run, o);
  file("--teach", o.teach, "the path as taught points, a .tch file");
  file("--coverage", o.coverage, "how often each source line ran, as CSV");
  run.add_flag(
      "--keep-partial", o.keep_partial,
      "writes --post, --pattern, --teach and --pulses also when the run does not reach its "
      "end");
  add_diagnostics(run, o.diagnostics);
}

void add_run(CLI::App& app, RunOptions& o) {
  CLI::App* run =
      app.add_subcommand("run", "runs a program on a virtual machine and prints a summary");
  run->group("Commands");
  run->add_option("program", o.program, "program file; - is standard input")
      ->type_name("PROGRAM")
      ->required();
  run->option_defaults()->group("Machine, memory, panel");
  add_preparation(*run, o, Patterns::run);
  add_table(*run, o.table);
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
  add_preparation(*time, o.run, Patterns::not_run);
  time->option_defaults()->group("Limits");
  add_budget(*time, o.run.max_seconds, o.run.max_motions);
  time->option_defaults()->group("Output");
  time->add_option("--format", o.format, "text or json; default text")
      ->type_name("FORM")
      ->check(CLI::IsMember({"text", "json"}));
  time->footer("Example: kerf time part.nc --machine-set axis.X.acceleration=1500");
}

void add_features(CLI::App& app, FeaturesOptions& o) {
  CLI::App* features =
      app.add_subcommand("features", "recognises what a program machines and prints it as a tree");
  features->group("Commands");
  features->add_option("program", o.run.program, "program file; - is standard input")
      ->type_name("PROGRAM")
      ->required();
  features->option_defaults()->group("Machine, memory, panel");
  add_preparation(*features, o.run, Patterns::not_run);
  add_blank(*features, o.run.table);
  features->option_defaults()->group("Limits");
  add_budget(*features, o.run.max_seconds, o.run.max_motions);
  features->add_option("--memory", o.run.table.memory, "of what is recognised, MiB; default 1024")
      ->type_name("MIB")
      ->check(whole_number());
  features->option_defaults()->group("Output");
  features->add_option("--format", o.format, "text, json, or svg: a picture; default text")
      ->type_name("FORM")
      ->check(CLI::IsMember({"text", "json", "svg"}));
  features
      ->add_option("--method", o.method,
                   "both, swept, or literal: by the pattern of the rows alone; default both")
      ->type_name("METHOD")
      ->check(CLI::IsMember({"both", "swept", "literal"}));
  features->add_flag("--probe-arguments", o.probes_arguments,
                     "what each argument of a call reaches: runs the program once for each");
  add_diagnostics(*features, o.run.diagnostics);
  features->footer("Example: kerf features part.nc --tools tools.toml --stock box:0,0,-20,80,50,0");
}

void add_check(CLI::App& app, CheckOptions& o) {
  CLI::App* check =
      app.add_subcommand("check", "compiles and runs files and prints what is wrong with them");
  check->group("Commands");
  check->add_option("files", o.files, "program files")->type_name("FILE")->required();
  add_machine(*check, o.machine, o.dialect, Patterns::run);
  repeated(
      check->add_option("--library", o.libraries, "folder of further programs; may be repeated"))
      ->type_name("FOLDER");
  repeated(check->add_option("--param", o.parameters,
                             "changes a parameter of the control: DPI=1; may be repeated"))
      ->type_name("KEY=VALUE");
  check->add_option("--tools", o.tools, "tools: TOML, tool.tbl, a library of a CAM system")
      ->type_name("FILE");
  check->add_option("--tools-unit", o.tools_unit, "unit of a tool table that says none: mm or inch")
      ->type_name("UNIT")
      ->check(CLI::IsMember({"mm", "inch"}));
  add_table(*check, o.table, CuttingJobs::no_option);
  check->option_defaults()->group("Options");
  add_budget(*check, o.max_seconds, o.max_motions);
  check->add_option("--jobs", o.jobs, "files checked at the same time; default one a processor")
      ->type_name("N")
      ->check(CLI::Range(1U, 256U));
  check->add_option("--format", o.format, "text, json, sarif or junit; default text")
      ->type_name("FORM")
      ->check(CLI::IsMember({"text", "json", "sarif", "junit"}));
}

CLI::App* add_pattern_action(CLI::App& pattern, PatternOptions& o, PatternOptions::Action action,
                             const char* name, const char* what) {
  CLI::App* app = pattern.add_subcommand(name, what);
  app->group("Commands");
  app->callback([&o, action] { o.action = action; });
  app->add_option("file", o.file, "pattern file; - is standard input")
      ->type_name("FILE")
      ->required();
  app->add_option("--byte-order", o.byte_order, "of the counts of fast records")
      ->type_name("ORDER")
      ->check(CLI::IsMember({"big", "little"}));
  add_diagnostics(*app, o.diagnostics);
  return app;
}

void add_lenient(CLI::App& app, PatternOptions& o) {
  app.add_flag("--lenient", o.lenient, "does not look at the axis bits of triplets");
}

void add_replay(CLI::App& pattern, PatternOptions& o) {
  CLI::App* replay = add_pattern_action(pattern, o, PatternOptions::Action::replay, "replay",
                                        "runs a pattern on the machine and prints a summary");
  add_lenient(*replay, o);
  replay->option_defaults()->group("Machine");
  replay
      ->add_option("--machine", o.machine,
                   "machine file or built-in machine, arm4 or cartesian-step; default arm4")
      ->type_name("NAME|FILE.toml");
  repeated(replay->add_option("--machine-set", o.machine_keys,
                              "changes a key of the machine: drive.split=integer; may be repeated"))
      ->type_name("KEY=VALUE");
  replay->add_flag("--return-to-start", o.return_to_start,
                   "goes on with the records that bring every counter to 0, also behind an alarm");
  replay->option_defaults()->group("Limits");
  add_budget(*replay, o.max_seconds, o.max_motions);
  replay->option_defaults()->group("Outputs (- is standard output)");
  const auto file = [&](const char* name, std::string& path, const char* what) {
    replay->add_option(name, path, what)->type_name("FILE");
  };
  file("--output", o.output, "the records that were run, as a pattern");
  file("--summary", o.summary, "summary as JSON");
  file("--motion", o.motion, "motions of the tip as JSON Lines");
  file("--points", o.points, "where the axes are at every period of the servo, as CSV");
  file("--pulses", o.pulses, "step pulses of the motors: .csv or .vcd");
  file("--pwm", o.pwm, "pulses of a laser, which a pattern never switches on, as CSV");
  file("--rows", o.rows, "moves as rows of feature recognition, as CSV");
  file("--post", o.post, "the path of the tip as plain G-code without macros");
  add_post(*replay, o);
  file("--plot", o.plot, "picture of the path: .svg or .png");
  replay->add_flag(
      "--keep-partial", o.keep_partial,
      "writes --output, --post and --pulses also when the replay does not reach its end");
}

void add_pattern(CLI::App& app, PatternOptions& o) {
  using Action = PatternOptions::Action;
  CLI::App* pattern =
      app.add_subcommand("pattern", "reads, writes and runs patterns of the engraving arm");
  pattern->group("Commands")->require_subcommand(1);
  pattern->get_formatter()->label("SUBCOMMAND", "COMMAND");
  CLI::App* decode = add_pattern_action(*pattern, o, Action::decode, "decode",
                                        "prints the records of a pattern, a line each");
  add_lenient(*decode, o);
  decode->add_option("--output", o.output, "the listing; default standard output")
      ->type_name("FILE");
  CLI::App* encode = add_pattern_action(*pattern, o, Action::encode, "encode",
                                        "makes a pattern of such a listing");
  encode->add_option("--output", o.output, "the pattern; - is standard output")
      ->type_name("FILE")
      ->required();
  add_replay(*pattern, o);
}

void add_serve(CLI::App& app, ServeOptions& o) {
  CLI::App* serve = app.add_subcommand("serve", "serves the panel for a browser");
  serve->group("Commands");
  serve->add_option("--host", o.host, "address to listen at; default 127.0.0.1, this computer only")
      ->type_name("ADDRESS");
  serve->add_option("--port", o.port, "port to listen at; default 8080, 0: any free one")
      ->type_name("N");
  CLI::Option* const token =
      serve
          ->add_option("--token", o.token,
                       "what visitors must know, 16 characters or more; needed with any other "
                       "--host; default $KERF_TOKEN")
          ->type_name("TEXT");
  serve->add_option("--token-file", o.token_file, "a file that holds the token")
      ->type_name("FILE")
      ->excludes(token);
  serve
      ->add_option("--data", o.data,
                   "folder of programs and machines; default $XDG_DATA_HOME/kerf or "
                   "~/.local/share/kerf")
      ->type_name("FOLDER");
  serve->add_option("--threads", o.threads, "threads that machines run on; default one a processor")
      ->type_name("N")
      ->check(CLI::Range(1U, 64U));
  serve->add_flag("--protocol", o.protocol, "prints the protocol of the panel, and serves nothing");
  serve->footer("Example: kerf serve --port 8090");
}

void add_replay(CLI::App& app, ReplayOptions& o) {
  CLI::App* replay =
      app.add_subcommand("replay", "does again what was done at a panel, and says where it ends");
  replay->group("Commands");
  replay->add_option("file", o.file, "journal that the panel has saved")
      ->type_name("FILE")
      ->required();
  repeated(
      replay->add_option("--library", o.libraries, "folder of further programs; may be repeated"))
      ->type_name("FOLDER");
  add_max_seconds(*replay, o.max_seconds);
  replay->footer("Example: kerf replay mill3.journal.json");
}

// CLI11 wants the words in reverse order.
void add_tools(CLI::App& app, ToolsOptions& o) {
  CLI::App* const tools =
      app.add_subcommand("tools", "writes tools of another program as [[tool]] tables");
  tools->group("Commands");
  tools->add_option("file", o.file, "tool.tbl, or a library of Fusion or FreeCAD")
      ->type_name("FILE")
      ->required();
  tools->add_option("--tools-unit", o.unit, "unit of a tool table that says none: mm or inch")
      ->type_name("UNIT")
      ->check(CLI::IsMember({"mm", "inch"}));
}

std::vector<std::string> reversed(std::vector<std::string> words) {
  std::reverse(words.begin(), words.end());
  return words;
}

}  // namespace

base::Outcome<Request> parse_arguments(const std::vector<std::string>& words) {
  CLI::App app(
      "Kerf runs CNC programs: FANUC G-code with Custom Macro B, laser BASIC, taught points, "
      "patterns",
      "kerf");
  app.require_subcommand(1);
  app.get_formatter()->label("SUBCOMMAND", "COMMAND");
  app.set_version_flag("--version", "kerf 0.1.0");
  RunOptions run_options;
  TimeOptions time_options;
  StockOptions stock_options;
  FeaturesOptions features_options;
  EditOptions edit_options;
  CheckOptions check_options;
  check_options.jobs = std::max(1U, std::thread::hardware_concurrency());
  DrawOptions draw_options;
  PatternOptions pattern_options;
  MachinesOptions machines_options;
  MaterialsOptions materials_options;
  ServeOptions serve_options;
  ReplayOptions replay_options;
  ToolsOptions tools_options;
  add_run(app, run_options);
  add_time(app, time_options);
  add_stock(app, stock_options);
  add_features(app, features_options);
  add_edit(app, edit_options);
  add_check(app, check_options);
  add_draw(app, draw_options);
  add_pattern(app, pattern_options);
  add_serve(app, serve_options);
  add_replay(app, replay_options);
  add_tools(app, tools_options);
  app.add_subcommand("machines", "lists the built-in machines, or prints the file of one")
      ->group("Commands")
      ->add_option("name", machines_options.name, "the machine whose file is printed")
      ->type_name("NAME");
  app.add_subcommand("materials", "lists the built-in materials, or prints the file of one")
      ->group("Commands")
      ->add_option("name", materials_options.name, "the material whose file is printed")
      ->type_name("NAME");
  app.add_subcommand("notices", "prints the licences of what others wrote and is part of Kerf")
      ->group("Commands");
  app.footer(
      "Exit status: 0 all well, 1 the program is wrong, 2 wrong usage, 3 a file cannot be read or "
      "written, 4 a fault of Kerf, 5 a budget used up.");
  if (words.empty()) {
    return tl::unexpected(base::Failure{
        base::Failure::Kind::usage,
        "a command is needed: run, time, stock, features, edit, check, draw, "
        "pattern, serve, replay, tools, machines or notices; `kerf --help` lists them"});
  }
  try {
    app.parse(reversed(words));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
      const bool version = error.get_name() == "CallForVersion";
      return Answer{version ? error.what() + std::string("\n") : app.help()};
    }
    return tl::unexpected(
        base::Failure{base::Failure::Kind::usage,
                      std::string(error.what()) +
                          "; `kerf --help` and `kerf COMMAND --help` list what there is"});
  }
  if (app.got_subcommand("run")) return run_options;
  if (app.got_subcommand("time")) return time_options;
  if (app.got_subcommand("stock")) return stock_options;
  if (app.got_subcommand("features")) return features_options;
  if (app.got_subcommand("draw")) return draw_options;
  if (app.got_subcommand("edit")) return edit_options;
  if (app.got_subcommand("check")) return check_options;
  if (app.got_subcommand("pattern")) return pattern_options;
  if (app.got_subcommand("serve")) return serve_options;
  if (app.got_subcommand("replay")) return replay_options;
  if (app.got_subcommand("tools")) return tools_options;
  if (app.got_subcommand("materials")) return materials_options;
  if (app.got_subcommand("notices")) return Answer{std::string(base::notices().front().text)};
  return machines_options;
}

}  // namespace kerf::cli
