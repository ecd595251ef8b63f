#include "output/picture/internal/energy_of_cut.hpp"

#include <algorithm>

#include "math/math.hpp"
#include "output/picture/drawing/text.hpp"

namespace kerf::output::plot {
namespace {

constexpr std::size_t kPiecesPerSpot = 64;  // what is shorter is added to the piece before it
constexpr double kBinsPerOctave = 64;
constexpr double kLowestOctave = -20, kHighestOctave = 20;  // of J/mm
constexpr auto kBins = static_cast<std::size_t>((kHighestOctave - kLowestOctave) * kBinsPerOctave);

std::size_t bin_of(double energy_j_mm) {
  const double octave = std::clamp(math::log2(energy_j_mm), kLowestOctave, kHighestOctave);
  const double bin = (octave - kLowestOctave) * kBinsPerOctave;
  return std::min(static_cast<std::size_t>(bin), kBins - 1);
}

}  // namespace

EnergyOfCut::EnergyOfCut(const machine::LaserSettings& laser) : laser_(laser), bins_(kBins) {}

bool EnergyOfCut::is_drawn(const motion::Mark& mark) const {
  return mark.power_percent > 0 && mark.kind != motion::MoveKind::rapid;
}

double EnergyOfCut::take(const CutPeriod& period) {
  if (!is_drawn(period.mark)) {
    last_.clear();
    sum_ = {};
    return 0;
  }
  const double power_w = laser_.max_power_w * static_cast<double>(period.power_percent) / 100;
  const Piece piece{period.way_mm, power_w * period.time_s};
  total_j_ += piece.energy_j;
  lengthen(piece);
  book(piece);
  const double energy = sum_.energy_j / std::max(sum_.way_mm, laser_.spot_mm);
  if (energy > most_) {
    most_ = energy;
    line_of_most_ = period.mark.block.line;
  }
  return energy;
}

// The pieces whose sum reaches back by a spot's diameter.
void EnergyOfCut::lengthen(const Piece& piece) {
  const double short_way = laser_.spot_mm / kPiecesPerSpot;
  const bool joins = !last_.empty() && last_.back().way_mm + piece.way_mm < short_way;
  if (!joins) last_.push_back({});
  for (Piece* each : {&last_.back(), &sum_}) {
    each->way_mm += piece.way_mm;
    each->energy_j += piece.energy_j;
  }
  while (sum_.way_mm - last_.front().way_mm >= laser_.spot_mm) {
    sum_.way_mm -= last_.front().way_mm;
    sum_.energy_j -= last_.front().energy_j;
    last_.pop_front();
  }
}

void EnergyOfCut::book(const Piece& piece) {
  if (!(piece.way_mm > 0) || !(piece.energy_j > 0)) return;
  Bin& bin = bins_[bin_of(piece.energy_j / piece.way_mm)];
  bin.way_mm += piece.way_mm;
  bin.energy_j += piece.energy_j;
}

double EnergyOfCut::median() const {
  double all_mm = 0;
  for (const Bin& bin : bins_) all_mm += bin.way_mm;
  double below_mm = 0;
  for (const Bin& bin : bins_) {
    below_mm += bin.way_mm;
    if (bin.way_mm > 0 && below_mm >= all_mm / 2) return bin.energy_j / bin.way_mm;
  }
  return 0;
}

double EnergyOfCut::between(double before, double behind) const { return std::max(before, behind); }

double EnergyOfCut::burn() const { return laser_.burn_j_mm > 0 ? laser_.burn_j_mm : 2 * median(); }

std::string EnergyOfCut::caption() const {
  return "most " + significant(most_) + " \u00b7 median " + significant(median()) +
         " \u00b7 red: burns, more than " + significant(burn());
}

}  // namespace kerf::output::plot
