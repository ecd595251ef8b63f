#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "stock/dexel/octahedral.hpp"

namespace kerf::stock::dexel {

/// Where material begins or ends along a dexel.
struct DexelEnd {
  float at = 0;              ///< mm from the middle of the stock's box
  Octahedral normal{};       ///< away from the material
  std::uint16_t spare = 0;   ///< 0, but while a tile is worked at
  std::uint32_t motion = 0;  ///< that cut it; 0: it was the stock's

  friend constexpr bool operator==(const DexelEnd&, const DexelEnd&) = default;
};
static_assert(sizeof(DexelEnd) == 12);

/// A square of dexels: sorted lists of ends, two an interval, in one pool. Lists grow by doubling
/// and give their old place to others, so that cutting needs no memory in the long run. Blocks of
/// 4 x 4 dexels know in which 64ths of their length there is material at all.
class Tile {
 public:
  static constexpr double kLeast_mm = 1e-5;  ///< of material; what is shorter is dropped
  static constexpr int kBlock = 4;
  static constexpr std::uint8_t kCutsUnseen = 4;
  static constexpr std::size_t kMostEnds = 1U << 14;  ///< of a dexel

  /// Of a dexel.
  struct Stretch {
    float low;
    float high;
  };

  Tile() = default;
  /// Empty dexels; `half_mm` of their length.
  Tile(int columns, int rows, double half_mm);

  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row * columns_ + column);
  }
  [[nodiscard]] std::size_t count() const { return dexels_.size(); }
  [[nodiscard]] std::span<const DexelEnd> ends(std::size_t dexel) const {
    return {ends_.data() + dexels_[dexel].begin, dexels_[dexel].count};
  }
  /// Whether a place lies between two ends.
  [[nodiscard]] bool holds(std::size_t dexel, float place) const {
    return has_piece(dexel, place, place,
                     [&](double low, double high) { return low < place && place < high; });
  }
  /// act(end, number of the end) may change all but its place.
  template <class Act>
  void each_end(std::size_t dexel, Act&& act) {
    const Dexel& d = dexels_[dexel];
    for (std::size_t i = 0; i < d.count; ++i) act(ends_[d.begin + i], i);
  }
  /// Replaces what is there. Precondition: even number, sorted.
  void fill(std::size_t dexel, std::span<const DexelEnd> ends);

  /// mm of material between two places.
  [[nodiscard]] double overlap(std::size_t dexel, float low, float high) const;
  /// Whether is_one(low, high) holds for any interval that reaches into a stretch.
  template <class IsOne>
  [[nodiscard]] bool has_piece(std::size_t dexel, float low, float high, IsOne&& is_one) const {
    const DexelEnd* end = ends_.data() + dexels_[dexel].begin;
    const DexelEnd* const after = end + dexels_[dexel].count;
    end += first_above(dexels_[dexel], low);
    for (; end != after && end->at <= high; end += 2) {
      if (is_one(double{end[0].at}, double{end[1].at})) return true;
    }
    return false;
  }
  /// First and last place of material between two places; low > high: there is none.
  [[nodiscard]] Stretch touched_span(std::size_t dexel, float low, float high) const;
  /// Takes away what is between low and high, but for pieces that reach less than kLeast_mm into
  /// it, whatever else it takes; the length.
  /// `low_end` and `high_end` say what the tool's lower and upper surface leave: normal and motion.
  /// A dexel that has kMostEnds stays in one piece: it loses its shorter remainder.
  template <class LowEnd, class HighEnd>
  double subtract(std::size_t dexel, float low, float high, LowEnd&& low_end, HighEnd&& high_end);

  /// 64ths of the length that a piece of it touches.
  [[nodiscard]] std::uint64_t parts(double low, double high) const;
  /// From the first to the last of these parts, at least one.
  [[nodiscard]] Stretch stretch(std::uint64_t parts) const;
  [[nodiscard]] std::uint64_t block_parts(int column, int row) const {
    return blocks_[block_of(column, row)];
  }
  /// Blocks know anew what they have. After fill(), and after cuts; it may wait.
  void refresh_block(int column, int row);
  /// A dexel of a block was cut: every few times the block looks what it has left.
  void note_cut(int column, int row) {
    ++changes_;
    if (++cuts_[block_of(column, row)] % kCutsUnseen == 0) refresh_block(column, row);
  }
  void refresh();

  [[nodiscard]] std::uint32_t changes() const { return changes_; }
  void mark_changed() { ++changes_; }
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Dexel {
    std::uint32_t begin = 0;
    std::uint16_t count = 0;
    std::uint16_t room = 0;  // a power of two, or 0
  };
  struct Piece {
    std::size_t first;
    std::size_t after;
    double removed;
  };
  static constexpr std::size_t kFew = 16;  // ends that are quicker passed than searched
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  [[nodiscard]] std::size_t block_of(int column, int row) const {
    return static_cast<std::size_t>((row / kBlock) * blocks_across_ + column / kBlock);
  }
  /// Number of the first end of the first interval that reaches above a place.
  [[nodiscard]] std::size_t first_above(const Dexel& dexel, float low) const {
    const DexelEnd* ends = ends_.data() + dexel.begin;
    std::size_t first = 0;
    if (dexel.count > kFew) {
      const DexelEnd* above = std::upper_bound(
          ends, ends + dexel.count, low, [](float at, const DexelEnd& end) { return at < end.at; });
      first = static_cast<std::size_t>(above - ends) & ~std::size_t{1};
    }
    while (first < dexel.count && ends[first + 1].at <= low) first += 2;
    return first;
  }
  [[nodiscard]] Piece touched(const Dexel& dexel, float low, float high) const;
  /// Makes room for `size` ends; those that are there stay.
  void reserve(Dexel& dexel, std::size_t size);
  [[nodiscard]] std::uint32_t take(std::size_t power);
  void replace(Dexel& dexel, std::size_t first, std::size_t after, std::span<const DexelEnd> with);

  int columns_ = 0;
  int rows_ = 0;
  int blocks_across_ = 0;
  double half_ = 0;
  double scale_ = 0;
  std::uint32_t changes_ = 0;
  std::vector<Dexel> dexels_;
  std::vector<DexelEnd> ends_;
  std::vector<std::uint64_t> blocks_;
  std::vector<std::uint8_t> cuts_;  // of blocks
  std::array<std::uint32_t, 16> free_{};
};

template <class LowEnd, class HighEnd>
double Tile::subtract(std::size_t dexel, float low, float high, LowEnd&& low_end,
                      HighEnd&& high_end) {
  Dexel& d = dexels_[dexel];
  Piece piece = touched(d, low, high);
  if (piece.removed < kLeast_mm) return 0;
  const DexelEnd begin = ends_[d.begin + piece.first];
  const DexelEnd end = ends_[d.begin + piece.after - 1];
  double below = double{low} - double{begin.at};
  double above = double{end.at} - double{high};
  const bool is_full = d.count >= kMostEnds && below >= kLeast_mm && above >= kLeast_mm;
  if (is_full) (below < above ? below : above) *= -1;
  std::array<DexelEnd, 4> left;
  std::size_t count = 0;
  if (below >= kLeast_mm) {
    left[count++] = begin;
    left[count++] = low_end(low);
  }
  if (above >= kLeast_mm) {
    left[count++] = high_end(high);
    left[count++] = end;
  }
  if (below > 0 && below < kLeast_mm) piece.removed += below;
  if (above > 0 && above < kLeast_mm) piece.removed += above;
  if (is_full) piece.removed -= std::min(below, above);
  replace(d, piece.first, piece.after, {left.data(), count});
  return piece.removed;
}

}  // namespace kerf::stock::dexel
