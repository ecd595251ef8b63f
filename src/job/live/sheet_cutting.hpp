#pragma once

#include <functional>
#include <memory>

#include "job/live/cutting.hpp"
#include "stock/replay/sheet_player.hpp"

namespace kerf::job {

/// A sheet under a beam. It has one level, fine enough for its kerf where a picture can be.
class SheetCutting final : public Cutting {
 public:
  SheetCutting(const SheetBegin& pass, std::uint32_t run, std::size_t memory_bytes);

  [[nodiscard]] stock::replay::SheetRecording& recording() { return recording_; }
  void take(const stock::TimedCut& cut) override;
  void finish(double time_s) override { recording_.finish(time_s); }

  [[nodiscard]] double reached_s() const override { return recording_.reached_s(); }
  [[nodiscard]] bool is_full() const override { return recording_.is_full(); }
  [[nodiscard]] const Picture* at(double time_s, std::uint32_t level,
                                  const std::stop_token& unwanted) override;

 private:
  std::function<std::unique_ptr<stock::sheet::Sheet>()> like_;
  stock::replay::SheetRecording recording_;
  std::unique_ptr<stock::replay::SheetPlayer> player_;  // null: nobody has looked at it
  std::unique_ptr<Picture> picture_;
};

}  // namespace kerf::job
