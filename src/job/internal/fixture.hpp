#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "stock/cutting/obstacle.hpp"
#include "stock/cutting/workpiece.hpp"
#include "stock/dexel/tri_dexel.hpp"

namespace kerf::job {

/// A fixture as dexels, which are put back after whatever has met them.
class Fixture final : public stock::Obstacle {
 public:
  Fixture(std::string name, const stock::Workpiece& shape, double cell_mm);

  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] Contacts meet(std::span<const stock::Sweep> sweeps,
                              const stock::Body& body) override;
  [[nodiscard]] std::optional<double> first_touch(const stock::BallWay& ball) const override {
    return dexels_.first_touch(ball);
  }

 private:
  using Tiles = std::vector<stock::dexel::TriDexel::TileState>;

  [[nodiscard]] stock::BodyId known(const stock::Sweep& sweep, const stock::Body& body);
  [[nodiscard]] bool is_near(const stock::Sweep& sweep, const stock::Body& body) const;
  void keep();
  void put_back();

  std::string name_;
  stock::Bounds box_;
  stock::dexel::TriDexel dexels_;
  std::array<Tiles, 3> whole_;
  std::map<stock::BodyId, stock::BodyId> bodies_;  // by the cutter's number
};

}  // namespace kerf::job
