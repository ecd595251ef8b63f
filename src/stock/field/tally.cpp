#include "stock/field/tally.hpp"

#include <algorithm>

namespace kerf::stock::field {

Tally::Tally(const FieldTool& tool)
    : bins_per_mm_(tool.edge_reach > 0 ? Outcome::kBins / (2 * tool.edge_reach) : 0),
      reach_(tool.edge_reach) {}

void Tally::remove_at(double offset, double height) {
  removed_ += height;
  const double place = std::clamp((offset + reach_) * bins_per_mm_, 0.0, Outcome::kBins - 1.0);
  const int bin = static_cast<int>(place);
  if (last_bin_ < first_bin_) first_bin_ = bin + 1, last_bin_ = bin;
  while (first_bin_ > bin) across_[static_cast<std::size_t>(--first_bin_)] = 0;
  while (last_bin_ < bin) across_[static_cast<std::size_t>(++last_bin_)] = 0;
  across_[static_cast<std::size_t>(bin)] += height;
}

void Tally::meet(ToolPart part, Vec3 at, double depth) {
  Met& met = met_[index(part)];
  met.deepest.add({depth, at, Exact()});
  met.depths += depth;
}

void Tally::add_to(Outcome& outcome, double cell_mm2) const {
  outcome.removed += Exact(removed_ * cell_mm2);
  outcome.core += Exact(core_ * cell_mm2);
  outcome.visited += visited_;
  for (int bin = first_bin_; bin <= last_bin_; ++bin) {
    const auto i = static_cast<std::size_t>(bin);
    outcome.across[i] += Exact(across_[i] * cell_mm2);
  }
  for (std::size_t i = 0; i < kToolParts; ++i) {
    Contact met = met_[i].deepest;
    if (!met.is_one()) continue;
    met.volume = Exact(met_[i].depths * cell_mm2);
    outcome.contacts[i].add(met);
  }
}

}  // namespace kerf::stock::field
