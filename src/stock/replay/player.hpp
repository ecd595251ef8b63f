#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "stock/replay/checkpoints.hpp"
#include "stock/replay/recording.hpp"

namespace kerf::stock::replay {

/// A model that goes to any time of a recording: from the checkpoint before it, or from where it
/// stands, over the steps up to it, of the last motion a part. However it comes there, it is the
/// same to the last bit. Not for several threads at once.
class Player {
 public:
  struct Settings {
    /// Its cells are those of the recorded model, whose checkpoints are its own.
    bool is_alike = true;
    Checkpoints::Settings own{};  ///< of its own checkpoints, where it is not
  };
  /// `model`: made as the recorded one was, but for its cells.
  Player(std::unique_ptr<Model> model, const Settings& settings);

  /// False: `unwanted` came before it was there; it goes on from where it is the next time.
  bool go_to(const Recording& recording, const Instant& instant, const std::stop_token& unwanted);
  /// Where it has come to.
  [[nodiscard]] const Instant& at() const { return at_; }

  [[nodiscard]] const Model& model() const { return *model_; }
  [[nodiscard]] const Tiles& tiles() const { return *tiles_; }

 private:
  void begin(const Recording& recording, std::size_t steps);
  [[nodiscard]] std::optional<Checkpoint> checkpoint(const Recording& recording,
                                                     std::size_t steps) const;
  void cut(const std::vector<Sweep>& sweeps);

  Settings settings_;
  std::unique_ptr<Model> model_;
  std::unique_ptr<Tiles> tiles_;
  Keeper keeper_;
  Checkpoints own_;
  Moment clean_;  // behind at_.whole, where a part is cut on top of it
  Instant at_;
  std::size_t bodies_ = 0;
  std::vector<Outcome> outcomes_;
};

}  // namespace kerf::stock::replay
