#include "stock/replay/player.hpp"

#include <algorithm>

#include "stock/sweep/shorten.hpp"

namespace kerf::stock::replay {
namespace {

/// So many steps are cut before somebody is asked whether it is still wanted.
constexpr std::size_t kAtOnce = 512;
/// Cutting these is not slower than bringing tiles back.
constexpr std::size_t kFew = 64;

}  // namespace

Player::Player(std::unique_ptr<Model> model, const Settings& settings)
    : settings_(settings),
      model_(std::move(model)),
      tiles_(tiles_of(*model_)),
      keeper_(*tiles_),
      own_(settings.own) {
  own_.add({0, keeper_.look()});
}

bool Player::go_to(const Recording& recording, const Instant& instant,
                   const std::stop_token& unwanted) {
  if (instant == at_) return true;
  for (const Body& body : recording.bodies(bodies_)) {
    static_cast<void>(model_->add_body(body));
    ++bodies_;
  }
  begin(recording, instant.whole);
  while (at_.whole < instant.whole) {
    if (unwanted.stop_requested()) return false;
    const std::size_t end = std::min(instant.whole, at_.whole + kAtOnce);
    cut(recording.sweeps(at_.whole, end));
    at_ = {end, end, 0};
    if (!settings_.is_alike && own_.is_due(end)) own_.add({end, keeper_.look()});
  }
  if (instant.share > 0) {
    clean_ = keeper_.look();
    std::vector<Sweep> motion = recording.sweeps(instant.whole, instant.end);
    shorten(motion, 0, instant.share);
    cut(motion);
  }
  at_ = instant;
  return true;
}

/// Stands behind whole motions, not behind these steps and near to them.
void Player::begin(const Recording& recording, std::size_t steps) {
  if (at_.share > 0) keeper_.bring_back(clean_);
  at_ = {at_.whole, at_.whole, 0};
  if (at_.whole <= steps && steps - at_.whole <= kFew) return;
  const auto nearest = checkpoint(recording, steps);
  if (!nearest || (at_.whole <= steps && nearest->steps <= at_.whole)) return;
  keeper_.bring_back(nearest->moment);
  at_ = {nearest->steps, nearest->steps, 0};
}

std::optional<Checkpoint> Player::checkpoint(const Recording& recording, std::size_t steps) const {
  if (settings_.is_alike) return recording.checkpoint(steps);
  const Checkpoint* const found = own_.before(steps);
  return found == nullptr ? std::nullopt : std::optional(*found);
}

void Player::cut(const std::vector<Sweep>& sweeps) {
  outcomes_.assign(sweeps.size(), Outcome{});
  model_->cut(sweeps, outcomes_);
}

}  // namespace kerf::stock::replay
