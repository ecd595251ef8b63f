#include "stock/dexel/tile.hpp"

#include <bit>
#include <cmath>

namespace kerf::stock::dexel {

Tile::Tile(int columns, int rows, double half_mm)
    : columns_(columns),
      rows_(rows),
      blocks_across_((columns + kBlock - 1) / kBlock),
      half_(half_mm),
      scale_(32 / half_mm),
      dexels_(static_cast<std::size_t>(columns * rows)),
      blocks_(static_cast<std::size_t>(blocks_across_ * ((rows + kBlock - 1) / kBlock))) {
  cuts_.resize(blocks_.size());
  free_.fill(kNone);
}

std::uint32_t Tile::take(std::size_t power) {
  const std::uint32_t freed = free_[power];
  if (freed != kNone) {
    free_[power] = ends_[freed].motion;
    return freed;
  }
  const std::size_t begin = ends_.size();
  ends_.resize(begin + (std::size_t{1} << power));
  return static_cast<std::uint32_t>(begin);
}

void Tile::reserve(Dexel& dexel, std::size_t size) {
  if (size <= dexel.room) return;
  const std::size_t room = std::bit_ceil(size);
  const std::uint32_t begin = take(static_cast<std::size_t>(std::countr_zero(room)));
  std::copy_n(ends_.begin() + dexel.begin, dexel.count, ends_.begin() + begin);
  if (dexel.room > 0) {
    const auto power = static_cast<std::size_t>(std::countr_zero(dexel.room));
    ends_[dexel.begin].motion = free_[power];
    free_[power] = dexel.begin;
  }
  dexel.begin = begin;
  dexel.room = static_cast<std::uint16_t>(room);
}

void Tile::replace(Dexel& dexel, std::size_t first, std::size_t after,
                   std::span<const DexelEnd> with) {
  const std::size_t behind = dexel.count - after;
  reserve(dexel, first + with.size() + behind);
  DexelEnd* ends = ends_.data() + dexel.begin;
  if (behind > 0 && first + with.size() < after) {
    std::copy_n(ends + after, behind, ends + first + with.size());
  } else if (behind > 0) {
    std::copy_backward(ends + after, ends + dexel.count, ends + first + with.size() + behind);
  }
  std::copy(with.begin(), with.end(), ends + first);
  dexel.count = static_cast<std::uint16_t>(first + with.size() + behind);
}

void Tile::fill(std::size_t dexel, std::span<const DexelEnd> ends) {
  Dexel& d = dexels_[dexel];
  const std::size_t size = std::min(ends.size(), kMostEnds);
  d.count = 0;
  reserve(d, size);
  std::copy_n(ends.begin(), size, ends_.begin() + d.begin);
  d.count = static_cast<std::uint16_t>(size);
}

Tile::Piece Tile::touched(const Dexel& dexel, float low, float high) const {
  const DexelEnd* ends = ends_.data() + dexel.begin;
  const double least_low = double{low} + kLeast_mm;
  const double most_high = double{high} - kLeast_mm;
  std::size_t first = first_above(dexel, low);
  if (first < dexel.count && double{ends[first + 1].at} < least_low) first += 2;
  Piece piece{first, first, 0};
  for (; piece.after < dexel.count && double{ends[piece.after].at} <= most_high; piece.after += 2) {
    piece.removed += double{std::min(ends[piece.after + 1].at, high)} -
                     double{std::max(ends[piece.after].at, low)};
  }
  return piece;
}

double Tile::overlap(std::size_t dexel, float low, float high) const {
  return touched(dexels_[dexel], low, high).removed;
}

Tile::Stretch Tile::touched_span(std::size_t dexel, float low, float high) const {
  const Piece piece = touched(dexels_[dexel], low, high);
  if (piece.first == piece.after) return {1, -1};
  const auto list = ends(dexel);
  return {std::max(list[piece.first].at, low), std::min(list[piece.after - 1].at, high)};
}

std::uint64_t Tile::parts(double low, double high) const {
  const int from = static_cast<int>(std::clamp((low + half_) * scale_, 0.0, 63.0));
  const int to = static_cast<int>(std::clamp((high + half_) * scale_, 0.0, 63.0));
  return to < from ? 0 : (~std::uint64_t{0} >> (63 - to)) & (~std::uint64_t{0} << from);
}

Tile::Stretch Tile::stretch(std::uint64_t parts) const {
  const double low = static_cast<double>(std::countr_zero(parts)) / scale_ - half_;
  const double high = static_cast<double>(64 - std::countl_zero(parts)) / scale_ - half_;
  return {static_cast<float>(low), static_cast<float>(high)};
}

void Tile::refresh_block(int column, int row) {
  const int c0 = column / kBlock * kBlock;
  const int r0 = row / kBlock * kBlock;
  std::uint64_t parts = 0;
  for (int r = r0; r < std::min(r0 + kBlock, rows_); ++r) {
    for (int c = c0; c < std::min(c0 + kBlock, columns_); ++c) {
      const auto list = ends(index(c, r));
      for (std::size_t i = 0; i < list.size(); i += 2) {
        parts |= this->parts(double{list[i].at}, double{list[i + 1].at});
      }
    }
  }
  blocks_[block_of(column, row)] = parts;
}

void Tile::refresh() {
  for (int row = 0; row < rows_; row += kBlock) {
    for (int column = 0; column < columns_; column += kBlock) refresh_block(column, row);
  }
}

std::size_t Tile::bytes() const {
  return sizeof(*this) + dexels_.capacity() * sizeof(Dexel) + ends_.capacity() * sizeof(DexelEnd) +
         blocks_.capacity() * sizeof(std::uint64_t);
}

}  // namespace kerf::stock::dexel
