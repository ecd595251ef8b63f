#pragma once

#include <optional>
#include <string>

#include "output/reports/run_facts.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::output {

/// JSON of the members that tell what was found in a run with stock (docs/stock.md, Report).
struct CheckedStock {
  std::string findings;
  std::string counts;
  std::string not_checked;
};

/// JSON of the summary's members that outputs of the run tell; those that are empty are left out.
struct SummaryOfOutputs {
  std::string pattern;
  std::string post;
  std::string energy{};
  std::optional<CheckedStock> stock{};
};

/// The word that reports have for how a run ended.
[[nodiscard]] std::string status_name(RunFacts::Status status);

/// An alarm as reports tell it, or null.
[[nodiscard]] std::string alarm_json(const std::optional<RunFacts::Alarm>& alarm);

/// How every report of a run begins: program, file, machine, dialect, status, alarm.
[[nodiscard]] JsonObject head_of_report(const RunFacts& run);

/// The summary of a run as one JSON object on one line (docs/command-line.md).
[[nodiscard]] std::string summary_json(const RunFacts& run, const SummaryOfOutputs& outputs = {});

/// The same for people: a few lines of text.
[[nodiscard]] std::string summary_text(const RunFacts& run);

}  // namespace kerf::output
