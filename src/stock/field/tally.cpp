#include "stock/field/tally.hpp"

#include <algorithm>

namespace kerf::stock::field {
namespace {

double highest_of(const BlockValues& all) {
  return static_cast<double>(*std::max_element(all.begin(), all.end()));
}
double lowest_of(const BlockValues& all) {
  return static_cast<double>(*std::min_element(all.begin(), all.end()));
}

}  // namespace

void Tally::begin(const FieldTool& tool) {
  sides_.bins_per_mm =
      tool.edge_reach > 0 ? static_cast<float>(Outcome::kBins / (2 * tool.edge_reach)) : 0.0F;
  sides_.reach = static_cast<float>(tool.edge_reach);
}

void Tally::meet(ToolPart part, Vec3 at, double depth) {
  Met& met = met_[index(part)];
  met.deepest.add({depth, at, Exact()});
  met.depths += depth;
}

void Tally::take_to(Outcome& outcome, double cell_mm2) {
  outcome.removed += Exact(removed_ * cell_mm2);
  outcome.core += Exact(core_ * cell_mm2);
  outcome.visited += visited_;
  const double left = highest_of(sides_.left);
  const double right = lowest_of(sides_.right);
  if (right <= left) {
    outcome.aside.add({right, left});
    outcome.heights.add({lowest_of(sides_.lowest), highest_of(sides_.highest)});
  }
  for (std::uint64_t bins = bins_; bins != 0; bins &= bins - 1) {
    const auto bin = static_cast<std::size_t>(std::countr_zero(bins));
    outcome.across[bin] += Exact(across_[bin] * cell_mm2);
    across_[bin] = 0;
  }
  for (std::size_t i = 0; i < kToolParts; ++i) {
    Contact met = met_[i].deepest;
    if (!met.is_one()) continue;
    met.volume = Exact(met_[i].depths * cell_mm2);
    outcome.contacts[i].add(met);
    met_[i] = {};
  }
  // What is not 0 any more; all of it would take as long as what has been added.
  sides_ = no_sides();
  removed_ = core_ = 0;
  visited_ = bins_ = 0;
}

}  // namespace kerf::stock::field
