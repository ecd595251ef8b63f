#include "stock/dexel/tally.hpp"

#include <algorithm>
#include <array>

namespace kerf::stock::dexel {

Tally& Tallies::own(std::size_t thread, std::size_t sweeps) {
  Tally& tally = all_[thread];
  if (tally.outcomes.size() < sweeps) tally.outcomes.resize(sweeps);
  return tally;
}

/// Seen by the dexels of the main axis.
bool Tallies::has_contact(const AsideContact& one) {
  return std::any_of(all_.begin(), all_.end(), [&](const Tally& tally) {
    return one.number < tally.outcomes.size() &&
           tally.outcomes[one.number].contacts[one.part].is_one();
  });
}

/// Those that count.
std::vector<AsideContact> Tallies::take_aside(std::size_t sweeps) {
  std::vector<AsideContact> open;
  for (Tally& tally : all_) {
    for (const AsideContact& one : tally.aside) {
      if (!has_contact(one)) open.push_back(one);
    }
    tally.aside.clear();
  }
  if (open.empty()) return open;
  std::vector<std::array<bool, kToolParts>> has_first(sweeps);
  for (const AsideContact& one : open) {
    if (one.rank == 1 && one.contact.is_one()) has_first[one.number][one.part] = true;
  }
  std::erase_if(open, [&](const AsideContact& one) {
    return one.rank != 1 && has_first[one.number][one.part];
  });
  return open;
}

void Tallies::take_some(std::size_t first, std::size_t after, std::span<Outcome> outcomes) {
  for (Tally& tally : all_) {
    for (std::size_t i = first; i < std::min(after, tally.outcomes.size()); ++i) {
      outcomes[i].add(tally.outcomes[i]);
      tally.outcomes[i] = Outcome{};
    }
  }
}

}  // namespace kerf::stock::dexel
