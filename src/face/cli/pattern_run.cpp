#include "face/cli/pattern_run.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "face/cli/failure.hpp"

namespace kerf::cli {
namespace {

struct Given {
  const char* option;
  bool given;
};

// What is for programs only: a pattern has no variables, words, tools or stops, and it ends.
const char* option_without_meaning(const RunOptions& o) {
  const std::array all = {
      Given{"--library", !o.libraries.empty()},  Given{"--set", !o.variables.empty()},
      Given{"--param", !o.parameters.empty()},   Given{"--decimal-point", !o.decimal_point.empty()},
      Given{"--skip-at", !o.skip_at.empty()},    Given{"--interrupt-at", !o.interrupt_at.empty()},
      Given{"--tools", !o.tools.empty()},        Given{"--offsets", !o.offsets.empty()},
      Given{"--state", !o.state.empty()},        Given{"--block-skip", !o.block_skip.empty()},
      Given{"--optional-stop", o.optional_stop}, Given{"--pattern-plot", !o.pattern_plot.empty()},
      Given{"--plot-speed", o.plot_speed},       Given{"--plot-energy", o.plot_energy},
      Given{"--dprnt", !o.dprnt.empty()},        Given{"--teach", !o.teach.empty()},
      Given{"--coverage", !o.coverage.empty()}};
  const auto first = std::find_if(all.begin(), all.end(), [](const Given& g) { return g.given; });
  return first == all.end() ? nullptr : first->option;
}

}  // namespace

ExitStatus run_pattern(const RunOptions& options) {
  if (const char* const option = option_without_meaning(options))
    return fail({base::Failure::Kind::usage,
                 std::string(option) + " does not go with --dialect pattern: it is for programs"});
  PatternOptions replay;
  static_cast<CommonOptions&>(replay) = options;
  replay.action = PatternOptions::Action::replay;
  replay.file = options.program;
  replay.output = options.pattern;
  if (!options.machine.empty()) replay.machine = options.machine;
  return pattern(replay);
}

}  // namespace kerf::cli
