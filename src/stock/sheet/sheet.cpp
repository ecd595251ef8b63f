#include "stock/sheet/sheet.hpp"

#include <limits>

#include "base/each_by_threads.hpp"
#include "stock/sheet/internal/tile_painter.hpp"

namespace kerf::stock::sheet {
namespace {

constexpr std::uint32_t kMissing = std::numeric_limits<std::uint32_t>::max();
// So many items are shared out at a time; more do not make threads meet less often.
constexpr std::size_t kAtOnce = 1 << 16;
// Threads take longer to begin than so many items in tiles to do.
constexpr std::size_t kWorthThreads = 1000;

Box box_of(const Trace& trace) { return extents(trace); }
Box box_of(const Burn& burn) {
  Box box;
  box.take(burn.from);
  box.take(burn.to);
  return box;
}

double distance_of(const Trace& trace, Vec2 place) { return distance(trace, place); }
double distance_of(const Burn& burn, Vec2 place) {
  return DistanceToLine(burn.from, burn.to)(place.u, place.v);
}

bool is_finite(Vec2 v) { return std::isfinite(v.u) && std::isfinite(v.v); }
bool is_sound(const Burn& burn) {
  return is_finite(burn.from) && is_finite(burn.to) && burn.energy_j > 0 &&
         std::isfinite(burn.energy_j);
}
bool is_sound(const Trace& trace) {
  return is_finite(trace.from) && is_finite(trace.to) && is_finite(trace.centre) &&
         std::isfinite(trace.radius);
}

}  // namespace

Sheet::Sheet(const Grid& grid, const Settings& settings)
    : grid_(grid), settings_(settings), places_(grid.tiles()) {
  const std::size_t fixed = places_.size() * sizeof(std::uint32_t);
  const std::size_t room = settings.memory_bytes - std::min(fixed, settings.memory_bytes);
  most_tiles_ = std::max<std::size_t>(1, room / bytes_of_tile());
}

std::size_t Sheet::bytes_of_tile() const {
  return sizeof(Tile) + sizeof(tiles_[0]) + (settings_.spot_mm > 0 ? sizeof(Energy) : 0);
}

std::size_t Sheet::bytes() const {
  return places_.size() * sizeof(std::uint32_t) + tiles_.size() * bytes_of_tile();
}

Sheet::Tile* Sheet::touch(std::size_t tile) {
  std::uint32_t& place = places_[tile];
  if (place == 0 && tiles_.size() >= most_tiles_) {
    place = kMissing;
    ++missing_;
  }
  if (place == kMissing) return nullptr;
  if (place == 0) {
    tiles_.push_back(std::make_unique<Tile>());
    if (settings_.spot_mm > 0) tiles_.back()->energy = std::make_unique<Energy>();
    place = static_cast<std::uint32_t>(tiles_.size());
  }
  return tiles_[place - 1].get();
}

void Sheet::cut(std::span<const Trace> traces) {
  work(traces, (settings_.kerf_mm + grid_.cell()) / 2);
}

void Sheet::burn(std::span<const Burn> burns) {
  if (settings_.spot_mm > 0) work(burns, settings_.spot_mm / 2);
}

template <typename Item>
void Sheet::work(std::span<const Item> items, double reach) {
  while (!items.empty()) {
    const std::span<const Item> some = items.first(std::min(items.size(), kAtOnce));
    items = items.subspan(some.size());
    TileList list(grid_);
    for (std::uint32_t i = 0; i < some.size(); ++i) {
      const Item& item = some[i];
      if (!is_sound(item)) continue;
      list.add(i, box_of(item).grown(reach), reach,
               [&](Vec2 place) { return distance_of(item, place); });
    }
    const std::vector<TileList::Run> runs = list.runs();
    std::vector<Tile*> tiles;
    for (const TileList::Run& run : runs) tiles.push_back(touch(run.tile));
    const std::size_t jobs = list.size() < kWorthThreads ? 1 : settings_.jobs;
    base::each_by_threads(runs.size(), jobs, [&](std::size_t n) {
      if (tiles[n] == nullptr) return;
      const TilePainter painter(grid_, runs[n].tile);
      for (std::size_t i = runs[n].first; i < runs[n].end; ++i) {
        const Item& item = some[list.number(i)];
        if constexpr (std::is_same_v<Item, Trace>) {
          painter.cut(item, settings_.kerf_mm, tiles[n]->coverage);
          ++tiles[n]->cuts;
        } else {
          painter.burn(item, settings_.spot_mm, *tiles[n]->energy);
          ++tiles[n]->burns;
        }
      }
    });
  }
}

const Sheet::Tile* Sheet::touched(std::size_t tile) const {
  const std::uint32_t place = places_[tile];
  return place == 0 || place == kMissing ? nullptr : tiles_[place - 1].get();
}

const Sheet::Coverage* Sheet::coverage(std::size_t tile) const {
  const Tile* const known = touched(tile);
  return known == nullptr ? nullptr : &known->coverage;
}

const Sheet::Energy* Sheet::energy(std::size_t tile) const {
  const Tile* const known = touched(tile);
  return known == nullptr ? nullptr : known->energy.get();
}

std::uint64_t Sheet::cuts_of(std::size_t tile) const {
  const Tile* const known = touched(tile);
  return known == nullptr ? 0 : known->cuts;
}

std::uint64_t Sheet::burns_of(std::size_t tile) const {
  const Tile* const known = touched(tile);
  return known == nullptr ? 0 : known->burns;
}

bool Sheet::restore_coverage(std::size_t tile, const Coverage* cells) {
  if (cells == nullptr && touched(tile) == nullptr) return true;
  Tile* const known = touch(tile);
  if (known == nullptr) return false;
  known->coverage = cells == nullptr ? Coverage{} : *cells;
  ++known->cuts;
  return true;
}

bool Sheet::restore_energy(std::size_t tile, const Energy* cells) {
  if (cells == nullptr && touched(tile) == nullptr) return true;
  Tile* const known = touch(tile);
  if (known == nullptr) return false;
  if (!known->energy) return true;
  *known->energy = cells == nullptr ? Energy{} : *cells;
  ++known->burns;
  return true;
}

std::uint8_t Sheet::cut_from() const {
  constexpr double kHalf = 127.5;
  const double share = settings_.kerf_mm / grid_.cell();
  return static_cast<std::uint8_t>(share >= 1 ? 128 : std::max(1.0, std::floor(kHalf * share)));
}

double Sheet::cut_mm2() const {
  std::uint64_t sum = 0;
  for (const std::unique_ptr<Tile>& tile : tiles_) {
    for (const std::uint8_t cell : tile->coverage) sum += cell;
  }
  return static_cast<double>(sum) / 255 * grid_.cell_mm2();
}

double Sheet::peak_j_mm2() const {
  float peak = 0;
  for (const std::unique_ptr<Tile>& tile : tiles_) {
    if (tile->energy)
      peak = std::max(peak, *std::max_element(tile->energy->begin(), tile->energy->end()));
  }
  return static_cast<double>(peak);
}

double Sheet::energy_on_sheet_j() const {
  double sum = 0;
  for (std::size_t place = 0; place < places_.size(); ++place) {
    const Energy* const cells = energy(place);
    if (cells == nullptr) continue;
    double of_tile = 0;
    for (const float cell : *cells) of_tile += static_cast<double>(cell);
    sum += of_tile;
  }
  return sum * grid_.cell_mm2();
}

}  // namespace kerf::stock::sheet
