#include "face/cli/stock_arguments.hpp"

#include "face/cli/option_groups.hpp"
#include "face/cli/stock_files.hpp"

namespace kerf::cli {

void add_blank(CLI::App& app, TableOptions& o) {
  app.option_defaults()->group("Stock");
  app.add_option("--setup", o.set_up,
                 "stock, fixtures, material, checks and design as a TOML file; the other options "
                 "count more")
      ->type_name("FILE");
  app.add_option(
         "--stock", o.stock,
         "box:X0,Y0,Z0,X1,Y1,Z1, cylinder:AXIS,U,V,W0,W1,D, tube:AXIS,U,V,W0,W1,D,DI, "
         "bar:D,Z0,Z1[,DI] on a lathe, sheet:X0,Y0,X1,Y1,T under a laser, an STL or a .kstock, or "
         "extents[:M], around what is cut; default a WORKPIECE comment of the program, "
         "else extents:5")
      ->type_name("SHAPE");
  app.add_option("--stock-unit", o.unit, "unit of STL files: mm or inch; default mm")
      ->type_name("UNIT")
      ->check(CLI::IsMember({"mm", "inch"}));
  app.add_option("--stock-zero", o.zero,
                 "where its zero stands: G54 to G59, G54.1P1 to G54.1P300, machine or auto, the "
                 "one in force at the first cut; default auto")
      ->type_name("SYSTEM");
  app.add_option("--stock-place", o.place,
                 "how it is clamped: turned about its zero by A about X, B about Y, C about Z, "
                 "then moved")
      ->type_name("X,Y,Z[,A,B,C]");
  repeated(app.add_option("--fixture", o.fixtures,
                          "what must not be touched, in the same words; may be repeated"))
      ->type_name("SHAPE");
}

namespace {

void add_start(CLI::App& app, TableOptions& o) {
  app.add_option("--start", o.start,
                 "where the axes begin, machine coordinates; rapids from there are checked")
      ->type_name("X,Y,Z");
}

void add_checks(CLI::App& app, TableOptions& o) {
  app.option_defaults()->group("Checks");
  repeated(app.add_option("--no-check", o.no_checks, "leaves a check out; may be repeated"))
      ->type_name("CODE");
  app.add_option("--fail-on", o.fail_on,
                 "findings that make the exit status 1: error, warning or never; default warning")
      ->type_name("SEVERITY")
      ->check(CLI::IsMember({"error", "warning", "never"}));
}

}  // namespace

void add_table(CLI::App& app, TableOptions& o, CuttingJobs jobs) {
  add_blank(app, o);
  add_start(app, o);
  app.add_option("--model", o.model,
                 "auto, zmap, tridexel, on a lathe profile, under a laser sheet; default auto")
      ->type_name("KIND")
      ->check(CLI::IsMember({"auto", "zmap", "tridexel", "profile", "sheet"}));
  app.add_option("--cell", o.cell, "largest cell, mm; default by the smallest tool")
      ->type_name("MM")
      ->check(not_negative());
  app.add_option("--kerf", o.kerf, "width of a laser's cut, mm; default that of its spot")
      ->type_name("MM")
      ->check(not_negative());
  app.add_option("--memory", o.memory, "of the part, MiB; default 1024")
      ->type_name("MIB")
      ->check(whole_number());
  if (jobs == CuttingJobs::option) {
    app.add_option("--jobs", o.jobs, "threads that cut; default one a processor")
        ->type_name("N")
        ->check(CLI::Range(1U, 256U));
  }
  app.add_option("--material", o.material,
                 "P, M, K, N, S, H or KC11,MC: tells forces and power of cuts")
      ->type_name("GROUP");
  app.add_option("--lengths", o.lengths,
                 "programmed, or real: tools stand where their length puts them, not their "
                 "offset; default programmed")
      ->type_name("KIND")
      ->check(CLI::IsMember({"programmed", "real"}));
  add_checks(app, o);
}

namespace {

void add_comparison(CLI::App& stock, CompareOptions& o) {
  stock.option_defaults()->group("Comparison");
  stock
      .add_option("--design", o.design,
                  "what the part shall be: closed STL, mm, frame of the stock")
      ->type_name("FILE");
  stock
      .add_option(
          "--design-place", o.design_place,
          "where the design lies: turned about its zero by A about X, B about Y, C about Z, "
          "then moved")
      ->type_name("X,Y,Z[,A,B,C]");
  stock
      .add_option("--against", o.against,
                  "a program that shall leave the same part, or a .kstock; - is standard input")
      ->type_name("FILE");
  stock
      .add_option("--against-tools", o.against_tools,
                  "tools of that program; default those of this one")
      ->type_name("FILE");
  stock.add_option("--tolerance", o.tolerance, "what it may be off, mm; default 0.05")
      ->type_name("MM");
  stock.add_option("--gouge", o.gouge, "likewise where too much is cut")->type_name("MM");
  stock.add_option("--excess", o.excess, "likewise where material is left")->type_name("MM");
}

}  // namespace

void add_stock(CLI::App& app, StockOptions& o) {
  CLI::App* stock =
      app.add_subcommand("stock", "cuts the virtual part, checks it and writes what is left");
  stock->group("Commands");
  stock->add_option("program", o.run.program, "program file; - is standard input")
      ->type_name("PROGRAM")
      ->required();
  stock->option_defaults()->group("Machine, memory, panel");
  add_preparation(*stock, o.run, Patterns::not_run);
  add_table(*stock, o.run.table);
  stock->add_flag("--stop-at-finding", o.stop_at_finding,
                  "what is behind the first finding is not cut");
  stock->option_defaults()->group("Stock");
  stock
      ->add_option("--path", o.path,
                   "programmed, or interpolated: along the set-points, with rounded corners; "
                   "default programmed")
      ->type_name("KIND")
      ->check(CLI::IsMember({"programmed", "interpolated"}));
  stock
      ->add_option("--until", o.until,
                   "the part as it is before this line begins, or at this second: 12.5s")
      ->type_name("LINE|Ts");
  add_comparison(*stock, o.compare);
  stock->option_defaults()->group("Limits");
  add_budget(*stock, o.run.max_seconds, o.run.max_motions);
  stock->option_defaults()->group("Outputs (- is standard output)");
  stock->add_option("--report", o.report, "the report as JSON")->type_name("FILE");
  add_stock_files(*stock, o.files);
  stock
      ->add_option("--blocks", o.blocks,
                   "a row for every motion: what it cuts, engagement, forces (CSV)")
      ->type_name("FILE");
  add_diagnostics(*stock, o.run.diagnostics);
  stock->footer("Example: kerf stock part.nc --stock box:0,0,-20,100,60,0 --tools tools.toml");
}

}  // namespace kerf::cli
