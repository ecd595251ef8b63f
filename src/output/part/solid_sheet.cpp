#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/decimal.hpp"
#include "output/part/internal/sheet_parts.hpp"
#include "output/part/internal/solid_view.hpp"
#include "output/part/part_picture.hpp"

namespace kerf::output {
namespace {

using namespace plot;

constexpr double kSolidLowest = 420, kSolidHighest = 760;

/// Three numbers with commas between.
std::optional<Vec3> direction(const std::string& words) {
  std::array<double, 3> parts{};
  std::size_t from = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t comma = words.find(',', from);
    if ((comma == std::string::npos) != (i == 2)) return {};
    const auto number = base::read_number(words.substr(from, comma - from));
    if (!number) return {};
    parts[i] = *number;
    from = comma + 1;
  }
  if (parts == std::array<double, 3>{}) return {};
  return Vec3{parts[0], parts[1], parts[2]};
}

std::string about(const PartScene& scene, const PartView& view) {
  const std::string seen = view.name == "iso"     ? "isometric from the front right"
                           : view.name == "lathe" ? "Z to the right, C 0 up"
                           : view.name.find(',') != std::string::npos
                               ? "seen from " + view.name
                               : "seen from the " + view.name;
  const StockFacts& facts = *scene.facts;
  const std::string ended =
      facts.run.alarm ? "The part when the alarm came" : "The part as it is left";
  return ended + " \u00b7 " + seen;
}

}  // namespace

PartView lathe_view() {
  PartView view{"lathe", {}};
  view.camera.toward = unit(Vec3{0.50, 0.74, 0.45});
  view.camera.right = unit(cross(Vec3{1, 0, 0}, view.camera.toward));
  view.camera.up = cross(view.camera.toward, view.camera.right);
  return view;
}

std::optional<PartView> part_view(const std::string& words) {
  if (words == "iso") return PartView{};
  if (words == "top") return PartView{words, Camera::from({0, 0, 1})};
  if (words == "front") return PartView{words, Camera::from({0, -1, 0})};
  if (words == "left") return PartView{words, Camera::from({-1, 0, 0})};
  const auto toward = direction(words);
  if (!toward) return {};
  return PartView{words, Camera::from(*toward)};
}

DisplayList draw_solid(const PartScene& scene, const PartView& view) {
  const Paints paints(scene);
  DisplayList sheet;
  sheet.width = kSheetWidth;
  draw_head(sheet, scene, about(scene, view));
  const SolidView solid(scene, paints, view.camera);
  const double height = std::clamp(solid.height_for(kSheetInner), kSolidLowest, kSolidHighest);
  const Rect frame{kSheetMargin, kPictureTop, kSheetInner, std::round(height)};
  solid.draw(sheet, frame);
  draw_foot(sheet, frame.bottom() + 18, scene, paints);
  return sheet;
}

}  // namespace kerf::output
