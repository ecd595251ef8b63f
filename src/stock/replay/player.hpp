#pragma once

#include <functional>
#include <optional>
#include <stop_token>

#include "stock/replay/record.hpp"

namespace kerf::stock::replay {

/// Brings something to any time of a record: from the checkpoint before it, or from where it
/// stands, over the steps up to it, of the last motion a part. However it comes there, it is the
/// same to the last bit. Not for several threads at once.
class Player {
 public:
  /// Does the steps [from, to) once more; where the share is not 1 they are one motion, of whose
  /// way only that much is made.
  using Redo = std::function<void(std::size_t from, std::size_t to, double share)>;

  struct Settings {
    /// Its tiles are those that were recorded, and so are its checkpoints.
    bool is_alike = true;
    Checkpoints::Settings own{};  ///< of its own checkpoints, where they are not
  };
  /// The tiles are as those of the record were before the first step, and outlive the player.
  Player(Tiles& tiles, Redo redo, const Settings& settings);

  /// False: `unwanted` came before it was there; it goes on from where it is the next time.
  bool go_to(const Record& record, const Instant& instant, const std::stop_token& unwanted);

 private:
  void begin(const Record& record, std::size_t steps);
  [[nodiscard]] std::optional<Checkpoint> checkpoint(const Record& record, std::size_t steps) const;

  Redo redo_;
  Settings settings_;
  Keeper keeper_;
  Checkpoints own_;
  Moment clean_;  // behind at_.whole, where a part is done on top of it
  Instant at_;
};

}  // namespace kerf::stock::replay
