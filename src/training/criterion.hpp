#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kerf::training {

/// One thing that a program is judged by.
struct Criterion {
  enum class Kind : std::uint8_t {
    ends,    ///< without an alarm
    all,     ///< it cuts what is to be cut
    only,    ///< and nothing else
    rapids,  ///< none goes through the work
    checks,  ///< of the part: nothing is met that should not be
    time,
    lines
  };
  /// What was found: one sentence for each, with values.
  enum class Finding : std::uint8_t {
    well,
    alarm,           ///< `code`, `message`
    no_end,          ///< a limit was reached: `message`
    too_long,        ///< mm at feed: the run was broken off
    nothing_cut,     ///< no cut at all
    missing,         ///< mm, percent: is not cut, first at x y z
    other_tool,      ///< wanted, got: at x y z
    other_power,     ///< wanted, got
    spindle_stands,  ///< at x y z
    other_slant,     ///< rotary axes stand elsewhere, at x y z
    wrong_cut,       ///< mm: cut and not asked for, off_mm at x y z
    low_rapid,       ///< moves in X or Y at z, below clearance
    plunge,          ///< rapid into the work at x y z, of a turned part x (a diameter) and z
    too_slow,        ///< got_s, most_s
    not_timed,       ///< since it does not end
    too_many_lines,  ///< got, most
    excess,          ///< mm3 too much are left, max_mm at x y z
    gouge,           ///< mm3 too much are cut away, max_mm deep at x y z
    found,           ///< `code`, `message`: a finding, at x y z
    found_more,      ///< likewise, and more of them
    no_tool,         ///< got: it is none of the exercise
    no_part          ///< `message`: it cannot be cut here
  };
  using Values = std::vector<std::pair<std::string_view, double>>;

  Kind kind{};
  int most = 0;
  /// How well, 0 to 1: 1 only if there is nothing to mend.
  double quality = 0;
  int points = 0;
  Finding finding{};
  Values values;
  std::string code;        ///< of the alarm, or of the limit
  std::string message;     ///< likewise
  std::string file;        ///< where; empty: nowhere
  std::uint32_t line = 0;  ///< from 1; 0: none

  [[nodiscard]] bool met() const { return finding == Finding::well; }
};

[[nodiscard]] std::string_view name_of(Criterion::Kind kind);
[[nodiscard]] std::string_view name_of(Criterion::Finding finding);
/// In English, with the values.
[[nodiscard]] std::string sentence_of(const Criterion& criterion);

}  // namespace kerf::training
