#include "job/live/part_sight.hpp"

#include <algorithm>
#include <array>

#include "stock/surface/contouring.hpp"
#include "stock/surface/dexel_samples.hpp"

namespace kerf::job {
namespace {

using output::PartKind;
using stock::Bounds;
using stock::Vec3;
using stock::dexel::Lattice;
using stock::dexel::TriDexel;
using stock::replay::Player;
using stock::surface::Place;

/// FNV-1a; never 0.
std::uint64_t hash_of(const std::string& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char byte : bytes) {
    hash ^= static_cast<unsigned char>(byte);
    hash *= 0x100000001b3U;
  }
  return hash == 0 ? 1 : hash;
}

bool meet(const Bounds& a, const Bounds& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}

/// Of the dexels of a tile, frame of the stock.
Bounds box_of(const TriDexel& model, int grid, std::size_t tile) {
  const Lattice& lattice = model.lattice(grid);
  const auto across = static_cast<std::size_t>(lattice.tiles_b());
  const int b = static_cast<int>(tile % across) * Lattice::kTile;
  const int c = static_cast<int>(tile / across) * Lattice::kTile;
  std::array<double, 3> low{};
  std::array<double, 3> high{};
  const auto of = [](int axis) { return static_cast<std::size_t>(axis % 3); };
  low[of(grid)] = -lattice.half_s;
  high[of(grid)] = lattice.half_s;
  low[of(grid + 1)] = lattice.b_of(b) - lattice.cell_b;
  high[of(grid + 1)] = lattice.b_of(b + Lattice::kTile);
  low[of(grid + 2)] = lattice.c_of(c) - lattice.cell_c;
  high[of(grid + 2)] = lattice.c_of(c + Lattice::kTile);
  return {model.middle() + Vec3{low[0], low[1], low[2]},
          model.middle() + Vec3{high[0], high[1], high[2]}};
}

/// Tiles count through the grids.
std::vector<Bounds> boxes_of(const TriDexel& model, const std::vector<std::size_t>& tiles) {
  std::vector<Bounds> boxes;
  for (std::size_t tile : tiles) {
    int grid = 0;
    while (tile >= model.tiles(grid)) tile -= model.tiles(grid++);
    boxes.push_back(box_of(model, grid, tile));
  }
  return boxes;
}

Place place_of(std::size_t number, Place blocks) {
  const int n = static_cast<int>(number);
  return {n % blocks[0], n / blocks[0] % blocks[1], n / (blocks[0] * blocks[1])};
}

}  // namespace

std::optional<PartLook> PartSight::look(const std::shared_ptr<Cutting>& cutting,
                                        const PartWish& wish, const std::stop_token& unwanted) {
  const auto finest = static_cast<std::uint32_t>(cutting->levels().size() - 1);
  const std::uint32_t level = std::min(wish.level, finest);
  if (cutting != cutting_ || level != level_ || cutting->owners().edition() != edition_)
    begin(cutting, level);
  const double reached_s = cutting->reached_s();
  PartLook look{.is_behind = wish.time_s && *wish.time_s > reached_s,
                .time_s = std::min(wish.time_s.value_or(reached_s), reached_s)};
  const Player* const player = cutting->at(look.time_s, level, unwanted);
  if (player == nullptr) return std::nullopt;
  look.removed_mm3 = player->model().stock_mm3() - player->model().left_mm3();
  const PartKind kind = add_parts(*player);
  look.has_more = has_more_;
  tell_owners(look);
  if (count_ == 0 && shown_s_ == look.time_s) return look;
  shown_s_ = look.time_s;
  look.frame = output::part_frame({.kind = kind,
                                   .run = cutting->run(),
                                   .number = frames_++,
                                   .level = level,
                                   .time_s = look.time_s},
                                  count_, parts_);
  parts_.clear();
  count_ = 0;
  return look;
}

void PartSight::begin(const std::shared_ptr<Cutting>& cutting, std::uint32_t level) {
  if (cutting != cutting_ || cutting->owners().edition() != edition_) owners_ = 0;
  edition_ = cutting->owners().edition();
  cutting_ = cutting;
  level_ = level;
  frames_ = 0;
  shown_s_.reset();
  versions_.clear();
  seen_.clear();
}

void PartSight::tell_owners(PartLook& look) {
  look.first_owner = owners_;
  look.owners = cutting_->owners().numbered(owners_);
  owners_ += look.owners.size();
}

PartKind PartSight::add_parts(const Player& player) {
  has_more_ = false;
  const std::vector<std::size_t> changed = this->changed(player.tiles());
  const stock::Model& model = player.model();
  if (const auto* const field = dynamic_cast<const stock::field::HeightField*>(&model)) {
    add_heights(*field, changed);
    return PartKind::heights;
  }
  if (const auto* const dexels = dynamic_cast<const TriDexel*>(&model)) {
    add_mesh(*dexels, changed);
    return PartKind::mesh;
  }
  add_profile(dynamic_cast<const stock::turned::TurnedPart&>(model), changed);
  return PartKind::profile;
}

std::vector<std::size_t> PartSight::changed(const stock::replay::Tiles& tiles) {
  std::vector<std::size_t> list;
  const bool is_first = versions_.empty();
  versions_.resize(tiles.count());
  for (std::size_t i = 0; i < versions_.size(); ++i) {
    const std::uint64_t version = tiles.version(i);
    if (is_first || version != versions_[i]) list.push_back(i);
    versions_[i] = version;
  }
  return list;
}

output::OwnerOf PartSight::owner_of() const {
  return [&owners = cutting_->owners()](std::uint32_t motion) { return owners.number(motion); };
}

template <class PartOf>
void PartSight::add_old(const PartOf& part_of) {
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    if (!seen_[i].is_old) continue;
    if (parts_.size() >= kFrameBytes) {
      has_more_ = true;
      return;
    }
    seen_[i].is_old = false;
    add(seen_[i], part_of(i));
  }
}

void PartSight::add_heights(const stock::field::HeightField& field,
                            const std::vector<std::size_t>& changed) {
  const stock::field::Columns& columns = field.columns();
  seen_.resize(columns.grid().tiles());
  for (const std::size_t tile : changed) seen_[tile].is_old = true;
  add_old([&](std::size_t tile) { return output::height_part(columns, tile, owner_of()); });
}

void PartSight::add_mesh(const TriDexel& model, const std::vector<std::size_t>& changed) {
  const stock::surface::DexelSamples samples(model);
  const stock::surface::Contouring contouring(samples);
  const Place blocks = contouring.blocks();
  seen_.resize(static_cast<std::size_t>(blocks[0]) * static_cast<std::size_t>(blocks[1]) *
               static_cast<std::size_t>(blocks[2]));
  const std::vector<Bounds> boxes = boxes_of(model, changed);
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const Bounds seen = contouring.seen(place_of(i, blocks));
    const auto meets = [&](const Bounds& box) { return meet(seen, box); };
    seen_[i].is_old = seen_[i].is_old || std::any_of(boxes.begin(), boxes.end(), meets);
  }
  add_old([&](std::size_t i) {
    const Place block = place_of(i, blocks);
    const stock::surface::Patch patch = contouring.patch(block);
    const bool shows_nothing = patch.triangles.empty() && seen_[i].sent == 0;
    return shows_nothing ? std::string() : output::mesh_part(block, patch, owner_of());
  });
}

/// A half section is shown whole, in one frame.
void PartSight::add_profile(const stock::turned::TurnedPart& part,
                            const std::vector<std::size_t>& changed) {
  seen_.resize(1);
  if (changed.empty()) return;
  std::string loops;
  for (const contour::Contour& loop : part.region().loops) loops += output::loop_part(loop);
  add(seen_.front(), loops);
  if (count_ > 0) count_ = static_cast<std::uint32_t>(part.region().loops.size());
}

void PartSight::add(Seen& seen, const std::string& part) {
  if (part.empty()) return;
  const std::uint64_t hash = hash_of(part);
  if (hash == seen.sent) return;
  seen.sent = hash;
  parts_ += part;
  ++count_;
}

}  // namespace kerf::job
