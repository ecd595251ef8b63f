#pragma once

#include <array>
#include <functional>
#include <memory>

#include "job/live/cutting.hpp"
#include "stock/replay/model_player.hpp"

namespace kerf::job {

/// The part of a mill or a lathe: a model that is cut.
class ModelCutting final : public Cutting {
 public:
  ModelCutting(const ModelBegin& pass, std::uint32_t run, std::size_t memory_bytes);

  [[nodiscard]] stock::CutWatch& cuts() { return recording_; }
  void take(const stock::TimedCut& cut) override;
  void finish(double time_s) override { recording_.finish(time_s); }

  [[nodiscard]] double reached_s() const override { return recording_.record().reached_s(); }
  [[nodiscard]] bool is_full() const override { return recording_.record().is_full(); }
  [[nodiscard]] const Picture* at(double time_s, std::uint32_t level,
                                  const std::stop_token& unwanted) override;

 private:
  /// A level that somebody has looked at.
  struct Seen {
    Seen(std::unique_ptr<stock::Model> model, const stock::replay::Recording& recording,
         const stock::replay::Player::Settings& settings, const PictureOf& of)
        : player(std::move(model), recording, settings),
          picture(picture_of(player.model(), player.tiles(), of)) {}

    stock::replay::ModelPlayer player;
    std::unique_ptr<Picture> picture;
  };

  [[nodiscard]] std::unique_ptr<Seen> make(std::uint32_t level) const;

  std::function<std::unique_ptr<stock::Model>(double)> like_;
  stock::replay::Recording recording_;
  std::array<std::unique_ptr<Seen>, 2> seen_;  // of the levels
};

}  // namespace kerf::job
