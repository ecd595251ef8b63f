#include "face/cli/stock_words.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/decimal.hpp"
#include "base/source_file.hpp"
#include "machine/definition/number_list.hpp"
#include "machine/definition/stock_place.hpp"

namespace kerf::cli {
namespace {

using base::Outcome;
using machine::SetUp;

/// A word that may be missing, read into what it stands for.
template <typename T, typename Read>
Outcome<void> take_word(const std::string& word, const std::string& option, std::optional<T>& into,
                        Read&& read) {
  if (word.empty()) return {};
  auto value = std::forward<Read>(read)(word, option);
  if (!value) return tl::unexpected(value.error());
  into = std::move(*value);
  return {};
}

Outcome<SetUp::Piece> piece_in(const std::string& words, const std::string& option,
                               const std::string& unit) {
  auto word = machine::stock_word(words, option);
  if (!word) return tl::unexpected(word.error());
  if (auto* const file = std::get_if<machine::StockFile>(&*word))
    file->unit = unit == "inch" ? machine::MeshUnit::inch : machine::MeshUnit::mm;
  return SetUp::Piece{std::move(*word), words, {}};
}

Outcome<void> take_shapes(const TableOptions& options, SetUp& set_up) {
  const auto piece = [&](const std::string& words, const std::string& option) {
    return piece_in(words, option, options.unit);
  };
  if (auto taken = take_word(options.stock, "--stock", set_up.stock, piece); !taken) return taken;
  for (const std::string& words : options.fixtures) {
    auto fixture = piece(words, "--fixture");
    if (!fixture) return tl::unexpected(fixture.error());
    set_up.fixtures.push_back(std::move(*fixture));
  }
  if (auto taken = take_word(options.zero, "--stock-zero", set_up.zero, machine::stock_zero);
      !taken)
    return taken;
  return take_word(options.place, "--stock-place", set_up.place, machine::stock_place);
}

Outcome<void> take_checks(const TableOptions& options, SetUp& set_up) {
  for (const std::string& name : options.no_checks) {
    auto check = machine::stock_check(name, "--no-check");
    if (!check) return tl::unexpected(check.error());
    set_up.left_out.push_back(*check);
  }
  if (!options.lengths.empty()) set_up.has_real_lengths = options.lengths == "real";
  if (auto taken = take_word(options.fail_on, "--fail-on", set_up.fail_on, machine::fail_on);
      !taken)
    return taken;
  return take_word(options.material, "--material", set_up.material, machine::cut_material);
}

Outcome<SetUp> read_file(const std::string& path) {
  if (path.empty()) return SetUp{};
  const auto text = base::read_whole(path, machine::kLargestSetUp, "a set-up");
  if (!text) return tl::unexpected(text.error());
  return machine::read_set_up(*text, path);
}

/// A number above 0; none where it is not said.
Outcome<std::optional<double>> size_of(const std::string& word, const std::string& option,
                                       const std::string& what) {
  if (word.empty()) return std::optional<double>{};
  const double size = base::read_number(word).value_or(0);
  if (!(size > 0)) return base::usage(option + " " + word + ": " + what + " has a size");
  return std::optional(size);
}

std::size_t bytes_of(const std::string& mebibytes) {
  constexpr double kMost = 1 << 30;
  return static_cast<std::size_t>(std::min(base::read_number(mebibytes).value_or(0), kMost)) << 20;
}

/// Where the axes begin, machine coordinates as people count them: X, Y and Z as far as there are.
Outcome<void> take_start(const std::string& word, job::StockJob& job) {
  if (word.empty()) return {};
  motion::AxisSetup& axes = job.job.definition.axes;
  std::vector<base::Axis> linear;
  std::string names;
  for (const char letter : {'X', 'Y', 'Z'}) {
    const auto axis = axes.find(letter);
    if (!axis) continue;
    linear.push_back(*axis);
    names += (names.empty() ? "" : ",") + std::string(1, letter);
  }
  const auto numbers = machine::numbers_in(word, linear.size(), linear.size());
  if (!numbers) return base::usage("--start " + word + ": " + names + " is expected, mm");
  for (std::size_t i = 0; i < linear.size(); ++i)
    axes.start[linear[i]] = (*numbers)[i] / axes[linear[i]].count_per_mm();
  job.checks_start = true;
  return {};
}

job::StockModel model_named(const std::string& name) {
  if (name == "zmap") return job::StockModel::zmap;
  if (name == "profile") return job::StockModel::profile;
  if (name == "sheet") return job::StockModel::sheet;
  return name == "tridexel" ? job::StockModel::tridexel : job::StockModel::automatic;
}

}  // namespace

Outcome<SetUp> set_up_of(const TableOptions& options) {
  auto file = read_file(options.set_up);
  if (!file) return tl::unexpected(file.error());
  SetUp words;
  if (auto taken = take_shapes(options, words); !taken) return tl::unexpected(taken.error());
  if (auto taken = take_checks(options, words); !taken) return tl::unexpected(taken.error());
  return joined(std::move(words), std::move(*file));
}

Outcome<bool> has_table(const TableOptions& options) {
  if (!options.stock.empty() || !options.fixtures.empty() || !options.set_up.empty()) return true;
  if (options == TableOptions{}) return false;
  return base::usage(
      "what lies on the table is not said: --stock, beside the options that speak of it");
}

Outcome<void> take_means(const TableOptions& options, job::StockJob& job) {
  job.model = model_named(options.model);
  auto cell = size_of(options.cell, "--cell", "a cell");
  if (!cell) return tl::unexpected(cell.error());
  job.cell_mm = *cell;
  auto kerf = size_of(options.kerf, "--kerf", "a cut");
  if (!kerf) return tl::unexpected(kerf.error());
  job.kerf_mm = *kerf;
  if (!options.memory.empty()) job.memory_bytes = bytes_of(options.memory);
  job.jobs = options.jobs;
  return take_start(options.start, job);
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

}  // namespace kerf::cli
