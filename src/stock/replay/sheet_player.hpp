#pragma once

#include <memory>
#include <stop_token>

#include "stock/replay/player.hpp"
#include "stock/replay/sheet_recording.hpp"

namespace kerf::stock::replay {

/// A sheet that goes to any time of the recording of one like it. Not for several threads at once.
class SheetPlayer {
 public:
  /// The recording outlives it.
  SheetPlayer(std::unique_ptr<sheet::Sheet> sheet, const SheetRecording& recording);

  /// As late as it is recorded. False: `unwanted` came first.
  bool go_to(double time_s, const std::stop_token& unwanted);

  [[nodiscard]] const sheet::Sheet& sheet() const { return *sheet_; }

 private:
  void cut(std::size_t from, std::size_t to, double share);
  void burn(std::size_t from, std::size_t to, double share);

  std::unique_ptr<sheet::Sheet> sheet_;
  const SheetRecording& recording_;
  std::unique_ptr<Tiles> coverage_;
  std::unique_ptr<Tiles> energy_;
  Player cuts_;
  Player burns_;
};

}  // namespace kerf::stock::replay
