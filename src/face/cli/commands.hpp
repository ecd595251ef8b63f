#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "face/cli/exit_status.hpp"

namespace kerf::cli {

enum class DiagnosticFormat : std::uint8_t { text, json };

/// What runs of programs and of patterns are asked for alike; paths are empty when not asked for.
struct CommonOptions {
  std::vector<std::string> machine_keys;  ///< "KEY=VALUE"
  double max_seconds = 60;
  std::uint64_t max_motions = 50'000'000;
  bool keep_partial = false;
  std::string summary;
  std::string motion;
  std::string points;
  std::string pulses;
  std::string pwm;
  std::string rows;
  std::string post;
  std::string flavour;     ///< of the posted program; empty: plain
  std::string post_axes;   ///< letters of axes that it has besides X Y Z; empty: as the flavour has
  std::string post_tools;  ///< the table of tools that it asks for
  bool post_strict = false;
  std::string plot;
  DiagnosticFormat diagnostics = DiagnosticFormat::text;
};

/// What lies on the table, what holds it in the computer, and which checks count.
struct TableOptions {
  std::string set_up;  ///< a file; empty: none
  std::string stock;   ///< empty: as the set-up or the program has it, else extents
  std::string unit;    ///< of STL files, mm or inch; empty: mm
  std::string zero;    ///< empty: as the set-up has it, else auto
  std::string place;   ///< X,Y,Z[,A,B,C]; empty: as the set-up has it, else none
  std::string start;   ///< X,Y,Z; empty: nobody knows
  std::vector<std::string> fixtures;
  std::string model = "auto";
  std::string cell;      ///< mm; empty: by the tools, or the kerf
  std::string kerf;      ///< mm; empty: as the machine has it
  std::string memory;    ///< MiB; empty: 1024
  unsigned jobs = 0;     ///< threads; 0: one a processor
  std::string fail_on;   ///< empty: as the set-up has it, else warning
  std::string material;  ///< a group, or kc11,mc; empty: as the set-up has it, else not known
  std::string lengths;   ///< programmed or real; empty: as the set-up has it, else programmed
  std::vector<std::string> no_checks;  ///< codes

  friend bool operator==(const TableOptions&, const TableOptions&) = default;
};

/// What the options of `kerf run` ask for.
struct RunOptions : CommonOptions {
  std::string program;
  std::string machine;
  std::string dialect;
  std::vector<std::string> libraries;
  std::vector<std::string> variables;   ///< "#100=5"
  std::vector<std::string> parameters;  ///< "KEY=VALUE"
  std::string decimal_point;
  std::vector<std::string> skip_at;  ///< "AXIS=VALUE"
  std::vector<double> interrupt_at;  ///< s of the run, each >= 0
  std::string tools;
  std::string tools_unit = "mm";  ///< of a table that says none: "mm" or "inch"
  std::string offsets;
  std::string state;
  std::string block_skip;
  bool optional_stop = false;
  std::string pattern;
  std::string pattern_plot;
  bool plot_speed = false;
  bool plot_energy = false;
  std::string dprnt;
  std::string teach;
  std::string coverage;
  TableOptions table;
};

/// A run whose time is looked at; outputs are not asked for.
struct TimeOptions {
  RunOptions run;
  std::string format = "text";
};

/// Files of the part that `kerf stock` has cut; empty: not asked for.
struct StockFileOptions {
  std::string stl;
  std::string glb;
  std::string three_mf;
  std::string profile;        ///< .svg, .dxf or .csv
  std::string picture;        ///< .png or .svg
  std::string view;           ///< empty: as the part is mostly shown
  std::string save;           ///< .kstock
  bool keep_partial = false;  ///< also of a run that did not reach its end
  std::string mesh = "smooth";
  std::size_t triangles = 0;  ///< at most; 0: as many as there are
};

/// What a part is compared with; empty: with nothing.
struct CompareOptions {
  std::string design;  ///< STL
  std::string design_place;
  std::string tolerance;
  std::string gouge;
  std::string excess;
  std::string against;        ///< a program, or a .kstock
  std::string against_tools;  ///< of that program; empty: those of the run
};

/// A run that cuts the virtual part: RunOptions::table says what lies there.
struct StockOptions {
  RunOptions run;      ///< without outputs
  std::string report;  ///< JSON
  StockFileOptions files;
  CompareOptions compare;
  std::string blocks;  ///< CSV
  std::string path = "programmed";
  std::string until;  ///< a line, or seconds with an s
  bool stop_at_finding = false;
};

/// A run in which is recognised what it machines: RunOptions::table says what lies there.
struct FeaturesOptions {
  RunOptions run;  ///< without outputs
  std::string format = "text";
  std::string method = "both";
  bool probes_arguments = false;
};

/// Features of a program are edited, or an edit is taken back; paths are empty when not asked for.
struct EditOptions {
  RunOptions run;              ///< without outputs
  std::string edits;           ///< the edits file
  std::string undo;            ///< the report of the edit that is taken back
  std::string output;          ///< the program as it is then
  std::string output_library;  ///< a folder for other files that change
  std::string diff;
  std::string report;  ///< JSON
  bool allows_collision = false;
  bool allows_rest = false;
};

struct CheckOptions {
  std::vector<std::string> files;
  std::string machine;
  std::string dialect;
  std::vector<std::string> libraries;
  std::vector<std::string> parameters;
  std::string tools;
  std::string tools_unit = "mm";
  TableOptions table;
  double max_seconds = 60;  ///< for each file
  std::uint64_t max_motions = 50'000'000;
  unsigned jobs = 1;
  std::string format = "text";
};

/// Patterns of the engraving arm as bytes, as text and on the machine.
struct PatternOptions : CommonOptions {
  enum class Action : std::uint8_t { decode, encode, replay };

  Action action = Action::decode;
  std::string file;
  std::string output;
  std::string byte_order;  ///< empty: that of the machine, else high byte first
  bool lenient = false;
  // Of a replay
  std::string machine = "arm4";
  bool return_to_start = false;
};

/// Drawings are read and planned on a machine; paths are empty when not asked for.
struct DrawOptions {
  RunOptions run;  ///< machine, memory, limits; of the outputs `plot`
  std::vector<std::string> drawings;
  std::string job;
  std::string process = "engrave";    ///< without a job
  std::vector<std::string> job_keys;  ///< "KEY=VALUE"
  std::vector<std::string> material_files;
  std::vector<std::string> variables;  ///< "NAME=VALUE"
  std::vector<std::string> outputs;
  std::string language;  ///< of the outputs; empty: by their endings
  std::string flavour = "plain";
  std::string contours;
  std::string report;
  std::string picture;
  std::string unit;
  double dpi = 0;
  std::string tolerance;  ///< mm; empty: as the job has it
  std::string join;
  std::string same;
  std::vector<std::string> layers;
  std::uint64_t max_entities = 5'000'000;
  std::string fail_on = "error";
};

/// What was done at a panel is done again.
struct ReplayOptions {
  std::string file;
  std::vector<std::string> libraries;
  double max_seconds = 60;
};

/// The panel in the browser: whoever has a server serves it.
struct ServeOptions {
  std::string host = "127.0.0.1";
  std::uint16_t port = 8080;
  std::string token;
  std::string token_file;
  std::string data;       ///< folder; empty: the usual one
  unsigned threads = 0;   ///< that machines run on; 0: one a processor
  bool protocol = false;  ///< prints the protocol instead
};

/// A file of tools, to be written as [[tool]] tables.
struct ToolsOptions {
  std::string file;
  std::string unit = "mm";  ///< of a table that says none: "mm" or "inch"
};

[[nodiscard]] ExitStatus run(const RunOptions& options);
[[nodiscard]] ExitStatus time(const TimeOptions& options);
[[nodiscard]] ExitStatus stock(const StockOptions& options);
[[nodiscard]] ExitStatus features(const FeaturesOptions& options);
[[nodiscard]] ExitStatus edit(const EditOptions& options);
[[nodiscard]] ExitStatus check(const CheckOptions& options);
[[nodiscard]] ExitStatus pattern(const PatternOptions& options);
[[nodiscard]] ExitStatus draw(const DrawOptions& options);
[[nodiscard]] ExitStatus replay(const ReplayOptions& options);
/// Writes tools of any format as TOML on standard output, what is not understood on standard error.
[[nodiscard]] ExitStatus tools(const ToolsOptions& options);
/// Lists the built-in materials, or prints the files that have one.
[[nodiscard]] ExitStatus materials(const std::string& name);
/// Lists the built-in machines, or prints the file of one.
[[nodiscard]] ExitStatus machines(const std::string& name);

}  // namespace kerf::cli
