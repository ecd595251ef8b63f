#include "machine/definition/check_words.hpp"

#include <algorithm>
#include <array>

#include "base/decimal.hpp"

namespace kerf::machine {
namespace {

using base::Code;

/// Every check of stock.md §5 and §7.
constexpr std::array kStockChecks{Code::rapid_in_stock,
                                  Code::spindle_stopped,
                                  Code::spindle_direction,
                                  Code::flute_length,
                                  Code::shank_collision,
                                  Code::holder_collision,
                                  Code::fixture_collision,
                                  Code::insert_collision,
                                  Code::not_centre_cutting,
                                  Code::axial_tool_sideways,
                                  Code::probe_in_stock,
                                  Code::overtravel_plus,
                                  Code::overtravel_minus,
                                  Code::tap_without_hole,
                                  Code::thread_pitch,
                                  Code::feed_per_tooth,
                                  Code::cut_depth,
                                  Code::cut_width,
                                  Code::cutting_speed,
                                  Code::cutting_power,
                                  Code::tool_length,
                                  Code::stock_loose,
                                  Code::tool_import,
                                  Code::stock_zero_moved,
                                  Code::stock_missed,
                                  Code::cell_enlarged,
                                  Code::gouge,
                                  Code::excess,
                                  Code::differs};

}  // namespace

base::Outcome<stock::CutMaterial> cut_material(const std::string& text, const std::string& option) {
  if (const auto group = stock::material_named(text)) return *group;
  const std::size_t comma = text.find(',');
  if (comma != std::string::npos) {
    const double kc11 = base::read_number(text.substr(0, comma)).value_or(0);
    const double mc = base::read_number(text.substr(comma + 1)).value_or(-1);
    if (kc11 > 0 && mc >= 0 && mc < 1) return stock::CutMaterial{kc11, mc};
  }
  return base::usage(option + " " + text +
                     ": one of P, M, K, N, S, H is expected, or kc11,mc: N/mm² above 0 and an "
                     "exponent from 0 to below 1");
}

base::Outcome<Code> stock_check(const std::string& text, const std::string& option) {
  const auto* const known = std::find_if(kStockChecks.begin(), kStockChecks.end(), [&](Code code) {
    return base::text_of(code).number == text;
  });
  if (known == kStockChecks.end())
    return base::usage(option + " " + text + ": no check of stock has this code");
  return *known;
}

base::Outcome<FailOn> fail_on(std::string_view text, const std::string& option) {
  if (text == "warning") return FailOn::warning;
  if (text == "error") return FailOn::error;
  if (text == "never") return FailOn::never;
  return base::usage(option + " " + std::string(text) + ": error, warning or never is expected");
}

}  // namespace kerf::machine
