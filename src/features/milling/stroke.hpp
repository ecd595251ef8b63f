#pragma once

#include <optional>
#include <vector>

#include "features/path/operation.hpp"
#include "features/path/recording.hpp"

namespace kerf::features {

/// Rows that move across at one z, one after the other.
struct LevelRun {
  double z = 0;
  Span rows{};
  std::vector<Span> entries{};  ///< rows at feed before and behind it that are its own
  Span visit{};                 ///< with the rapids that are its own
  bool is_entered_by_rapid = false;
};

/// Rows straight down and up at one place.
struct PlungeRun {
  Vec2 at{};
  double top = 0;     ///< where the first row begins
  double bottom = 0;  ///< deepest end
  Span rows{};
  Span visit{};
};

/// A helix down that ends in nothing.
struct HelixRun {
  Vec2 centre{};
  double radius = 0;
  double pitch = 0;  ///< mm a turn
  double top = 0;
  double bottom = 0;
  Span rows{};
  Span visit{};
};

/// Rows that are none of these.
struct FreeRun {
  Span rows{};
  Span visit{};
};

/// What the rows of an operation are, each kind in the order of the rows. Every row that cuts is in
/// exactly one of them.
struct Strokes {
  std::vector<LevelRun> levels;
  std::vector<PlungeRun> plunges;
  std::vector<HelixRun> helices;
  std::vector<FreeRun> frees;
  double level_mm = 0;
  double sloping_mm = 0;  ///< that lead into no level
};

/// `top`: above it there is nothing to cut.
[[nodiscard]] Strokes strokes_of(const Recording& recording, const Operation& operation,
                                 double top);

/// The helix that rows are, all of them: arcs about one centre that go down.
[[nodiscard]] std::optional<HelixRun> helix_of(const Recording& recording, Span rows);

}  // namespace kerf::features
