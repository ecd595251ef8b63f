#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic_code.hpp"
#include "base/result.hpp"
#include "machine/definition/check_words.hpp"
#include "machine/definition/stock_words.hpp"
#include "stock/cutting/cutting_force.hpp"
#include "stock/cutting/placement.hpp"
#include "stock/tool/tool.hpp"

namespace kerf::machine {

/// What lies on the table, where, and how it is checked (stock.md §2): what a file of a set-up, or
/// the words of a command line, have said of it. What nobody has said is empty. Plain value;
/// nothing that it names has been opened.
struct SetUp {
  /// A shape, and the words that it was said in.
  struct Piece {
    StockWord word{};
    std::string said{};
    std::string name{};  ///< of a fixture; empty: none

    /// As messages call it.
    [[nodiscard]] const std::string& title() const { return name.empty() ? said : name; }
  };
  /// What the part shall be compared with (stock.md §7).
  struct Design {
    StockFile file{};  ///< no path: nobody has said it
    std::optional<stock::Placement> place{};
    std::optional<double> tolerance_mm{};

    [[nodiscard]] bool is_said() const { return !file.path.empty(); }
  };

  std::optional<Piece> stock{};
  std::optional<StockZero> zero{};
  std::optional<stock::Placement> place{};  ///< of the stock
  std::vector<Piece> fixtures{};
  std::optional<stock::CutMaterial> material{};
  std::optional<double> energy_j_mm3{};  ///< that a beam needs to cut it
  std::optional<double> touch_mm{};      ///< what may meet nothing is smaller by so much (§5)
  std::vector<base::Code> left_out{};    ///< checks that are not made
  std::optional<FailOn> fail_on{};
  std::optional<bool> has_real_lengths{};
  std::optional<Design> design{};
  std::vector<stock::Tool> tools{};  ///< the ones that count more first

  /// All that it has to be read.
  [[nodiscard]] std::vector<std::string> files() const;
};

/// Both together: `more` counts more, one thing at a time; fixtures, tools and checks left out add
/// up.
[[nodiscard]] SetUp joined(SetUp more, SetUp less);

/// The set-up in a TOML text (docs/set-up.md); files in it are beside `source`. Failure (input): an
/// unknown key, a value of the wrong kind: a sentence with its line and column.
[[nodiscard]] base::Outcome<SetUp> read_set_up(const std::string& text, const std::string& source);

inline constexpr std::size_t kLargestSetUp = 1 << 20;  ///< bytes of a file

}  // namespace kerf::machine
