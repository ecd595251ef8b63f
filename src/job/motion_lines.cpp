#include "job/motion_lines.hpp"

#include <algorithm>
#include <memory>
#include <numeric>
#include <tuple>

#include "base/text_window.hpp"

namespace kerf::job {

using base::BlockId;

void MotionLines::add(const BlockId& block) {
  const bool goes_on = !spans_.empty() && spans_.back().file == block.file &&
                       spans_.back().program == block.program && spans_.back().calls == block.calls;
  if (!goes_on) {
    spans_.push_back(
        {static_cast<std::uint32_t>(lines_.size()), block.file, block.program, block.calls});
  }
  lines_.push_back(block.line);
}

BlockId MotionLines::block(std::uint64_t motion) const {
  if (motion == 0 || motion > lines_.size()) return {};
  const auto place = static_cast<std::uint32_t>(motion - 1);
  const auto after =
      std::upper_bound(spans_.begin(), spans_.end(), place,
                       [](std::uint32_t at, const Span& span) { return at < span.first; });
  const Span& span = *(after - 1);
  BlockId block;
  block.program = span.program;
  block.file = span.file;
  block.line = lines_[place];
  block.calls = span.calls;
  return block;
}

std::size_t MotionLines::bytes() const {
  return lines_.size() * sizeof(std::uint32_t) + spans_.size() * sizeof(Span);
}

namespace {

/// Goes through a file once, from one line to a later one.
class LineWalk {
 public:
  LineWalk(const base::SourceFile& file, base::FileId id) {
    window_.stand_at(file, id, 0, file.size());
  }

  /// Where a line begins, not before the last one that was asked for; of a file that is shorter
  /// its last line.
  [[nodiscard]] std::uint64_t start_of(std::uint32_t line) {
    for (; number_ < line && window_.next(line_); ++number_) {
    }
    return line_.offset;
  }

 private:
  base::TextWindow window_;
  base::TextWindow::Line line_;
  std::uint32_t number_ = 0;  // of the line
};

}  // namespace

void find_line_starts(const base::SourceSet& sources, std::vector<BlockId>& blocks) {
  std::vector<std::size_t> order(blocks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tuple(blocks[a].file, blocks[a].line, a) <
           std::tuple(blocks[b].file, blocks[b].line, b);
  });
  std::unique_ptr<LineWalk> walk;
  base::FileId file = base::kNoFile;
  for (const std::size_t i : order) {
    BlockId& block = blocks[i];
    if (block.line == 0 || !sources.contains(block.file)) continue;
    if (!walk || file != block.file)
      walk = std::make_unique<LineWalk>(sources[block.file], block.file);
    file = block.file;
    block.from = walk->start_of(block.line);
  }
}

}  // namespace kerf::job
