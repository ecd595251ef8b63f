#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "features/rewrite/clearing.hpp"
#include "features/rewrite/loop_rows.hpp"
#include "features/rewrite/ruling.hpp"
#include "features/tree/feature.hpp"

namespace kerf::features {

/// One of the parallel lines that a layer was cleared in.
struct OldPass {
  Span rows{};
  Vec2 from{};
  Vec2 to{};
  double line = 0;  ///< of the ruling
  bool is_forwards = true;
};

/// A layer that was cleared in parallel lines, and perhaps in rounds along its walls before or
/// behind them.
struct OldLines {
  Ruling ruling{};  ///< the first pass goes along it, the second one lies farther across
  std::vector<OldPass> passes{};
  std::vector<double> lines{};  ///< where there are passes, ascending
  double step = 0;              ///< from line to line: the median
  double distance = 0;          ///< of the passes from the walls
  std::vector<OldLoop> rounds_before{};
  std::vector<OldLoop> rounds_behind{};
  bool follows_walls = false;      ///< from pass to pass
  bool has_sharp_corners = false;  ///< of the rounds, about what stands
  /// How far what stays between the ends of passes reaches from the walls; 0: rounds take it away.
  double scallop = 0;

  [[nodiscard]] bool is_one_way() const;
  /// The rows between a pass and the next one; none: they are one behind the other.
  [[nodiscard]] std::vector<std::uint32_t> between(std::size_t pass) const;
};

/// Reads the rows of a visit. `clearing`: of the old contours. Or why it cannot be told how they
/// were made: a sentence.
[[nodiscard]] tl::expected<OldLines, std::string> old_lines(const Recording& recording,
                                                            const Layer& layer, Span visit,
                                                            const Clearing& clearing);

}  // namespace kerf::features
