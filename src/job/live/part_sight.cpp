#include "job/live/part_sight.hpp"

#include <algorithm>
#include <utility>

#include "output/part/fact_frame.hpp"

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

/// Of places that are there.
std::vector<std::optional<float>> deviations_of(const DesignInSight& design,
                                                const output::PartPlaces& at) {
  std::vector<stock::Vec3> there;
  for (const auto& place : at) {
    if (place) there.push_back(*place);
  }
  const std::vector<float> known = design.deviations_mm(there);
  std::vector<std::optional<float>> all(at.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (at[i]) all[i] = known[next++];
  }
  return all;
}

}  // namespace

std::optional<PartAnswer> answer_at(Cutting& cutting, const PartWish& wish, stock::Vec3 at) {
  const Shown shown(cutting, wish);
  const Picture* const picture = cutting.at(shown.time_s, shown.level, {});
  const auto place = picture == nullptr ? std::nullopt : picture->nearest(at);
  if (!place) return std::nullopt;
  PartAnswer answer{*place, cutting.owners().owner(place->motion)};
  if (const DesignInSight* const design = cutting.design())
    answer.deviation_mm = double{design->deviations_mm({&place->at, 1}).front()};
  return answer;
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
  if (parts.count > 0 || shown_s_ != look.time_s) put(picture->kind(), parts, look);
  shown_s_ = look.time_s;
  look.is_partial = look.has_more;
  const Picture::Parts told = facts(*picture, wish.deviation, unwanted, look);
  if (told.count > 0) put(output::PartKind::facts, told, look);
  return look;
}

void PartSight::put(output::PartKind kind, const Picture::Parts& parts, PartLook& look) {
  look.frames.push_back(output::part_frame({.kind = kind,
                                            .run = cutting_->run(),
                                            .number = frames_++,
                                            .level = level_,
                                            .time_s = look.time_s},
                                           parts.count, parts.bytes));
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
  OwnerTable::News news = cutting_->owners().since(owners_);
  look.first_owner = news.first;
  look.owners = std::move(news.rows);
  owners_ = news.change;
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
  seen.lacks_owners = seen.lacks_deviations = true;
  all.bytes += tile.bytes;
  all.count += tile.count;
}

// Of tiles that have changed since they were sent nothing is told: they come anew.
Picture::Parts PartSight::facts(const Picture& picture, bool with_deviation,
                                const std::stop_token& unwanted, PartLook& look) {
  Picture::Parts all;
  const DesignInSight* const design = with_deviation ? cutting_->design() : nullptr;
  const bool tells_owners = picture.kind() == output::PartKind::profile;
  std::size_t places = 0;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    Seen& seen = seen_[i];
    const bool lacks = (tells_owners && seen.lacks_owners) || (design && seen.lacks_deviations);
    if (!lacks || seen.version != picture.version(i) + 1) continue;
    if (places >= kPlacesAtOnce || unwanted.stop_requested()) {
      look.has_more = true;
      break;
    }
    places += tell(picture.places(i), design, seen, all);
  }
  return all;
}

/// How many places there are.
std::size_t PartSight::tell(const std::vector<Picture::Places>& places, const DesignInSight* design,
                            Seen& seen, Picture::Parts& all) {
  std::size_t count = 0;
  for (const Picture::Places& one : places) {
    count += one.at.size();
    if (one.at.empty()) continue;
    if (seen.lacks_owners && !one.owners.empty()) {
      all.bytes += output::owner_part(one.part, one.owners);
      ++all.count;
    }
    if (design == nullptr || !seen.lacks_deviations) continue;
    all.bytes += output::deviation_part(one.part, deviations_of(*design, one.at));
    ++all.count;
  }
  seen.lacks_owners = false;
  seen.lacks_deviations = seen.lacks_deviations && design == nullptr;
  return count;
}

}  // namespace kerf::job
