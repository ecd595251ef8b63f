#include "stock/replay/model_player.hpp"

#include "stock/sweep/shorten.hpp"

namespace kerf::stock::replay {

ModelPlayer::ModelPlayer(std::unique_ptr<Model> model, const Recording& recording,
                         const Player::Settings& settings)
    : model_(std::move(model)),
      recording_(recording),
      tiles_(tiles_of(*model_)),
      player_(
          *tiles_,
          [this](std::size_t from, std::size_t to, double share) { redo(from, to, share); },
          settings) {}

bool ModelPlayer::go_to(double time_s, const std::stop_token& unwanted) {
  const Instant instant = recording_.record().at(time_s);
  for (const Body& body : recording_.bodies(bodies_)) {
    static_cast<void>(model_->add_body(body));
    ++bodies_;
  }
  return player_.go_to(recording_.record(), instant, unwanted);
}

void ModelPlayer::redo(std::size_t from, std::size_t to, double share) {
  std::vector<Sweep> sweeps = recording_.sweeps(from, to);
  if (share < 1) shorten(sweeps, 0, share);
  outcomes_.assign(sweeps.size(), Outcome{});
  model_->cut(sweeps, outcomes_);
}

}  // namespace kerf::stock::replay
