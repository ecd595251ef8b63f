#include "face/cli/internal/stock_words.hpp"

#include <limits>
#include <utility>

#include "base/decimal.hpp"
#include "machine/definition/stock_place.hpp"

namespace kerf::cli {

using base::Outcome;
using machine::SetUp;

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

Outcome<SetUp> with_design(const CompareOptions& options, SetUp set_up) {
  SetUp words;
  if (!options.design.empty() || !options.design_place.empty()) words.design = SetUp::Design{};
  if (!options.design.empty()) words.design->file.path = options.design;
  if (!options.design_place.empty()) {
    auto place = machine::stock_place(options.design_place, "--design-place");
    if (!place) return tl::unexpected(place.error());
    words.design->place = *place;
  }
  return joined(std::move(words), std::move(set_up));
}

Outcome<stock::compare::Tolerance> tolerance_of(const CompareOptions& options,
                                                const std::optional<SetUp::Design>& design) {
  stock::compare::Tolerance tolerance;
  double both = tolerance.larger();
  if (design && design->tolerance_mm) both = *design->tolerance_mm;
  if (auto taken = take_tolerance("--tolerance", options.tolerance, both); !taken)
    return tl::unexpected(taken.error());
  tolerance = {both, both};
  if (auto taken = take_tolerance("--gouge", options.gouge, tolerance.gouge_mm); !taken)
    return tl::unexpected(taken.error());
  if (auto taken = take_tolerance("--excess", options.excess, tolerance.excess_mm); !taken)
    return tl::unexpected(taken.error());
  return tolerance;
}

Outcome<void> check_comparison(const CompareOptions& options,
                               const std::optional<SetUp::Design>& design) {
  if (!options.against_tools.empty() && options.against.empty())
    return base::usage("--against-tools: without --against there is no other program");
  const bool has_design = design && design->is_said();
  if (!options.design_place.empty() && !has_design)
    return base::usage("--design-place: without --design nothing is compared");
  if (has_design || !options.against.empty()) return {};
  for (const auto& [option, word] :
       {std::pair{"--tolerance", &options.tolerance}, std::pair{"--gouge", &options.gouge},
        std::pair{"--excess", &options.excess}}) {
    if (!word->empty())
      return base::usage(std::string(option) +
                         ": without --design or --against nothing is compared");
  }
  return {};
}

}  // namespace kerf::cli
