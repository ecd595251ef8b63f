#include "job/internal/loose_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace kerf::job {
namespace {

using stock::Bounds;
using stock::Piece;

constexpr double kLeastCells = 64;
constexpr std::size_t kMostLooks = 64;

bool is_loose(const Piece& piece, double grain_mm) {
  return !piece.held && piece.volume_mm3 >= kLeastCells * grain_mm * grain_mm * grain_mm;
}

bool touch(const Bounds& a, const Bounds& b, double within) {
  return a.low.x <= b.high.x + within && b.low.x <= a.high.x + within &&
         a.low.y <= b.high.y + within && b.low.y <= a.high.y + within &&
         a.low.z <= b.high.z + within && b.low.z <= a.high.z + within;
}

bool contains(const Bounds& outer, const Bounds& inner, double within) {
  return inner.low.x >= outer.low.x - within && inner.high.x <= outer.high.x + within &&
         inner.low.y >= outer.low.y - within && inner.high.y <= outer.high.y + within &&
         inner.low.z >= outer.low.z - within && inner.high.z <= outer.high.z + within;
}

}  // namespace

std::vector<Piece> pieces_of(const stock::Model& model, const StockJob& job) {
  std::vector<Piece> pieces = model.pieces();
  constexpr double kLeastTouch_mm = 1e-3;
  const double within = std::max(model.grain_mm(), kLeastTouch_mm);
  for (Piece& piece : pieces) {
    for (const StockJob::NamedShape& fixture : job.fixtures)
      piece.held = piece.held || touch(piece.extents, stock::bounds(fixture.shape), within);
  }
  return pieces;
}

std::vector<std::uint64_t> LoosePieces::looks_for(const std::vector<Piece>& left, double grain_mm) {
  std::vector<std::uint64_t> motions;
  for (const Piece& piece : left) {
    if (is_loose(piece, grain_mm))
      motions.insert(motions.end(), piece.cut_by.begin(), piece.cut_by.end());
  }
  std::sort(motions.begin(), motions.end());
  motions.erase(std::unique(motions.begin(), motions.end()), motions.end());
  if (motions.size() <= kMostLooks) return motions;
  std::vector<std::uint64_t> some;
  for (std::size_t i = 1; i <= kMostLooks; ++i)
    some.push_back(motions[i * motions.size() / kMostLooks - 1]);
  return some;
}

void LoosePieces::look(std::uint64_t motion, const base::BlockId& block, std::uint32_t tool,
                       const std::vector<Piece>& pieces) {
  Look look{motion, block, tool, 0, {}};
  for (const Piece& piece : pieces) {
    if (!piece.held) look.loose.push_back(piece.extents);
  }
  looks_.push_back(std::move(look));
}

void LoosePieces::take(const stock::TimedCut& cut) {
  for (Look& look : looks_) {
    if (look.motion == cut.cut.motion) look.time_s = cut.end_s;
  }
}

bool LoosePieces::was_loose(const Look& look, const Piece& piece, double grain_mm) const {
  return std::any_of(look.loose.begin(), look.loose.end(), [&](const Bounds& loose) {
    return contains(loose, piece.extents, grain_mm / 2 + 1e-6);
  });
}

void LoosePieces::tell(const std::vector<Piece>& left, double grain_mm, stock::Judge& judge) const {
  for (const Piece& piece : left) {
    if (!is_loose(piece, grain_mm)) continue;
    bool is_off = false;
    for (const Look& look : looks_) {
      const bool cuts = std::binary_search(piece.cut_by.begin(), piece.cut_by.end(),
                                           static_cast<std::uint32_t>(look.motion));
      if (is_off && cuts) {
        judge.add({.code = base::Code::stock_loose,
                   .detail = fmt::format("T{} cuts a piece of {:.1f} mm³ that hangs on nothing",
                                         look.tool, piece.volume_mm3),
                   .block = look.block,
                   .tool = look.tool,
                   .motion = look.motion,
                   .at = 0.5 * (piece.extents.low + piece.extents.high),
                   .time_s = look.time_s});
      }
      is_off = is_off || was_loose(look, piece, grain_mm);
    }
  }
}

}  // namespace kerf::job
