#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/vec2.hpp"

namespace kerf::control {

/// The block of a move that belongs to none of the shape's: the cycle's own.
inline constexpr std::uint32_t kCycleBlock = 0xFFFFFFFF;

/// One move of a cycle, as the tool makes it. u along Z, v along X as a radius, mm.
struct TurningMove {
  enum class Kind : std::uint8_t { rapid, feed, thread };

  Kind kind = Kind::rapid;
  bool is_arc = false;  ///< feed only; never from a point to itself unless the shape's own circle
  bool clockwise = false;  ///< in (Z, X), as G02
  geometry::Vec2 to{};
  geometry::Vec2 centre{};
  bool has_nose = false;  ///< straight only; the radius of the nose is compensated, if commanded
  std::uint32_t block = kCycleBlock;  ///< ShapePiece::block, or kCycleBlock
};

/// A cycle of turning, one move after the other. The first begins at the start of the shape, the
/// last ends there. Straight moves without length are among them. Holds the shape and an index to
/// it, never the moves of more than one pass.
class TurningPasses {
 public:
  TurningPasses() = default;
  TurningPasses(const TurningPasses&) = delete;
  TurningPasses& operator=(const TurningPasses&) = delete;
  virtual ~TurningPasses() = default;

  /// The next move. False: the cycle is over, `move` is as it was.
  [[nodiscard]] bool next(TurningMove& move);
  /// How many passes have begun, without the one of G71 and G72 along the whole shape.
  [[nodiscard]] std::uint64_t passes() const { return passes_; }

 protected:
  void count_pass() { ++passes_; }
  void add(const TurningMove& move) { ahead_.push_back(move); }

 private:
  /// Adds some more moves, or none. False: there are no more.
  virtual bool advance() = 0;

  std::vector<TurningMove> ahead_;
  std::size_t taken_ = 0;  // of them
  std::uint64_t passes_ = 0;
};

/// Moves that are known beforehand.
class ListedMoves : public TurningPasses {
 public:
  explicit ListedMoves(const std::vector<TurningMove>& moves) {
    for (const TurningMove& move : moves) add(move);
  }

 private:
  bool advance() override { return false; }
};

}  // namespace kerf::control
