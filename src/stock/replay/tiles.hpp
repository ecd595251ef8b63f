#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/interface.hpp"
#include "stock/sweep/model.hpp"

namespace kerf::stock::replay {

/// What a tile of a model, or all that it remembers beside its tiles, holds. Never changes.
class Content : public base::Interface {
 public:
  [[nodiscard]] virtual std::size_t bytes() const = 0;
};
using Kept = std::shared_ptr<const Content>;

/// A model that can be kept and brought back tile by tile, to the last bit.
class Tiles : public base::Interface {
 public:
  [[nodiscard]] virtual std::size_t count() const = 0;
  /// Another number than before: the tile may hold something else.
  [[nodiscard]] virtual std::uint64_t version(std::size_t tile) const = 0;
  [[nodiscard]] virtual Kept keep(std::size_t tile) const = 0;
  /// Precondition: keep() of this tile, of a model that was made alike.
  virtual void bring_back(std::size_t tile, const Content& kept) = 0;
  /// What cutting goes on from besides: to be brought back last.
  [[nodiscard]] virtual Kept keep_trail() const = 0;
  virtual void bring_back_trail(const Content& kept) = 0;
};

/// The tiles of a model of any of the rooms beside this one; the model outlives them. Null: it has
/// none.
[[nodiscard]] std::unique_ptr<Tiles> tiles_of(Model& model);

/// A model at one moment. Copies share what tiles hold.
struct Moment {
  std::vector<Kept> tiles;
  Kept trail;
};

/// Follows a model and keeps of it what has changed since it looked last.
class Keeper {
 public:
  /// The tiles outlive it.
  explicit Keeper(Tiles& tiles);

  /// The model as it is.
  [[nodiscard]] const Moment& look();
  /// Brings the model to a moment of one that was made alike; tiles that hold it stay.
  void bring_back(const Moment& moment);

 private:
  Tiles& tiles_;
  Moment seen_;
  std::vector<std::uint64_t> versions_;  // of the tiles, as they were seen
};

}  // namespace kerf::stock::replay
