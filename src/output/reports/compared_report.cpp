#include "output/reports/compared_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/decimal.hpp"
#include "output/reports/internal/places.hpp"
#include "output/reports/summary.hpp"
#include "output/writing/diagnostic_text.hpp"
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

void add_lines(const std::vector<StockFacts::LineShare>& lines, const std::string& name,
               JsonObject& object) {
  object.raw(name, lines_json(lines));
  if (lines.size() > kMostLinesOfRegion)
    object.number("more_" + name, static_cast<double>(lines.size() - kMostLinesOfRegion));
}

JsonObject region_object(const Region& region, const char* kind, bool turns) {
  JsonObject object;
  object.text("kind", kind);
  object.number("max_mm", tidy(region.max_mm)).number("area_mm2", tidy(region.area_mm2));
  object.number("volume_mm3", tidy(region.volume_mm3)).raw("at", point_json(region.at, turns));
  object.raw("centre", point_json(region.centre, turns));
  object.raw("extents", bounds_json(region.extents, turns));
  return object;
}

std::string region_json(const Region& region, const std::vector<StockFacts::LineShare>& lines,
                        bool turns) {
  JsonObject object = region_object(region, region.side == Side::gouge ? "gouge" : "excess", turns);
  add_lines(lines, "lines", object);
  return object.done();
}

double most_apart(const Comparison& found) {
  return std::max(found.of(Side::gouge).max_mm, found.of(Side::excess).max_mm);
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

std::string against_json(const StockFacts::Against& against, bool turns) {
  const Comparison& found = against.found;
  std::vector<std::string> regions;
  for (std::size_t i = 0; i < found.regions.size(); ++i) {
    const bool is_here = found.regions[i].side == Side::excess;
    JsonObject object =
        region_object(found.regions[i], is_here ? "only_here" : "only_there", turns);
    add_lines(against.lines[i], "lines", object);
    add_lines(against.there[i], "lines_there", object);
    regions.push_back(object.done());
  }
  JsonObject object;
  object.text("file", against.file);
  if (against.status) object.text("status", status_name(*against.status));
  return object.number("tolerance_mm", tidy(found.tolerance.larger()))
      .number("only_here_mm3", tidy(found.of(Side::excess).all_mm3))
      .number("only_there_mm3", tidy(found.of(Side::gouge).all_mm3))
      .number("max_mm", tidy(most_apart(found)))
      .number("regions_here", static_cast<double>(found.of(Side::excess).regions))
      .number("regions_there", static_cast<double>(found.of(Side::gouge).regions))
      .raw("regions", json_array(regions))
      .done();
}

std::string against_text(const StockFacts::Against& against) {
  const Comparison& found = against.found;
  const std::uint64_t regions = found.of(Side::excess).regions + found.of(Side::gouge).regions;
  const std::string beyond =
      regions == 0 ? "within"
                   : fmt::format("{} {} beyond", regions, regions == 1 ? "region" : "regions");
  const bool is_whole = against.status.value_or(RunFacts::Status::end) == RunFacts::Status::end;
  const std::string ended = is_whole ? "" : " (" + status_name(*against.status) + ")";
  return fmt::format(
      "  against {}{}: {:.1f} mm³ only here, {:.1f} mm³ only there, {:.3f} mm at most, {} {:.4g}\n",
      printable(against.file), ended, found.of(Side::excess).all_mm3, found.of(Side::gouge).all_mm3,
      most_apart(found), beyond, found.tolerance.larger());
}

}  // namespace kerf::output
