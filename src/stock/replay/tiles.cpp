#include "stock/replay/tiles.hpp"

#include <utility>

#include "stock/dexel/preparation.hpp"
#include "stock/dexel/tri_dexel.hpp"
#include "stock/field/height_field.hpp"
#include "stock/turned/turned_part.hpp"

namespace kerf::stock::replay {
namespace {

/// A value of a model as a content.
template <class Value>
class ContentOf final : public Content {
 public:
  ContentOf(Value value, std::size_t bytes) : value_(std::move(value)), bytes_(bytes) {}

  [[nodiscard]] std::size_t bytes() const override { return bytes_ + sizeof(*this); }
  [[nodiscard]] const Value& value() const { return value_; }

 private:
  Value value_;
  std::size_t bytes_;
};

template <class Value>
Kept kept(Value value, std::size_t bytes = 0) {
  return std::make_shared<ContentOf<Value>>(std::move(value), bytes);
}

template <class Value>
const Value& value_of(const Content& content) {
  return static_cast<const ContentOf<Value>&>(content).value();
}

template <class Item>
std::size_t bytes_of(const std::vector<Item>& items) {
  return items.capacity() * sizeof(Item);
}

class FieldTiles final : public Tiles {
 public:
  explicit FieldTiles(field::HeightField& field) : field_(field) {}

  [[nodiscard]] std::size_t count() const override { return field_.columns().grid().tiles(); }
  [[nodiscard]] std::uint64_t version(std::size_t tile) const override {
    return field_.columns().version(tile);
  }
  [[nodiscard]] Kept keep(std::size_t tile) const override {
    field::TileState state = field_.columns().state(tile);
    const std::size_t bytes = bytes_of(state.heights) + bytes_of(state.owners);
    return kept(std::move(state), bytes);
  }
  void bring_back(std::size_t tile, const Content& content) override {
    field_.restore(tile, value_of<field::TileState>(content));
  }
  [[nodiscard]] Kept keep_trail() const override { return kept(field_.last()); }
  void bring_back_trail(const Content& content) override {
    field_.restore_last(value_of<std::optional<Sweep>>(content));
  }

 private:
  field::HeightField& field_;
};

class DexelTiles final : public Tiles {
 public:
  explicit DexelTiles(dexel::TriDexel& model) : model_(model) {
    for (int grid = 0; grid < 3; ++grid)
      for (std::size_t i = 0; i < model.tiles(grid); ++i) places_.push_back({grid, i});
  }

  [[nodiscard]] std::size_t count() const override { return places_.size(); }
  [[nodiscard]] std::uint64_t version(std::size_t tile) const override {
    return model_.tile(places_[tile].grid, places_[tile].number).changes();
  }
  [[nodiscard]] Kept keep(std::size_t tile) const override {
    dexel::TriDexel::TileState state = model_.save(places_[tile].grid, places_[tile].number);
    const std::size_t bytes = bytes_of(state.counts) + bytes_of(state.ends);
    return kept(std::move(state), bytes);
  }
  void bring_back(std::size_t tile, const Content& content) override {
    static_cast<void>(model_.restore(places_[tile].grid, places_[tile].number,
                                     value_of<dexel::TriDexel::TileState>(content)));
  }
  [[nodiscard]] Kept keep_trail() const override { return kept(model_.trail()); }
  void bring_back_trail(const Content& content) override {
    model_.restore_trail(value_of<dexel::Trail>(content));
  }

 private:
  struct Place {
    int grid;
    std::size_t number;
  };

  dexel::TriDexel& model_;
  std::vector<Place> places_;
};

/// A turned part is one tile.
class TurnedTiles final : public Tiles {
 public:
  explicit TurnedTiles(turned::TurnedPart& part) : part_(part) {}

  [[nodiscard]] std::size_t count() const override { return 1; }
  [[nodiscard]] std::uint64_t version(std::size_t /*tile*/) const override {
    return part_.changes();
  }
  [[nodiscard]] Kept keep(std::size_t /*tile*/) const override {
    return kept(part_.state(), part_.bytes());
  }
  void bring_back(std::size_t /*tile*/, const Content& content) override {
    part_.restore(value_of<turned::TurnedPart::State>(content));
  }
  [[nodiscard]] Kept keep_trail() const override { return kept(0); }
  void bring_back_trail(const Content& /*content*/) override {}

 private:
  turned::TurnedPart& part_;
};

}  // namespace

std::unique_ptr<Tiles> tiles_of(Model& model) {
  if (auto* const field = dynamic_cast<field::HeightField*>(&model))
    return std::make_unique<FieldTiles>(*field);
  if (auto* const dexels = dynamic_cast<dexel::TriDexel*>(&model))
    return std::make_unique<DexelTiles>(*dexels);
  if (auto* const part = dynamic_cast<turned::TurnedPart*>(&model))
    return std::make_unique<TurnedTiles>(*part);
  return nullptr;
}

Keeper::Keeper(Tiles& tiles) : tiles_(tiles) {
  for (std::size_t i = 0; i < tiles.count(); ++i) {
    versions_.push_back(tiles.version(i));
    seen_.tiles.push_back(tiles.keep(i));
  }
  seen_.trail = tiles.keep_trail();
}

const Moment& Keeper::look() {
  for (std::size_t i = 0; i < versions_.size(); ++i) {
    const std::uint64_t version = tiles_.version(i);
    if (version == versions_[i]) continue;
    versions_[i] = version;
    seen_.tiles[i] = tiles_.keep(i);
  }
  seen_.trail = tiles_.keep_trail();
  return seen_;
}

void Keeper::bring_back(const Moment& moment) {
  for (std::size_t i = 0; i < versions_.size(); ++i) {
    if (seen_.tiles[i] == moment.tiles[i] && tiles_.version(i) == versions_[i]) continue;
    tiles_.bring_back(i, *moment.tiles[i]);
    versions_[i] = tiles_.version(i);
    seen_.tiles[i] = moment.tiles[i];
  }
  tiles_.bring_back_trail(*moment.trail);
  seen_.trail = moment.trail;
}

}  // namespace kerf::stock::replay
