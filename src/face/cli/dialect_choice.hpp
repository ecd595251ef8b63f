#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "base/source_file.hpp"
#include "control/core/assumptions.hpp"
#include "machine/dialect/registry.hpp"
#include "output/reports/run_facts.hpp"

namespace kerf::cli {

/// Which language a program is written in, and on which machine it runs.
struct DialectChoice {
  std::string dialect;
  std::string machine;                ///< name or file
  std::string why;                    ///< sentence for the summary; empty when both were asked for
  output::RunFacts::Chosen chosen{};  ///< how, in a word each
  std::vector<control::Assumption> assumed{};  ///< what the words of the program led to
};

/// What was asked for, else what the file's ending says (`.bas`, `.tch`), else what its first lines
/// look like, else the dialect of the machine. If no machine was asked for: that of the dialect,
/// which is a lathe's where the words of the program are one's (machine/dialect/program_look.hpp).
/// `machine` and `dialect` are empty when not asked for. Failure (usage): the dialect is not
/// available; (input): the machine's is not, or the machine cannot be read.
[[nodiscard]] base::Outcome<DialectChoice> choose_dialect(const std::string& machine,
                                                          const std::string& dialect,
                                                          const base::SourceFile& program);

/// Here a replay runs it, and no control.
using machine::kPatternDialect;

/// Whether the file at `path` is the bytes of a pattern: the dialect that was asked for says so, or
/// its ending where none was.
[[nodiscard]] bool is_pattern(const std::string& dialect, const std::string& path);

/// The dialects that programs can be in, for people: "fanuc-mill, laser-basic, teach".
[[nodiscard]] std::string dialect_list();

/// The machines that are taken for texts when none is asked for, for people: "mill3, laser3 for
/// laser-basic".
[[nodiscard]] std::string usual_machines();

}  // namespace kerf::cli
