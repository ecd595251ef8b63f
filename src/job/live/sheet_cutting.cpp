#include "job/live/sheet_cutting.hpp"

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

 private:
  const Sheet& sheet_;
  double thickness_mm_;
};

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
