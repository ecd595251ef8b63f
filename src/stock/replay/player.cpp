#include "stock/replay/player.hpp"

#include <algorithm>

namespace kerf::stock::replay {
namespace {

/// So many steps are done before somebody is asked whether it is still wanted.
constexpr std::size_t kAtOnce = 512;
/// Doing these is not slower than bringing tiles back.
constexpr std::size_t kFew = 64;

}  // namespace

Player::Player(Tiles& tiles, Redo redo, const Settings& settings)
    : redo_(std::move(redo)), settings_(settings), keeper_(tiles), own_(settings.own) {
  own_.add({0, keeper_.look()});
}

bool Player::go_to(const Record& record, const Instant& instant, const std::stop_token& unwanted) {
  if (instant == at_) return true;
  begin(record, instant.whole);
  while (at_.whole < instant.whole) {
    if (unwanted.stop_requested()) return false;
    const std::size_t end = std::min(instant.whole, at_.whole + kAtOnce);
    redo_(at_.whole, end, 1);
    at_ = {end, end, 0};
    if (!settings_.is_alike && own_.is_due(end)) own_.add({end, keeper_.look()});
  }
  if (instant.share > 0) {
    clean_ = keeper_.look();
    redo_(instant.whole, instant.end, instant.share);
  }
  at_ = instant;
  return true;
}

/// Stands behind whole motions, not behind these steps and near to them.
void Player::begin(const Record& record, std::size_t steps) {
  if (at_.share > 0) keeper_.bring_back(clean_);
  at_ = {at_.whole, at_.whole, 0};
  if (at_.whole <= steps && steps - at_.whole <= kFew) return;
  const auto nearest = checkpoint(record, steps);
  if (!nearest || (at_.whole <= steps && nearest->steps <= at_.whole)) return;
  keeper_.bring_back(nearest->moment);
  at_ = {nearest->steps, nearest->steps, 0};
}

std::optional<Checkpoint> Player::checkpoint(const Record& record, std::size_t steps) const {
  if (settings_.is_alike) return record.checkpoint(steps);
  const Checkpoint* const found = own_.before(steps);
  return found == nullptr ? std::nullopt : std::optional(*found);
}

}  // namespace kerf::stock::replay
