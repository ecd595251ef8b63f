#pragma once

#include <vector>

#include "features/path/allowance.hpp"
#include "features/tree/tree.hpp"
#include "features/turning/half_section.hpp"
#include "features/turning/turned_draft.hpp"

namespace kerf::features {

/// Follows the operations of a lathe in their order, takes from the bar what they cut, and puts
/// chains together to features.
class LatheWork {
 public:
  /// `blank` in machine coordinates. The recording and the allowance must outlive this.
  LatheWork(const Recording& recording, const Blank& blank, Allowance& allowance);

  void follow(std::size_t number, const Operation& operation);
  /// Features with all that is told of them, what is not recognised, and air, into the tree.
  void finish(Tree& tree);

 private:
  [[nodiscard]] const stock::Tool& tool_of(std::uint32_t number) const;
  [[nodiscard]] TurnedChain placed(std::size_t number, const Chain& chain, const stock::Tool& tool);
  [[nodiscard]] bool is_inside(const Chain& chain, const stock::Tool& tool,
                               const HalfSection& material) const;
  [[nodiscard]] FeatureType type_of(const TurnedChain& chain, const stock::Tool& tool) const;
  void take(std::size_t number, const Operation& operation, const Chain& chain);
  void take_thread(TurnedChain chain, const stock::Tool& tool);
  void take_cut(TurnedChain chain, const stock::Tool& tool);
  void take_axial(std::size_t number, const Chain& chain, const stock::Tool& tool);
  [[nodiscard]] std::optional<contour::Region> swept_by(const TurnedChain& chain);
  void leave(const Chain& chain);
  TurnedDraft& begin(FeatureType type, const TurnedChain& chain);
  [[nodiscard]] TurnedDraft* draft_for(FeatureType type, const TurnedChain& chain);
  [[nodiscard]] HalfSection& material_of(const Chain& chain);
  void tell_parents(Tree& tree) const;

  const Recording& recording_;
  Allowance& allowance_;
  std::vector<HalfSection> materials_;  // by set-up
  std::vector<TurnedDraft> drafts_;
  std::vector<Unrecognised> unrecognised_;
  std::vector<double> air_mm_;
};

}  // namespace kerf::features
