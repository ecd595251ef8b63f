#pragma once

#include <optional>

#include "motion/motion.hpp"
#include "output/programs/internal/move_blocks.hpp"

namespace kerf::output {

/// Writes moves on the face and on the mantle of a part, from G12.1 to G13.1 and from G7.1 with the
/// radius to G7.1 C0. In the plane of a face C counts mm.
class SurfaceBlocks {
 public:
  /// Both must outlive this.
  SurfaceBlocks(MoveBlocks& moves, PostBody& body) : moves_(moves), body_(body) {}

  /// Whether the posted program can say it: a face whose centre is its X0, with C counted from
  /// where the axis stands.
  [[nodiscard]] bool can_say(const motion::SurfaceMove& move) const;
  /// Precondition: it can be said. The posted program stands where the move begins.
  void write(const motion::SurfaceMove& move);
  /// Before all that is no such move.
  void leave();

 private:
  void enter(const motion::SurfaceMove& move);
  void place(const motion::SurfaceMove& move, BlockText& block) const;
  void round(const motion::SurfaceMove& move, BlockText& block) const;

  MoveBlocks& moves_;
  PostBody& body_;
  std::optional<motion::Surface> surface_;
};

}  // namespace kerf::output
