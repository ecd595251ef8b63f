#pragma once

#include <cstdint>
#include <vector>

#include "job/stock_job.hpp"
#include "stock/cutting/judge.hpp"
#include "stock/cutting/motion_cut.hpp"
#include "stock/sweep/model.hpp"

namespace kerf::job {

/// The pieces of a part (stock.md §4.8). One is held where the model says so, or where its box
/// touches that of a fixture.
[[nodiscard]] std::vector<stock::Piece> pieces_of(const stock::Model& model, const StockJob& job);

/// Finds moves that cut a piece behind its coming loose (STOCK_LOOSE): of the pieces that a first
/// pass has left loose it asks, in a second pass, at the motions that cut them, which were loose by
/// then. A loose piece that was cut away altogether, and one of less than 64 cells, are not seen.
class LoosePieces final : public stock::TimedCutSink {
 public:
  /// Of this first pass: the motions behind which look() is to be called in a second one, rising,
  /// not more than 64. None: nothing came loose.
  [[nodiscard]] static std::vector<std::uint64_t> looks_for(const std::vector<stock::Piece>& left,
                                                            double grain_mm);

  /// The pieces as they are behind a motion.
  void look(std::uint64_t motion, const base::BlockId& block, std::uint32_t tool,
            const std::vector<stock::Piece>& pieces);
  /// When that motion ends.
  void take(const stock::TimedCut& cut) override;
  /// Tells what was cut; `left`: the pieces at the end.
  void tell(const std::vector<stock::Piece>& left, double grain_mm, stock::Judge& judge) const;

 private:
  struct Look {
    std::uint64_t motion;
    base::BlockId block;
    std::uint32_t tool;
    double time_s;
    std::vector<stock::Bounds> loose;
  };
  [[nodiscard]] bool was_loose(const Look& look, const stock::Piece& piece, double grain_mm) const;

  std::vector<Look> looks_;
};

}  // namespace kerf::job
