#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/source_file.hpp"
#include "control/assumptions.hpp"

namespace kerf::output {

/// How often each source line ran. Lines that hold no block are left out.
class Coverage {
 public:
  void count(base::FileId file, std::uint32_t line);

  /// CSV with the columns file,line,count,source,assumed: every line of every file that ran in
  /// part.
  [[nodiscard]] std::string csv(const base::SourceSet& sources,
                                const std::vector<control::Assumption>& assumed) const;

 private:
  std::map<base::FileId, std::vector<std::uint64_t>> counts_;
};

}  // namespace kerf::output
