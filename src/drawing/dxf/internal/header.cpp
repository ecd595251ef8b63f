#include "drawing/dxf/internal/header.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>

#include "drawing/units.hpp"

namespace kerf::drawing::dxf {
namespace {

constexpr std::string_view kRelease12 = "AC1009";
constexpr std::string_view kFirstUnicode = "AC1021";  // release 2007

struct NumberedUnit {
  std::string_view name;
  double mm = 0;
};

/// $INSUNITS from 1 on (DXF Reference, "HEADER section").
constexpr std::array<NumberedUnit, 17> kUnits{{{"in", 25.4},
                                               {"ft", 304.8},
                                               {"mi", 1609344},
                                               {"mm", 1},
                                               {"cm", 10},
                                               {"m", 1000},
                                               {"km", 1e6},
                                               {"uin", 2.54e-5},
                                               {"mil", 0.0254},
                                               {"yd", 914.4},
                                               {"angstrom", 1e-7},
                                               {"nm", 1e-6},
                                               {"um", 1e-3},
                                               {"dm", 100},
                                               {"dam", 1e4},
                                               {"hm", 1e5},
                                               {"Gm", 1e12}}};

std::optional<NumberedUnit> unit_of(double number) {
  const int index = integer_of(number);
  if (index < 1 || index > static_cast<int>(kUnits.size())) return std::nullopt;
  return kUnits[static_cast<std::size_t>(index - 1)];
}

void set_unit(Canvas& canvas, const NumberedUnit& unit, std::string_view from) {
  canvas.facts().unit = unit.name;
  canvas.facts().scale_mm = unit.mm;
  canvas.facts().unit_from = from;
}

void assume(Canvas& canvas, const Header& header, const NumberedUnit& unit, std::string_view from,
            const std::string& why) {
  set_unit(canvas, unit, from);
  canvas.find(base::Severity::warning, base::Code::draw_unit,
              {base::kNoFile, std::max(1U, header.unit_line), 1},
              fmt::format("{}: {} it is", why, unit.name == "in" ? "inches" : unit.name), {}, {},
              "--unit says another one");
}

}  // namespace

Header header_of(const Record& section) {
  Header header;
  std::string_view variable;
  for (const Group& group : section.groups()) {
    if (group.code == 9) variable = section.text_of(group);
    if (variable == "$ACADVER" && group.code == 1) header.version = section.text_of(group);
    if (variable == "$DWGCODEPAGE" && group.code == 3) header.code_page = section.text_of(group);
    if (variable == "$MEASUREMENT" && group.code == 70) header.metric = group.number;
    if (variable != "$INSUNITS" || group.code != 70) continue;
    header.unit = group.number;
    header.unit_line = group.line;
  }
  return header;
}

void choose_words(const Header& header, Sheet& sheet) {
  // Names of releases ascend as words do.
  if (header.version >= kFirstUnicode) return sheet.words.choose_utf8();
  if (header.code_page.empty() || sheet.words.choose(header.code_page)) return;
  sheet.canvas.ignore("code page " + quoted(header.code_page), 1,
                      "it is not known: words are read as UTF-8 or as those of Windows");
}

void choose_unit(const Header& header, Canvas& canvas) {
  const Reading& reading = canvas.reading();
  const double dpi = reading.dpi > 0 ? reading.dpi : kDpi;
  if (const auto mm = mm_of_unit(reading.unit, dpi); mm && !reading.unit.empty())
    return set_unit(canvas, {reading.unit, *mm}, "--unit");
  if (const auto unit = unit_of(header.unit)) return set_unit(canvas, *unit, "$INSUNITS");
  const bool is_known = header.unit == 0;
  const std::string why = is_known
                              ? "the file names none"
                              : fmt::format("the file names number {} ($INSUNITS)", header.unit);
  const bool knows_measurement = header.version != kRelease12;
  if (knows_measurement && header.metric == 0)
    return assume(canvas, header, {"in", 25.4}, "$MEASUREMENT", why + ", and $MEASUREMENT is 0");
  if (knows_measurement && header.metric == 1)
    return assume(canvas, header, {"mm", 1}, "$MEASUREMENT", why + ", and $MEASUREMENT is 1");
  assume(canvas, header, {"mm", 1}, "assumed", why);
}

}  // namespace kerf::drawing::dxf
