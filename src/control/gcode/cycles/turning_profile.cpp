#include "control/gcode/cycles/turning_profile.hpp"

#include <algorithm>
#include <utility>

namespace kerf::control {
namespace {

std::vector<double> tops_of(const std::vector<MonotonePiece>& pieces) {
  std::vector<double> tops;
  for (const MonotonePiece& piece : pieces) tops.push_back(std::max(piece.from.v, piece.to.v));
  return tops;
}

std::vector<double> depths_of(const std::vector<MonotonePiece>& pieces) {
  std::vector<double> depths;
  for (const MonotonePiece& piece : pieces) depths.push_back(-std::min(piece.from.v, piece.to.v));
  return depths;
}

}  // namespace

TurningProfile::TurningProfile(std::vector<MonotonePiece> pieces)
    : pieces_(std::move(pieces)), tops_(tops_of(pieces_)), depths_(depths_of(pieces_)) {}

std::size_t TurningProfile::first_above(std::size_t first, double level) const {
  return tops_.first_above(first, level + kSameLevel_mm);
}

std::size_t TurningProfile::first_at_or_below(std::size_t first, double level) const {
  return depths_.first_above(first, -level - kSameLevel_mm);
}

double TurningProfile::lowest(std::size_t first, std::size_t last) const {
  return -depths_.maximum(first, last);
}

}  // namespace kerf::control
