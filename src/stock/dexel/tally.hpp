#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "stock/sweep/outcome.hpp"

namespace kerf::stock::dexel {

/// A contact that dexels across the tool saw.
struct AsideContact {
  std::size_t number = 0;
  std::size_t part = 0;
  int rank = 1;  ///< 1: of the axis after the main one, 2: of the next
  Contact contact;
};

/// What one thread counts of the sweeps of a call.
struct Tally {
  std::vector<Outcome> outcomes;
  std::vector<AsideContact> aside;
};

/// Of all threads. Between calls all is 0, and the memory stays.
class Tallies {
 public:
  static constexpr std::size_t kTogether = 256;  ///< sweeps that one thread adds up

  explicit Tallies(std::size_t threads) : all_(threads) {}

  /// That of a thread, by its number, for so many sweeps.
  [[nodiscard]] Tally& own(std::size_t thread, std::size_t sweeps);
  /// Adds what was counted to the outcomes. `each(count, work)` does work(i)
  /// for i below count, in several threads. Contacts aside count where there
  /// are no others: of the first rank that has any.
  template <class Each>
  void take(std::span<Outcome> outcomes, Each&& each) {
    const std::vector<AsideContact> aside = take_aside(outcomes.size());
    each((outcomes.size() + kTogether - 1) / kTogether, [&](std::size_t i) {
      const std::size_t first = i * kTogether;
      take_some(first, std::min(first + kTogether, outcomes.size()), outcomes);
    });
    for (const AsideContact& one : aside) outcomes[one.number].contacts[one.part].add(one.contact);
  }

 private:
  [[nodiscard]] std::vector<AsideContact> take_aside(std::size_t sweeps);
  [[nodiscard]] bool has_contact(const AsideContact& one);
  void take_some(std::size_t first, std::size_t after, std::span<Outcome> outcomes);

  std::vector<Tally> all_;
};

}  // namespace kerf::stock::dexel
