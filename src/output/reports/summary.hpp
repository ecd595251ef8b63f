#pragma once

#include <string>

#include "output/reports/run_facts.hpp"

namespace kerf::output {

/// JSON of the summary's members that outputs of the run tell; those that are empty are left out.
struct SummaryOfOutputs {
  std::string pattern;
  std::string post;
};

/// The summary of a run as one JSON object on one line (docs/command-line.md).
[[nodiscard]] std::string summary_json(const RunFacts& run, const SummaryOfOutputs& outputs = {});

/// The same for people: a few lines of text.
[[nodiscard]] std::string summary_text(const RunFacts& run);

}  // namespace kerf::output
