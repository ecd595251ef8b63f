#include "geometry/contour/internal/piece_tree.hpp"

namespace kerf::contour {
namespace {

std::vector<Box> boxes_of(std::span<const Piece> pieces) {
  std::vector<Box> boxes;
  boxes.reserve(pieces.size());
  for (const Piece& piece : pieces) boxes.push_back(piece.box());
  return boxes;
}

}  // namespace

PieceTree::PieceTree(std::span<const Piece> pieces) : pieces_(pieces), tree_(boxes_of(pieces)) {
  strips_.resize(tree_.level_count());
  std::size_t width = 1;
  for (std::size_t level = 1; level < tree_.level_count(); ++level) {
    width *= BoxTree::kFan;
    for (std::size_t begin = 0; begin < pieces.size(); begin += width) {
      strips_[level].push_back(strip_of(begin, std::min(begin + width, pieces.size())));
    }
  }
}

PieceTree::Strip PieceTree::strip_of(std::size_t begin, std::size_t end) const {
  const auto order = tree_.order();
  const Piece* longest = &pieces_[order[begin]];
  for (std::size_t i = begin; i < end; ++i) {
    if (pieces_[order[i]].chord > longest->chord) longest = &pieces_[order[i]];
  }
  Strip strip{geometry::left_of(longest->direction), std::numeric_limits<double>::infinity(),
              -std::numeric_limits<double>::infinity()};
  for (std::size_t i = begin; i < end; ++i) {
    const Piece& piece = pieces_[order[i]];
    const double from = dot(strip.across, piece.from);
    const double to = dot(strip.across, piece.to);
    const double reach = std::fabs(piece.apex());
    strip.low = std::min(strip.low, std::min(from, to) - reach);
    strip.high = std::max(strip.high, std::max(from, to) + reach);
  }
  return strip;
}

}  // namespace kerf::contour
