#include "stock/field/tally.hpp"

namespace kerf::stock::field {

Tally::Tally(const FieldTool& tool)
    : bins_per_mm_(tool.edge_reach > 0 ? static_cast<float>(Outcome::kBins / (2 * tool.edge_reach))
                                       : 0.0F),
      reach_(static_cast<float>(tool.edge_reach)) {}

void Tally::meet(ToolPart part, Vec3 at, double depth) {
  Met& met = met_[index(part)];
  met.deepest.add({depth, at, Exact()});
  met.depths += depth;
}

void Tally::add_to(Outcome& outcome, double cell_mm2) const {
  outcome.removed += Exact(removed_ * cell_mm2);
  outcome.core += Exact(core_ * cell_mm2);
  outcome.visited += visited_;
  if (right_ <= left_) {
    outcome.aside.add({double{right_}, double{left_}});
    outcome.heights.add({double{lowest_}, double{highest_}});
  }
  for (std::size_t i = 0; i < across_.size(); ++i) {
    if (across_[i] > 0) outcome.across[i] += Exact(across_[i] * cell_mm2);
  }
  for (std::size_t i = 0; i < kToolParts; ++i) {
    Contact met = met_[i].deepest;
    if (!met.is_one()) continue;
    met.volume = Exact(met_[i].depths * cell_mm2);
    outcome.contacts[i].add(met);
  }
}

}  // namespace kerf::stock::field
