#include "output/reports/compared_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/decimal.hpp"
#include "output/reports/internal/places.hpp"
#include "output/writing/json_object.hpp"

namespace kerf::output {
namespace {

using base::tidy;
using stock::compare::Comparison;
using stock::compare::Region;
using stock::compare::Side;

/// Of a region that more lines have cut the others are counted.
constexpr std::size_t kMostLinesOfRegion = 100;

std::string total_json(const Comparison& found, Side side) {
  const Comparison::Total& total = found.of(side);
  return JsonObject()
      .number("tolerance_mm", tidy(found.tolerance.of(side)))
      .number("max_mm", tidy(total.max_mm))
      .number("volume_mm3", tidy(total.volume_mm3))
      .number("regions", static_cast<double>(total.regions))
      .done();
}

std::string lines_json(const std::vector<StockFacts::LineShare>& lines) {
  std::vector<std::string> items;
  for (std::size_t i = 0; i < std::min(kMostLinesOfRegion, lines.size()); ++i) {
    items.push_back(JsonObject()
                        .text("file", lines[i].file)
                        .number("line", lines[i].line)
                        .number("share", tidy(lines[i].share))
                        .done());
  }
  return json_array(items);
}

std::string region_json(const Region& region, const std::vector<StockFacts::LineShare>& lines,
                        bool turns) {
  JsonObject object;
  object.text("kind", region.side == Side::gouge ? "gouge" : "excess");
  object.number("max_mm", tidy(region.max_mm)).number("area_mm2", tidy(region.area_mm2));
  object.number("volume_mm3", tidy(region.volume_mm3)).raw("at", point_json(region.at, turns));
  object.raw("centre", point_json(region.centre, turns));
  object.raw("extents", bounds_json(region.extents, turns)).raw("lines", lines_json(lines));
  if (lines.size() > kMostLinesOfRegion)
    object.number("more_lines", static_cast<double>(lines.size() - kMostLinesOfRegion));
  return object.done();
}

}  // namespace

std::string compared_json(const StockFacts::Compared& compared, bool turns) {
  const Comparison& found = compared.found;
  std::vector<std::string> regions;
  for (std::size_t i = 0; i < found.regions.size(); ++i)
    regions.push_back(region_json(found.regions[i], compared.lines[i], turns));
  return JsonObject()
      .number("tolerance_mm", tidy(found.tolerance.larger()))
      .raw("gouge", total_json(found, Side::gouge))
      .raw("excess", total_json(found, Side::excess))
      .raw("regions", json_array(regions))
      .raw("histogram", numbers_json({found.histogram.begin(), found.histogram.end()}))
      .done();
}

std::string compared_text(const StockFacts::Compared& compared) {
  const Comparison& found = compared.found;
  const auto side = [&](Side of, const char* what) {
    const Comparison::Total& total = found.of(of);
    const std::string most = fmt::format("{} {:.3f} mm at most", what, total.max_mm);
    if (total.regions == 0) return most + fmt::format(", within {:.4g}", found.tolerance.of(of));
    return most + fmt::format(", {:.1f} mm³ in {} {} beyond {:.4g}", total.volume_mm3,
                              total.regions, total.regions == 1 ? "region" : "regions",
                              found.tolerance.of(of));
  };
  return fmt::format("  against the design: {}; {}\n", side(Side::gouge, "too deep"),
                     side(Side::excess, "too high"));
}

}  // namespace kerf::output
