#include "face/cli/internal/draw_arguments.hpp"

#include "face/cli/option_groups.hpp"

namespace kerf::cli {
namespace {

void add_job(CLI::App& draw, DrawOptions& o) {
  draw.option_defaults()->group("Job");
  draw.add_option("--job", o.job, "what is done with which layer, as TOML: docs/drawings.md")
      ->type_name("FILE");
  draw.add_option("--process", o.process,
                  "without a job: what is done with everything; default engrave")
      ->type_name("KIND")
      ->check(CLI::IsMember({"engrave", "mark", "cut", "fill", "raster", "weld", "heat", "drill"}));
  repeated(draw.add_option("--job-set", o.job_keys,
                           "a key of the job: operation.outline.feed=600; may be repeated"))
      ->type_name("KEY=VALUE");
  repeated(draw.add_option("--materials", o.material_files, "further materials; may be repeated"))
      ->type_name("FILE");
  repeated(draw.add_option("--set", o.variables, "a variable of texts; may be repeated"))
      ->type_name("NAME=VALUE");
}

void add_reading(CLI::App& draw, DrawOptions& o) {
  draw.option_defaults()->group("Reading");
  draw.add_option("--unit", o.unit, "instead of the unit that the file says or lacks")
      ->type_name("UNIT")
      ->check(CLI::IsMember({"mm", "cm", "m", "in", "ft", "pt", "pc", "px", "um"}));
  draw.add_option("--dpi", o.dpi, "pixels an inch")->type_name("N")->check(CLI::Range(1.0, 1e5));
  draw.add_option("--tolerance", o.tolerance, "of curves that become arcs, mm; default 0.01")
      ->type_name("MM");
  draw.add_option("--join", o.join, "ends no farther apart are one, mm; default 0.02")
      ->type_name("MM");
  draw.add_option("--same", o.same, "what differs less is the same, mm; default 0.005")
      ->type_name("MM");
  repeated(draw.add_option("--layer", o.layers, "only this layer, * and ? match; may be repeated"))
      ->type_name("NAME");
}

void add_limits(CLI::App& draw, DrawOptions& o) {
  draw.option_defaults()->group("Limits");
  draw.add_option("--max-entities", o.max_entities, "entities, clones counted; default 5,000,000")
      ->type_name("N")
      ->check(whole_number());
  add_budget(draw, o.run.max_seconds, o.run.max_motions);
  draw.add_option("--fail-on", o.fail_on, "findings that make the command fail; default error")
      ->type_name("SEVERITY")
      ->check(CLI::IsMember({"error", "warning"}));
}

void add_outputs(CLI::App& draw, DrawOptions& o) {
  draw.option_defaults()->group("Outputs (- is standard output)");
  const auto file = [&](const char* name, std::string& path, const char* what) {
    draw.add_option(name, path, what)->type_name("FILE");
  };
  repeated(draw.add_option("--output", o.outputs,
                           "a program: .nc .ngc .gcode .tap, .bas, .tch, .pat or .jsonl; may be "
                           "repeated"))
      ->type_name("FILE");
  draw.add_option("--language", o.language, "of --output, whatever its ending")
      ->type_name("LANGUAGE")
      ->check(CLI::IsMember({"gcode", "laser-basic", "teach", "pattern", "motion"}));
  draw.add_option("--flavour", o.flavour, "of G-code; default plain")
      ->type_name("FLAVOUR")
      ->check(CLI::IsMember({"plain", "grbl", "linuxcnc", "fanuc"}));
  file("--contours", o.contours, "what was read and cleaned: .json, .svg or .dxf");
  file("--report", o.report, "everything that is known of drawing and plan, as JSON");
  file("--picture", o.picture, "picture of the path: .svg or .png");
  draw.add_flag("--plot-energy", o.run.plot_energy,
                "colours the cuts of --picture by the energy on each millimetre");
  draw.add_flag("--keep-partial", o.run.keep_partial, "writes programs in spite of errors");
  add_diagnostics(draw, o.run.diagnostics);
}

}  // namespace

void add_draw(CLI::App& app, DrawOptions& o) {
  CLI::App* draw =
      app.add_subcommand("draw", "makes programs of drawings: DXF, SVG, pictures, lens traces");
  draw->group("Commands");
  draw->add_option("drawing", o.drawings, "drawings, laid over each other; - is standard input")
      ->type_name("DRAWING");
  add_job(*draw, o);
  draw->option_defaults()->group("Machine");
  draw->add_option("--machine", o.run.machine, "built-in machine or machine file; default laser3")
      ->type_name("MACHINE");
  repeated(draw->add_option("--machine-set", o.run.machine_keys,
                            "a key of the machine file; may be repeated"))
      ->type_name("KEY=VALUE");
  add_reading(*draw, o);
  add_limits(*draw, o);
  add_outputs(*draw, o);
  draw->footer(
      "Example: kerf draw plate.dxf --job plate.toml --output plate.nc --picture plate.png");
}

}  // namespace kerf::cli
