#include "stock/replay/sheet_tiles.hpp"

namespace kerf::stock::replay {
namespace {

using sheet::Sheet;

/// The cells of a tile; none: nothing came to it.
template <class Cells>
class SheetContent final : public Content {
 public:
  explicit SheetContent(const Cells* cells)
      : cells_(cells == nullptr ? nullptr : std::make_unique<Cells>(*cells)) {}

  [[nodiscard]] std::size_t bytes() const override {
    return sizeof(*this) + (cells_ ? sizeof(Cells) : 0);
  }
  [[nodiscard]] const Cells* cells() const { return cells_.get(); }

 private:
  std::unique_ptr<const Cells> cells_;
};

/// Sheets remember nothing beside their tiles.
class NoTrail final : public Content {
 public:
  [[nodiscard]] std::size_t bytes() const override { return sizeof(*this); }
};

template <class Cells, auto kCells, auto kChanges, auto kRestore>
class TilesOfSheet final : public Tiles {
 public:
  explicit TilesOfSheet(Sheet& sheet) : sheet_(sheet) {}

  [[nodiscard]] std::size_t count() const override { return sheet_.grid().tiles(); }
  [[nodiscard]] std::uint64_t version(std::size_t tile) const override {
    return (sheet_.*kChanges)(tile);
  }
  [[nodiscard]] Kept keep(std::size_t tile) const override {
    const Cells* const cells = (sheet_.*kCells)(tile);
    return cells == nullptr ? nothing_ : std::make_shared<SheetContent<Cells>>(cells);
  }
  void bring_back(std::size_t tile, const Content& kept) override {
    // It held this before: the memory holds it again.
    static_cast<void>(
        (sheet_.*kRestore)(tile, static_cast<const SheetContent<Cells>&>(kept).cells()));
  }
  [[nodiscard]] Kept keep_trail() const override { return trail_; }
  void bring_back_trail(const Content& /*kept*/) override {}

 private:
  Sheet& sheet_;
  Kept nothing_ = std::make_shared<SheetContent<Cells>>(nullptr);
  Kept trail_ = std::make_shared<NoTrail>();
};

}  // namespace

std::unique_ptr<Tiles> coverage_tiles(Sheet& sheet) {
  return std::make_unique<
      TilesOfSheet<Sheet::Coverage, &Sheet::coverage, &Sheet::cuts_of, &Sheet::restore_coverage>>(
      sheet);
}

std::unique_ptr<Tiles> energy_tiles(Sheet& sheet) {
  return std::make_unique<
      TilesOfSheet<Sheet::Energy, &Sheet::energy, &Sheet::burns_of, &Sheet::restore_energy>>(sheet);
}

}  // namespace kerf::stock::replay
