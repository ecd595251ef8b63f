#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "stock/dexel/tri_dexel.hpp"
#include "stock/turned/turned_part.hpp"

namespace kerf::stock::turnmill {

/// Stock of a lathe that is more than a body of revolution: sweeps under which the work turns cut
/// it as a profile does, all others as dexels do.
///
///   turned sweep  ->  profile: what it meets, as a region of (Z, ρ)  ->  dexels lose what turns
///   driven sweep  ->  dexels
///
/// The profile is what turning alone would have left: it holds the part. A bar is exact while
/// nothing but turning has cut it; after that only faces of driven tools count for the error, since
/// what the dexels have less than the profile is what driven tools have cut. A turned sweep that
/// meets the profile where a driven tool has cut everything away meets nothing.
class TurnMillPart final : public Model {
 public:
  /// A bar or a tube about Z, `cell_mm` and `jobs` as TriDexel has them.
  TurnMillPart(const contour::Region& bar, double cell_mm, unsigned jobs);
  /// Stock of any shape.
  TurnMillPart(const dexel::Shape& shape, double cell_mm, unsigned jobs);

  [[nodiscard]] BodyId add_body(const Body& body) override;
  /// Of a turned sweep what TurnedPart can, else what has a profile.
  [[nodiscard]] bool can_cut(const Sweep& sweep) const override;
  void cut(std::span<const Sweep> sweeps, std::span<Outcome> outcomes) override;
  void use(base::Helper* helper) override { dexels_.use(helper); }
  [[nodiscard]] std::optional<double> first_touch(const BallWay& ball) const override;
  [[nodiscard]] Stretch material_on(const StraightWay& line) const override {
    return is_abreast_ ? dexels_.material_on(line) : profile_.material_on(line);
  }

  [[nodiscard]] double left_mm3() const override;
  [[nodiscard]] double stock_mm3() const override;
  [[nodiscard]] double error_mm3() const override;
  [[nodiscard]] Bounds extents() const override;
  [[nodiscard]] std::vector<Piece> pieces() const override;
  [[nodiscard]] double grain_mm() const override { return dexels_.grain_mm(); }
  [[nodiscard]] std::size_t bytes() const override;

  /// The dexels are as the profile says. Before they are looked at.
  void catch_up();
  [[nodiscard]] const dexel::TriDexel& dexels() const { return dexels_; }
  [[nodiscard]] const turned::TurnedPart& profile() const { return profile_; }

 private:
  /// From this motion on sweeps are driven, or turned.
  struct Change {
    std::uint32_t motion;
    bool is_driven;
  };

  void cut_turned(const Sweep& sweep, Outcome& outcome);
  void cut_driven(std::span<const Sweep> sweeps, std::span<Outcome> outcomes);
  void take(const turned::TurnedCut& cut, const Sweep& sweep, Outcome& outcome);
  void note(const Sweep& sweep);
  [[nodiscard]] bool was_driven(std::uint32_t motion) const;
  [[nodiscard]] std::array<double, 3> driven_faces() const;

  contour::Region stock_;  ///< that the profile began as
  turned::TurnedPart profile_;
  dexel::TriDexel dexels_;
  bool is_bar_;
  /// The dexels have lost all that the profile has.
  bool is_abreast_ = false;
  std::vector<double> touch_mm_;  ///< of bodies
  std::vector<bool> has_profile_;
  std::vector<Change> changes_;
};

}  // namespace kerf::stock::turnmill
