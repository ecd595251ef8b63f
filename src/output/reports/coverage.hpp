#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/output_file.hpp"
#include "base/source_file.hpp"
#include "control/core/assumptions.hpp"

namespace kerf::output {

/// How often each source line ran. Lines that hold no block are left out.
class Coverage {
 public:
  void count(base::FileId file, std::uint32_t line);

  /// CSV with the columns file,line,count,source,assumed: every line of every file that ran in
  /// part, numbered as diagnostics number them.
  void write_csv(const base::SourceSet& sources, const std::vector<control::Assumption>& assumed,
                 base::OutputFile& into) const;

 private:
  void write_file(const base::SourceSet& sources, base::FileId file,
                  const std::vector<control::Assumption>& assumed, base::OutputFile& into) const;

  std::map<base::FileId, std::vector<std::uint64_t>> counts_;
};

}  // namespace kerf::output
