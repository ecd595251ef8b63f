#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "stock/replay/player.hpp"
#include "stock/replay/recording.hpp"

namespace kerf::stock::replay {

/// A model that goes to any time of the recording of another one. Not for several threads at once.
class ModelPlayer {
 public:
  /// `model`: made as the recorded one was, but for its cells. The recording outlives it.
  ModelPlayer(std::unique_ptr<Model> model, const Recording& recording,
              const Player::Settings& settings);

  /// As late as it is recorded. False: `unwanted` came first.
  bool go_to(double time_s, const std::stop_token& unwanted);

  [[nodiscard]] const Model& model() const { return *model_; }
  [[nodiscard]] const Tiles& tiles() const { return *tiles_; }

 private:
  void redo(std::size_t from, std::size_t to, double share);

  std::unique_ptr<Model> model_;
  const Recording& recording_;
  std::unique_ptr<Tiles> tiles_;
  Player player_;
  std::size_t bodies_ = 0;
  std::vector<Outcome> outcomes_;
};

}  // namespace kerf::stock::replay
