#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/helper.hpp"
#include "base/interface.hpp"
#include "stock/sweep/ball_way.hpp"
#include "stock/sweep/body.hpp"
#include "stock/sweep/outcome.hpp"
#include "stock/sweep/piece.hpp"
#include "stock/sweep/stretch.hpp"
#include "stock/sweep/sweep.hpp"

namespace kerf::stock {

/// Material that tools cut, in the frame of the stock: mm, X Y Z, right-handed.
///
/// The same sweeps in the same order leave the same bits and the same outcomes, however they are
/// cut into calls and however many threads share the work.
class Model : public base::Interface {
 public:
  /// Makes a tool known; the number for Sweep::body. Bodies stay.
  [[nodiscard]] virtual BodyId add_body(const Body& body) = 0;
  /// Whether it can cut this sweep: a height field cannot cut with a tilted tool, or an undercut.
  [[nodiscard]] virtual bool can_cut(const Sweep& sweep) const = 0;
  /// Cuts them in their order; adds what sweep i did to outcomes[i]. Precondition: can_cut() each;
  /// both spans have the same size.
  virtual void cut(std::span<const Sweep> sweeps, std::span<Outcome> outcomes) = 0;
  /// cut() leaves parts of its work to this one, until it is told nullptr: nobody waits.
  virtual void use(base::Helper* helper);

  /// Where a probe stops (stock.md §5, G31): the first t in [0, 1] at which its ball touches
  /// material, 0 where it begins in it; nullopt: nowhere. What it leaves does not stop it
  /// (kLeft_mm). Cuts nothing.
  [[nodiscard]] virtual std::optional<double> first_touch(const BallWay& ball) const = 0;

  /// From where to where there is material along a line, all pieces of it together, in [0, 1] of
  /// its way; empty: there is none, or the model cannot tell along such a line.
  [[nodiscard]] virtual Stretch material_on(const StraightWay& line) const;

  /// mm³ of what is left, and of what there was before the first cut.
  [[nodiscard]] virtual double left_mm3() const = 0;
  [[nodiscard]] virtual double stock_mm3() const = 0;
  /// Bound of the error of their difference (stock.md §3, Volumes).
  [[nodiscard]] virtual double error_mm3() const = 0;
  /// Of what is left; low > high: nothing is.
  [[nodiscard]] virtual Bounds extents() const = 0;
  /// What of it hangs together, the largest first. A model that cannot tell has it all for one.
  [[nodiscard]] virtual std::vector<Piece> pieces() const;
  /// Size of its cells across Z, mm: how much it cannot tell. 0: it is exact.
  [[nodiscard]] virtual double grain_mm() const { return 0; }
  /// What it holds now.
  [[nodiscard]] virtual std::size_t bytes() const = 0;
};

}  // namespace kerf::stock
