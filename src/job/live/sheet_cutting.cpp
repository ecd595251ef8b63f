#include "job/live/sheet_cutting.hpp"

#include <algorithm>
#include <cmath>

#include "output/part/sheet_frame.hpp"

namespace kerf::job {
namespace {

using stock::sheet::Sheet;

class SheetPicture final : public Picture {
 public:
  SheetPicture(const Sheet& sheet, double thickness_mm)
      : sheet_(sheet), thickness_mm_(thickness_mm) {}

  [[nodiscard]] output::PartKind kind() const override { return output::PartKind::sheet; }
  [[nodiscard]] std::size_t tiles() const override { return sheet_.grid().tiles(); }
  // Both only grow.
  [[nodiscard]] std::uint64_t version(std::size_t tile) const override {
    return sheet_.cuts_of(tile) + sheet_.burns_of(tile);
  }
  [[nodiscard]] Parts parts(std::size_t tile) const override {
    const bool is_untouched = sheet_.coverage(tile) == nullptr;
    if (is_untouched) return {.is_empty = true};
    return {output::sheet_part(sheet_, tile), 1, false};
  }
  [[nodiscard]] double removed_mm3() const override { return sheet_.cut_mm2() * thickness_mm_; }
  [[nodiscard]] std::optional<PartPlace> nearest(stock::Vec3 at) const override;

 private:
  const Sheet& sheet_;
  double thickness_mm_;
};

std::optional<PartPlace> SheetPicture::nearest(stock::Vec3 at) const {
  constexpr int kSide = stock::sheet::kTileSide;
  const stock::sheet::Grid& grid = sheet_.grid();
  const double x = std::floor((at.x - grid.box.low.u) / grid.cell_x());
  const double y = std::floor((at.y - grid.box.low.v) / grid.cell_y());
  if (!(x >= 0 && x < grid.nx && y >= 0 && y < grid.ny)) return std::nullopt;
  const int i = static_cast<int>(x);
  const int j = static_cast<int>(y);
  PartPlace place{.at = {grid.x(i), grid.y(j), 0}};
  const auto tile = static_cast<std::size_t>(j / kSide * grid.tiles_x() + i / kSide);
  const auto cell = static_cast<std::size_t>(j % kSide * kSide + i % kSide);
  const Sheet::Coverage* const covered = sheet_.coverage(tile);
  if (covered != nullptr && (*covered)[cell] >= sheet_.cut_from()) return std::nullopt;
  if (const Sheet::Energy* const energy = sheet_.energy(tile))
    place.energy_j_mm2 = static_cast<double>((*energy)[cell]);
  return place;
}

PartLevel level_of(const stock::sheet::Grid& grid) {
  return {
      .cell_mm = std::max(grid.cell_x(), grid.cell_y()),
      .grid = PartGrid{{grid.x(0), grid.y(0)}, {grid.cell_x(), grid.cell_y()}, {grid.nx, grid.ny}}};
}

}  // namespace

SheetCutting::SheetCutting(const SheetBegin& pass, std::uint32_t run, std::size_t memory_bytes)
    : Cutting(pass, run), like_(pass.like), recording_(pass.sheet, {.memory_bytes = memory_bytes}) {
  add_level(level_of(pass.sheet.grid()));
}

void SheetCutting::take(const stock::TimedCut& cut) {
  recording_.tell(static_cast<std::uint32_t>(cut.cut.motion), cut.start_s, cut.end_s);
}

const Picture* SheetCutting::at(double time_s, std::uint32_t /*level*/,
                                const std::stop_token& unwanted) {
  if (!player_) {
    player_ = std::make_unique<stock::replay::SheetPlayer>(like_(), recording_);
    picture_ = std::make_unique<SheetPicture>(player_->sheet(), box().high.z - box().low.z);
  }
  return player_->go_to(time_s, unwanted) ? picture_.get() : nullptr;
}

}  // namespace kerf::job
