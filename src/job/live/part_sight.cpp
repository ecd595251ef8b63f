#include "job/live/part_sight.hpp"

#include <algorithm>

namespace kerf::job {
namespace {

/// FNV-1a; never 0.
std::uint64_t hash_of(const std::string& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char byte : bytes) {
    hash ^= static_cast<unsigned char>(byte);
    hash *= 0x100000001b3U;
  }
  return hash == 0 ? 1 : hash;
}

/// What somebody wants to see, as far as there is such a thing.
struct Shown {
  double time_s;
  std::uint32_t level;

  Shown(const Cutting& cutting, const PartWish& wish)
      : time_s(std::min(wish.time_s.value_or(cutting.reached_s()), cutting.reached_s())),
        level(std::min(wish.level, static_cast<std::uint32_t>(cutting.levels().size() - 1))) {}
};

}  // namespace

std::optional<PartAnswer> answer_at(Cutting& cutting, const PartWish& wish, stock::Vec3 at) {
  const Shown shown(cutting, wish);
  const Picture* const picture = cutting.at(shown.time_s, shown.level, {});
  const auto place = picture == nullptr ? std::nullopt : picture->nearest(at);
  if (!place) return std::nullopt;
  return PartAnswer{*place, cutting.owners().owner(place->motion)};
}

std::optional<PartLook> PartSight::look(const std::shared_ptr<Cutting>& cutting,
                                        const PartWish& wish, const std::stop_token& unwanted) {
  const Shown shown(*cutting, wish);
  if (cutting != cutting_ || shown.level != level_ || cutting->owners().edition() != edition_)
    begin(cutting, shown.level);
  PartLook look{.is_behind = wish.time_s && *wish.time_s > shown.time_s, .time_s = shown.time_s};
  const Picture* const picture = cutting->at(shown.time_s, shown.level, unwanted);
  if (picture == nullptr) return std::nullopt;
  look.removed_mm3 = picture->removed_mm3();
  const Picture::Parts parts = changed(*picture, look);
  tell_owners(look);
  if (parts.count == 0 && shown_s_ == look.time_s) return look;
  shown_s_ = look.time_s;
  look.frame = output::part_frame({.kind = picture->kind(),
                                   .run = cutting->run(),
                                   .number = frames_++,
                                   .level = shown.level,
                                   .time_s = look.time_s},
                                  parts.count, parts.bytes);
  return look;
}

void PartSight::begin(const std::shared_ptr<Cutting>& cutting, std::uint32_t level) {
  const std::uint32_t edition = cutting->owners().edition();
  if (cutting != cutting_ || edition != edition_) owners_ = 0;
  edition_ = edition;
  cutting_ = cutting;
  level_ = level;
  frames_ = 0;
  shown_s_.reset();
  seen_.clear();
}

void PartSight::tell_owners(PartLook& look) {
  look.first_owner = owners_;
  look.owners = cutting_->owners().numbered(owners_);
  owners_ += look.owners.size();
}

Picture::Parts PartSight::changed(const Picture& picture, PartLook& look) {
  Picture::Parts all;
  seen_.resize(picture.tiles());
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const std::uint64_t version = picture.version(i) + 1;
    if (seen_[i].version == version) continue;
    if (all.bytes.size() >= kFrameBytes) {
      look.has_more = true;
      break;
    }
    seen_[i].version = version;
    add(picture.parts(i), seen_[i], all);
  }
  return all;
}

void PartSight::add(const Picture::Parts& tile, Seen& seen, Picture::Parts& all) {
  const std::uint64_t hash = hash_of(tile.bytes);
  if (hash == seen.sent || (tile.is_empty && seen.sent == 0)) return;
  seen.sent = hash;
  all.bytes += tile.bytes;
  all.count += tile.count;
}

}  // namespace kerf::job
