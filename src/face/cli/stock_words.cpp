#include "face/cli/stock_words.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "base/decimal.hpp"

namespace kerf::cli {
namespace {

using base::Code;
using base::Outcome;

/// Every check of stock.md §5 and §7.
constexpr std::array kChecks{Code::rapid_in_stock,
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
                             Code::excess};

}  // namespace

Outcome<std::optional<stock::CutMaterial>> material_of(const std::string& word) {
  if (word.empty()) return std::optional<stock::CutMaterial>{};
  if (const auto group = stock::material_named(word)) return group;
  const std::size_t comma = word.find(',');
  if (comma != std::string::npos) {
    const double kc11 = base::read_number(word.substr(0, comma)).value_or(0);
    const double mc = base::read_number(word.substr(comma + 1)).value_or(-1);
    if (kc11 > 0 && mc >= 0 && mc < 1) return std::optional(stock::CutMaterial{kc11, mc});
  }
  return base::usage("--material " + word +
                     ": one of P, M, K, N, S, H is expected, or kc11,mc: N/mm² above 0 and an "
                     "exponent from 0 to below 1");
}

Outcome<std::vector<Code>> left_out_of(const std::vector<std::string>& names) {
  std::vector<Code> codes;
  for (const std::string& name : names) {
    const auto* const known = std::find_if(kChecks.begin(), kChecks.end(), [&](Code code) {
      return base::text_of(code).number == name;
    });
    if (known == kChecks.end())
      return base::usage("--no-check " + name + ": no check of stock has this code");
    codes.push_back(*known);
  }
  return codes;
}

Outcome<std::optional<job::CutUntil>> until_of(const std::string& word) {
  if (word.empty()) return std::optional<job::CutUntil>{};
  if (word.back() == 's') {
    const double time_s = base::read_number(word.substr(0, word.size() - 1)).value_or(-1);
    if (time_s >= 0) return std::optional(job::CutUntil{.time_s = time_s});
  } else if (const auto line = base::read_whole_number(word);
             line && *line > 0 && *line <= std::numeric_limits<std::uint32_t>::max()) {
    return std::optional(job::CutUntil{.line = static_cast<std::uint32_t>(*line)});
  }
  return base::usage("--until " + word + ": a line is expected, or seconds as in 12.5s");
}

namespace {

// More is no tolerance of a part.
constexpr double kLargestTolerance_mm = 100;

Outcome<void> take_tolerance(const std::string& option, const std::string& word, double& mm) {
  if (word.empty()) return {};
  mm = base::read_number(word).value_or(0);
  if (mm > 0 && mm <= kLargestTolerance_mm) return {};
  return base::usage(option + " " + word + ": a number above 0 is expected, and no more than " +
                     base::number_text(kLargestTolerance_mm) + " mm");
}

}  // namespace

Outcome<stock::compare::Tolerance> tolerance_of(const CompareOptions& options) {
  stock::compare::Tolerance tolerance;
  double both = tolerance.larger();
  if (auto taken = take_tolerance("--tolerance", options.tolerance, both); !taken)
    return tl::unexpected(taken.error());
  tolerance = {both, both};
  if (auto taken = take_tolerance("--gouge", options.gouge, tolerance.gouge_mm); !taken)
    return tl::unexpected(taken.error());
  if (auto taken = take_tolerance("--excess", options.excess, tolerance.excess_mm); !taken)
    return tl::unexpected(taken.error());
  return tolerance;
}

Outcome<void> check_comparison(const CompareOptions& options) {
  if (!options.design.empty()) return {};
  for (const auto& [option, word] :
       {std::pair{"--tolerance", &options.tolerance}, std::pair{"--gouge", &options.gouge},
        std::pair{"--excess", &options.excess}}) {
    if (!word->empty())
      return base::usage(std::string(option) + ": without --design nothing is compared");
  }
  return {};
}

}  // namespace kerf::cli
