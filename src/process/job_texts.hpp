#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "base/diagnostic.hpp"
#include "base/result.hpp"
#include "process/recipe.hpp"

namespace kerf::process {

/// Numbers of the copies of a job, one each: {serial}.
class Serials {
 public:
  /// The largest that a file may keep.
  static constexpr std::uint64_t kMost = 1'000'000'000'000'000;

  explicit Serials(const TextWords& words)
      : first_(words.serial_start.value_or(1)),
        step_(words.serial_step),
        width_(words.serial_width) {}

  /// That of the first copy becomes what another run has left.
  void begin_with(std::uint64_t first) { first_ = first; }
  /// Of a copy from 0: with zeros in front, as wide as the job says.
  [[nodiscard]] std::string text(std::uint64_t copy) const;
  /// With which a run goes on that follows one of so many copies.
  [[nodiscard]] std::uint64_t behind(std::uint64_t copies) const { return first_ + copies * step_; }

 private:
  std::uint64_t first_;
  std::uint64_t step_;
  std::uint32_t width_;
};

/// The number that a file keeps for the next run; `otherwise` where there is no such file. Failure
/// (input): it holds something else.
[[nodiscard]] base::Outcome<std::uint64_t> kept_serial(const std::string& path,
                                                       std::uint64_t otherwise);
/// For when a run has ended. The file appears whole or stays as it was.
[[nodiscard]] base::Outcome<void> keep_serial(const std::string& path, std::uint64_t next);

/// Names of variables, and what they stand for.
using TextVariables = std::map<std::string, std::string>;

/// The words with what {NAME} stands for, {{ a brace: JOB_TEXT at `place` where nothing gives a
/// value to a name, or where a brace is not closed. What a variable stands for is taken as it is.
[[nodiscard]] base::Result<std::string> filled_words(std::string_view words,
                                                     const TextVariables& variables,
                                                     const base::Place& place);

/// Whether the copies of a job differ in their texts: one names {serial}.
[[nodiscard]] bool names_serial(std::string_view words);

}  // namespace kerf::process
