#pragma once

#include <map>
#include <memory>
#include <string>

#include "geometry/contour/region.hpp"
#include "job/internal/fixture.hpp"
#include "stock/turned/turned_part.hpp"

namespace kerf::job {

/// A chuck or a centre: round about the axis of the spindle. What tools meet of it while the work
/// turns is told by its section, what driven ones meet by dexels.
class RoundFixture final : public stock::Obstacle {
 public:
  /// `section`: that of the shape, (Z, ρ).
  RoundFixture(std::string name, const stock::Workpiece& shape, contour::Region section,
               double cell_mm);

  [[nodiscard]] const std::string& name() const override { return dexels_.name(); }
  [[nodiscard]] Contacts meet(std::span<const stock::Sweep> sweeps,
                              const stock::Body& body) override;
  [[nodiscard]] std::optional<double> first_touch(const stock::BallWay& ball) const override {
    return dexels_.first_touch(ball);
  }

 private:
  [[nodiscard]] stock::BodyId known(stock::BodyId number, const stock::Body& body);
  /// As it was before anything met it.
  void put_back();

  Fixture dexels_;
  contour::Region whole_;
  std::unique_ptr<stock::turned::TurnedPart> section_;
  std::map<stock::BodyId, stock::BodyId> bodies_;  // by the cutter's number
};

}  // namespace kerf::job
