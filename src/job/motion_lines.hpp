#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "base/block_id.hpp"
#include "base/source_file.hpp"

namespace kerf::job {

/// Which line of which program each motion of a run came from: 4 bytes a motion, and 16 more where
/// the file, the program or the calls that led there change.
class MotionLines {
 public:
  /// Of the next motion; the first one is number 1.
  void add(const base::BlockId& block);

  /// Its line, file, program and calls; where on the line it begins is not kept. No block: there
  /// was no such motion.
  [[nodiscard]] base::BlockId block(std::uint64_t motion) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Span {
    std::uint32_t first = 0;  // place of its first motion in lines_
    base::FileId file = base::kNoFile;
    base::ProgramNumber program{};
    base::CallPath calls{};
  };

  std::deque<std::uint32_t> lines_;
  std::vector<Span> spans_;
};

/// Fills in where the lines of these blocks begin. Each file is read once, up to its last line that
/// is asked for.
void find_line_starts(const base::SourceSet& sources, std::vector<base::BlockId>& blocks);

}  // namespace kerf::job
