#include "machine/definition/stock_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/decimal.hpp"
#include "machine/definition/number_list.hpp"

namespace kerf::machine {
namespace {

using stock::BoxShape;
using stock::CylinderShape;
using Word = base::Outcome<StockWord>;

struct Text {
  std::string_view word;    // before the colon
  std::string_view values;  // behind it
  std::string said;         // option and text, for sentences
};

tl::unexpected<base::Failure> wrong(const Text& text, const std::string& what) {
  return base::usage(text.said + ": " + what);
}

Word box(const Text& text) {
  const auto n = numbers_in(text.values, 6, 6);
  if (!n) return wrong(text, "box:X0,Y0,Z0,X1,Y1,Z1 takes six numbers");
  const BoxShape box{{(*n)[0], (*n)[1], (*n)[2]}, {(*n)[3], (*n)[4], (*n)[5]}};
  if (!(box.low.x < box.high.x && box.low.y < box.high.y && box.low.z < box.high.z))
    return wrong(text, "X0, Y0 and Z0 must lie below X1, Y1 and Z1");
  return stock::Workpiece(box);
}

Word round(const Text& text, bool is_tube) {
  const std::string form = is_tube ? "tube:AXIS,U,V,W0,W1,D,DI takes X, Y or Z and six numbers"
                                   : "cylinder:AXIS,U,V,W0,W1,D takes X, Y or Z and five numbers";
  const std::size_t comma = std::min(text.values.find(','), text.values.size());
  const std::string_view axis = text.values.substr(0, comma);
  const std::size_t count = is_tube ? 6 : 5;
  const auto n = comma < text.values.size()
                     ? numbers_in(text.values.substr(comma + 1), count, count)
                     : std::nullopt;
  if (!n || axis.size() != 1 || axis < "X" || axis > "Z") return wrong(text, form);
  CylinderShape shape{axis[0] - 'X', (*n)[0], (*n)[1], (*n)[2], (*n)[3], (*n)[4]};
  if (is_tube) shape.inner_diameter = (*n)[5];
  if (!(shape.from < shape.to)) return wrong(text, "W0 must lie below W1");
  if (!(shape.inner_diameter >= 0 && shape.diameter > shape.inner_diameter))
    return wrong(text,
                 is_tube ? "D must be larger than DI, and DI not negative" : "D must be positive");
  return stock::Workpiece(shape);
}

Word bar(const Text& text) {
  const auto n = numbers_in(text.values, 3, 4);
  if (!n) return wrong(text, "bar:D,Z0,Z1[,DI] takes three or four numbers");
  const StockBar bar{(*n)[0], (*n)[1], (*n)[2], n->size() > 3 ? (*n)[3] : 0};
  if (!(bar.z0 < bar.z1)) return wrong(text, "Z0 must lie below Z1");
  if (!(bar.inner_diameter >= 0 && bar.diameter > bar.inner_diameter))
    return wrong(text, "D must be larger than DI, and DI not negative");
  return bar;
}

Word sheet(const Text& text) {
  const auto n = numbers_in(text.values, 5, 5);
  if (!n) return wrong(text, "sheet:X0,Y0,X1,Y1,T takes five numbers");
  const StockSheet sheet{(*n)[0], (*n)[1], (*n)[2], (*n)[3], (*n)[4]};
  if (!(sheet.x0 < sheet.x1 && sheet.y0 < sheet.y1 && sheet.thickness > 0))
    return wrong(text, "X0 and Y0 must lie below X1 and Y1, and T be positive");
  return sheet;
}

Word around(const Text& text) {
  if (text.values.empty()) return StockAround{};
  const auto n = numbers_in(text.values, 1, 1);
  if (!n || (*n)[0] < 0) return wrong(text, "extents:M takes a margin, 0 or more");
  return StockAround{(*n)[0]};
}

}  // namespace

Word stock_word(std::string_view said, const std::string& option) {
  const std::size_t colon = std::min(said.find(':'), said.size());
  const Text text{said.substr(0, colon),
                  colon < said.size() ? said.substr(colon + 1) : std::string_view{},
                  option + " " + std::string(said)};
  if (text.word == "box") return box(text);
  if (text.word == "cylinder") return round(text, false);
  if (text.word == "tube") return round(text, true);
  if (text.word == "bar") return bar(text);
  if (text.word == "sheet") return sheet(text);
  if (text.word == "extents") return around(text);
  if (said.empty())
    return wrong(text, "box:…, cylinder:…, tube:…, bar:…, sheet:…, extents or a file is expected");
  return StockFile{std::string(said)};
}

base::Outcome<StockZero> stock_zero(std::string_view text, const std::string& option) {
  using Kind = StockZero::Kind;
  if (text == "auto") return StockZero{};
  if (text == "machine") return StockZero{.kind = Kind::machine};
  if (text.size() == 3 && text.substr(0, 2) == "G5" && text[2] >= '4' && text[2] <= '9')
    return StockZero{.kind = Kind::system, .index = static_cast<std::uint32_t>(text[2] - '4')};
  constexpr std::string_view kExtended = "G54.1P";
  if (text.substr(0, kExtended.size()) == kExtended) {
    const auto p = base::read_number(text.substr(kExtended.size()));
    if (p && *p >= 1 && *p <= 300 && *p == std::floor(*p))
      return StockZero{.kind = Kind::system, .extended = static_cast<std::uint32_t>(*p)};
  }
  return base::usage(option + " " + std::string(text) +
                     ": G54 to G59, G54.1P1 to G54.1P300, machine or auto is expected");
}

std::string name_of(const StockZero& zero) {
  if (zero.kind == StockZero::Kind::machine) return "machine";
  if (zero.kind == StockZero::Kind::automatic) return "auto";
  if (zero.extended > 0) return fmt::format("G54.1P{}", zero.extended);
  return fmt::format("G{}", 54 + zero.index);
}

}  // namespace kerf::machine
