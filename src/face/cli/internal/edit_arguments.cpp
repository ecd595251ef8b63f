#include "face/cli/internal/edit_arguments.hpp"

#include "face/cli/option_groups.hpp"
#include "face/cli/stock_arguments.hpp"

namespace kerf::cli {
namespace {

void add_wishes(CLI::App& edit, EditOptions& o) {
  edit.option_defaults()->group("Edit");
  edit.add_option("--edits", o.edits, "what is edited, as JSON: docs/edit-features.md")
      ->type_name("FILE");
  edit.add_option("--undo", o.undo,
                  "instead of --edits: takes back the edit that this report tells of")
      ->type_name("REPORT");
  edit.add_flag("--allow-collision", o.allows_collision,
                "what cuts into another feature is a warning");
  edit.add_flag("--allow-rest", o.allows_rest, "material that stays uncut is a warning");
}

void add_edit_outputs(CLI::App& edit, EditOptions& o) {
  edit.option_defaults()->group("Outputs (- is standard output)");
  edit.add_option("--output", o.output,
                  "the edited program; may be PROGRAM itself. Written only if all held")
      ->type_name("FILE");
  edit.add_option("--output-library", o.output_library,
                  "a folder for other files that change: those of --library")
      ->type_name("FOLDER");
  edit.add_option("--diff", o.diff,
                  "what changes, as a unified diff; without --output no program is written")
      ->type_name("FILE");
  edit.add_option("--report", o.report, "what was edited and verified, as JSON, for --undo as well")
      ->type_name("FILE");
}

}  // namespace

void add_edit(CLI::App& app, EditOptions& o) {
  CLI::App* edit = app.add_subcommand(
      "edit", "edits features of a program: only the blocks that make them change");
  edit->group("Commands");
  edit->add_option("program", o.run.program, "program file; - is standard input")
      ->type_name("PROGRAM")
      ->required();
  add_wishes(*edit, o);
  edit->option_defaults()->group("Machine, memory, panel");
  add_preparation(*edit, o.run, Patterns::not_run);
  add_blank(*edit, o.run.table);
  edit->option_defaults()->group("Limits");
  add_budget(*edit, o.run.max_seconds, o.run.max_motions);
  add_edit_outputs(*edit, o);
  add_diagnostics(*edit, o.run.diagnostics);
  edit->footer("Example: kerf edit part.nc --tools tools.toml --edits wider.json --diff -");
}

base::Outcome<void> check_edit(const EditOptions& o) {
  if (o.edits.empty() == o.undo.empty())
    return base::usage("kerf edit takes either --edits or --undo");
  if (o.output.empty() && o.diff.empty())
    return base::usage("kerf edit has nowhere to go: --output or --diff is needed");
  const bool has_wishes = !o.report.empty() || o.allows_collision || o.allows_rest;
  if (!o.undo.empty() && has_wishes)
    return base::usage("--report, --allow-collision and --allow-rest go with --edits, not --undo");
  if (o.run.program == "-" && (o.edits == "-" || o.undo == "-"))
    return base::usage("standard input can be only one of program and edits");
  return {};
}

}  // namespace kerf::cli
