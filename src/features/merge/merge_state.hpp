#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "features/merge/block_words.hpp"
#include "features/merge/merge.hpp"
#include "features/merge/text_style.hpp"

namespace kerf::features {

inline constexpr std::array<char, 3> kMergedAxes = {'X', 'Y', 'Z'};

/// What a block commands that later ones inherit, in the words of the program.
struct Inherited {
  std::array<std::optional<double>, 3> axes{};
  std::optional<double> cycle_depth{};
  std::optional<double> peck{};  ///< Q of the cycle in force
  int motion = -1;               ///< 0 to 3; -1: a cycle, or not known
  std::optional<std::string> feed{};
  bool is_compensated = false;
};

/// Whether two texts of a feed say the same.
[[nodiscard]] bool is_same_feed(const std::optional<std::string>& a,
                                const std::optional<std::string>& b);

/// Rows of one block, as they were and as they shall be.
struct BlockRows {
  std::uint32_t block = 0;  ///< its place among the blocks of the recording
  Span old{};
  std::vector<PlannedRow> rows{};  ///< empty: the block goes
};

/// Bytes of a file.
struct Bytes {
  std::uint64_t from = 0;
  std::uint64_t length = 0;
};

[[nodiscard]] double axis_of(Vec3 v, std::size_t axis);
/// 0 to 3: the code that commands a row.
[[nodiscard]] int motion_code(const PlannedRow& row, const State& state);
/// Likewise, if the word is such a code.
[[nodiscard]] std::optional<int> motion_of(const BlockWord& word);

/// Where a merge stands: what the new program has in force, and what has been changed so far.
struct MergeState {
  MergeState(const Recording& recording_rows, const RowPlan& row_plan, const MergeSources& from)
      : recording(recording_rows), plan(row_plan), sources(from) {}

  [[nodiscard]] const base::BlockId& id(std::uint32_t block) const;
  [[nodiscard]] std::string_view text_of(std::uint32_t block) const;
  [[nodiscard]] std::vector<BlockWord> words_in(std::uint32_t block) const;
  [[nodiscard]] Vec3 programmed(const State& state, Vec3 way) const;
  /// The way from where an arc begins to its centre, as words say it: I and J, of a lathe I and K,
  /// with I a radius.
  struct Centre {
    double i = 0;
    double second = 0;
    char second_letter = 'J';
  };
  [[nodiscard]] Centre centre_words(const State& state, Vec3 from, Vec2 centre) const;
  void refuse(base::Code code, std::string sentence);
  [[nodiscard]] bool is_same(double a, double b) const;
  /// In the unit of the program, whether it has a point or not.
  [[nodiscard]] std::optional<double> value_of(const BlockWord& word) const;
  [[nodiscard]] const std::string& file_of(std::uint32_t block) const;
  /// Behind the end of the line that a block stands in.
  [[nodiscard]] std::uint64_t next_line(std::uint32_t block) const;
  /// The next N word behind a block; 0: none is near.
  [[nodiscard]] double next_sequence(std::uint32_t block) const;
  [[nodiscard]] std::string line_end(std::uint32_t block) const;
  [[nodiscard]] static std::string line_end(const std::string& text);
  [[nodiscard]] Bytes line_of(std::uint32_t block) const;
  void put(std::uint32_t block, Bytes where, std::string text);
  /// A feed as the word says it that had `old` in force at a row.
  [[nodiscard]] double feed_word(std::uint32_t row, const std::optional<std::string>& old,
                                 double feed) const;
  [[nodiscard]] std::string feed_text(std::uint32_t row, const std::optional<std::string>& old,
                                      double feed) const;
  /// Behind the block that was written last, and what has come in behind that.
  void put_line(const std::string& line);

  const Recording& recording;
  const RowPlan& plan;
  const MergeSources& sources;
  TextStyle style{};
  double least = 5e-4;  ///< what is no change, in the unit of the program
  Inherited now{};
  Vec3 at{};                              ///< where the new program stands
  std::optional<std::uint32_t> behind{};  ///< block that what comes in stands behind
  struct InPlace {
    base::FileId file = base::kNoFile;
    std::uint64_t at = 0;
  };
  std::optional<InPlace> in_place{};     ///< where a loop or a call stood that is being written out
  std::optional<bool> is_incremental{};  ///< there; none: as the rows were
  double last_number = 0;                ///< N of the last block that came in
  std::map<std::uint32_t, std::optional<std::string>>
      feeds{};  ///< in force at rows, once looked for
  Merged merged{};
  std::optional<CannotMerge> fault{};
};

}  // namespace kerf::features
