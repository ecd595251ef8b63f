#include "stock/field/tally.hpp"

#include <algorithm>

namespace kerf::stock::field {

void Tally::begin(const FieldTool& tool) {
  taken_.bins_per_mm =
      tool.edge_reach > 0 ? static_cast<float>(Outcome::kBins / (2 * tool.edge_reach)) : 0.0F;
  taken_.reach = static_cast<float>(tool.edge_reach);
}

void Tally::meet(ToolPart part, Vec3 at, double depth) {
  Met& met = met_[index(part)];
  met.deepest.add({depth, at, Exact()});
  met.depths += depth;
  has_met_ = true;
}

void Tally::take_to(Outcome& outcome, double cell_mm2) {
  outcome.removed += Exact(removed() * cell_mm2);
  outcome.core += Exact(core_ * cell_mm2);
  outcome.visited += visited_;
  if (taken_.right <= taken_.left) take_sides(outcome, cell_mm2);
  if (has_met_) take_contacts(outcome, cell_mm2);
  taken_.heights = {};
  core_ = 0;
  visited_ = 0;
}

// From the bin of the one side to that of the other; all of them would take as long as what has
// been added.
void Tally::take_sides(Outcome& outcome, double cell_mm2) {
  outcome.aside.add({static_cast<double>(taken_.right), static_cast<double>(taken_.left)});
  outcome.heights.add({static_cast<double>(taken_.lowest), static_cast<double>(taken_.highest)});
  const auto bin = [&](float offset) {
    return static_cast<std::size_t>(
        std::clamp(taken_.place_of(offset), 0.0F, Outcome::kBins - 1.0F));
  };
  const std::size_t first = bin(taken_.right);
  const std::size_t end = bin(taken_.left) + 1;
  auto& [all, others] = taken_.across;
  for (std::size_t i = first; i < end; ++i) all[i] += others[i];
  Exact::add({&all[first], end - first}, cell_mm2, removed(), &outcome.across[first]);
  for (auto& part : taken_.across) std::fill(&part[first], &part[end], 0.0);
  taken_.left = taken_.highest = -kNowhere;
  taken_.right = taken_.lowest = kNowhere;
}

void Tally::take_contacts(Outcome& outcome, double cell_mm2) {
  for (std::size_t i = 0; i < kToolParts; ++i) {
    Contact met = met_[i].deepest;
    if (!met.is_one()) continue;
    met.volume = Exact(met_[i].depths * cell_mm2);
    outcome.contacts[i].add(met);
    met_[i] = {};
  }
  has_met_ = false;
}

}  // namespace kerf::stock::field
