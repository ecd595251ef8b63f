#pragma once

#include <string>

#include "base/output_file.hpp"
#include "base/result.hpp"
#include "base/source_file.hpp"
#include "job/stock_run.hpp"
#include "output/reports/stock_facts.hpp"
#include "stock/saved/part_file.hpp"

namespace kerf::job {

/// The part in a .kstock; SavedPart::model() makes the model that it was cut in again. Failure
/// (input): a sentence with the name of the file.
[[nodiscard]] base::Outcome<stock::saved::ReadPart> read_part(const std::string& path,
                                                              std::size_t most_bytes);
/// The same of a file that is open.
[[nodiscard]] base::Outcome<stock::saved::ReadPart> part_in(const base::SourceFile& file,
                                                            std::size_t most_bytes);
/// Whether a file says of itself that it is one.
[[nodiscard]] bool is_part(const base::SourceFile& file);

/// Writes what a run has left, for the next one. Failure (output): nothing is left.
[[nodiscard]] base::Outcome<void> save_part(const StockJob& job, const StockResult& result,
                                            const output::StockFacts& facts,
                                            base::OutputFile& into);

}  // namespace kerf::job
