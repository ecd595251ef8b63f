#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/block_id.hpp"
#include "base/interface.hpp"

namespace kerf::features {

/// Lines of a file, from the first to the last one.
struct LineSpan {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};

/// What the text of a block says beyond its motions.
struct BlockFacts {
  bool has_expression = false;      ///< a number of it is a variable or an expression
  bool is_skipped_at_will = false;  ///< begins with a slash
  std::uint16_t shape_cycle = 0;    ///< 70 to 73 of a lathe, whose shape is other blocks; 0: none
  LineSpan shape{};                 ///< lines of that shape
};

/// An argument of a call, as its block has it.
struct Argument {
  std::string letter{};
  std::uint32_t variable = 0;  ///< that it becomes: 18 of R; 0: none
  std::optional<double> value{};
  std::string text{};
  bool literal = true;  ///< else a variable or an expression
  std::uint32_t column = 0;
  /// What it reaches of what is machined: position, contour, depth, feed, count, or nothing; none:
  /// nobody has tried.
  std::optional<std::vector<std::string>> affects{};
};

/// What a block calls.
struct CallWords {
  std::string code{};     ///< "G65"
  std::string program{};  ///< "O9100"
  std::vector<Argument> arguments{};
  std::uint32_t repeats = 1;
};

/// Reads blocks for a room that knows no language.
class BlockReader : public base::Interface {
 public:
  [[nodiscard]] virtual BlockFacts facts(const base::BlockId& block) = 0;
  /// Whether it also chooses a tool, a spindle, a length, a work system or a mode.
  [[nodiscard]] virtual bool sets_up(const base::BlockId& block) = 0;
  /// The blocks whose calls led to one, the main program's first.
  [[nodiscard]] virtual std::vector<base::BlockId> calls(const base::BlockId& block) = 0;
  [[nodiscard]] virtual CallWords call_of(const base::BlockId& block) = 0;
  /// The lines of the innermost loop of a file around all of these.
  [[nodiscard]] virtual std::optional<LineSpan> loop_round(base::FileId file, LineSpan lines) = 0;
};

}  // namespace kerf::features
