#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "machine/definition/drive_settings.hpp"
#include "output/picture/internal/cut_measure.hpp"

namespace kerf::output::plot {

/// What a laser leaves on each millimetre, J/mm: its power by the speed that the tip really has
/// (docs/drives.md, The laser).
///
/// At a place it is the energy of the last way of a spot's diameter by that way: the spot blurs
/// what is shorter, and a beam that rests has energy per spot, not without bound. Where a cut
/// begins the way is shorter and counts as a whole spot. Bounded memory.
class EnergyOfCut final : public CutMeasure {
 public:
  explicit EnergyOfCut(const machine::LaserSettings& laser);

  [[nodiscard]] bool is_drawn(const motion::Mark& mark) const override;
  [[nodiscard]] double take(const CutPeriod& period) override;
  /// A cut has its own energy up to its ends.
  [[nodiscard]] double between(double before, double behind) const override;
  [[nodiscard]] CutScale scale() const override { return CutScale::of_energies(burn(), most_); }
  [[nodiscard]] std::string caption() const override;

  /// Half of the cuts' way has less; 0 without any. Exact while half of the way has one energy,
  /// else within 1.1 %.
  [[nodiscard]] double median() const;
  [[nodiscard]] double most() const { return most_; }
  /// Of all cuts and of all places where the beam rested, J.
  [[nodiscard]] double total_j() const { return total_j_; }
  [[nodiscard]] std::uint32_t line_of_most() const { return line_of_most_; }
  /// Places with more are marked: LaserSettings::burn_j_mm, or twice the median.
  [[nodiscard]] double burn() const;

 private:
  struct Piece {
    double way_mm = 0, energy_j = 0;
  };
  /// How much way has about this energy, and the energy on it.
  using Bin = Piece;

  void lengthen(const Piece& piece);
  void book(const Piece& piece);

  machine::LaserSettings laser_;
  std::deque<Piece> last_;  // at most a spot's diameter and a piece
  Piece sum_;               // of them
  std::vector<Bin> bins_;
  double most_ = 0;
  double total_j_ = 0;
  std::uint32_t line_of_most_ = 0;
};

}  // namespace kerf::output::plot
