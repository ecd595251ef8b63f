#pragma once

#include <cstdint>
#include <vector>

#include "base/block_id.hpp"
#include "base/interface.hpp"

namespace kerf::features {

/// What the text of a block says beyond its motions. Places in lines of its own file, 0: none.
struct BlockFacts {
  bool sets_up = false;         ///< T, S, M, a length, a work system, a mode: no part of a cut
  bool has_expression = false;  ///< a number of it is a variable or an expression
  bool has_axis_word = false;
  bool is_skipped_at_will = false;  ///< begins with a slash
  bool shares_line = false;         ///< it is not the only block of its line
  std::uint32_t loop_first = 0;     ///< of the innermost loop around it: WHILE to END
  std::uint32_t loop_last = 0;
};

/// Reads blocks for a room that knows no language.
class BlockReader : public base::Interface {
 public:
  [[nodiscard]] virtual const BlockFacts& facts(const base::BlockId& block) = 0;
  /// The blocks whose calls led to one, the main program's first.
  [[nodiscard]] virtual std::vector<base::BlockId> calls(const base::BlockId& block) = 0;
};

}  // namespace kerf::features
