#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace kerf::training {

/// A text in both languages of the panel.
struct Words {
  std::string en;
  std::string zh_hant;
};

/// Work that is judged by the part that it makes, not by where the tools go. Words as `kerf stock`
/// has them; G54 is the zero of all of them.
struct PartWork {
  std::string stock;
  std::vector<std::string> fixtures;
  std::string tools;   ///< [[tool]] tables
  double cell_mm = 0;  ///< of the model, at least kLeastCell_mm

  /// The same as a set-up, docs/set-up.md: what a panel keeps with the program.
  [[nodiscard]] std::string set_up() const;

  static constexpr double kLeastCell_mm = 0.05;  // smaller ones take too long for a page
};

/// A task for whoever learns to program a machine, with a program that does it.
struct Exercise {
  std::string name;  ///< that of its file: "1_rounded_plate"
  Words title;
  Words task;
  std::string machine;  ///< a built-in one
  std::string file;     ///< what the program is called; its ending says the language
  std::string start;    ///< what the trainee begins with
  std::string solution;
  double tolerance_mm = 0;          ///< of the cuts, or of the part's surface, > 0
  std::array<double, 3> zero_mm{};  ///< where G54 lies on the machine, X Y Z

  /// The work is milled: its top is Z0, a cut takes away all that is above it, and rapids that move
  /// in X or Y stay at this height or higher. Nothing: a beam cuts wherever it is on.
  std::optional<double> clearance_z_mm;
  /// The work is turned from a bar of this diameter, mm, whose face is Z0 and whose axis is X0: a
  /// cut takes away all that is farther from the axis at its Z, and no rapid goes where nothing was
  /// cut before. Never beside clearance_z_mm.
  std::optional<double> bar_mm;
  /// The part that is made is judged. Never beside clearance_z_mm or bar_mm.
  std::optional<PartWork> part;
  std::optional<int> most_lines;  ///< of code
  double time_factor = 0;         ///< times as long as the solution is well, >= 1

  /// Failure (input): what is wrong, with the line; every unknown key is wrong.
  [[nodiscard]] static base::Outcome<Exercise> parse(std::string_view toml,
                                                     const std::string& name);
};

/// A file of exercises/ that is compiled in.
struct ExerciseFile {
  std::string_view name;
  std::string_view toml;
};
[[nodiscard]] const std::vector<ExerciseFile>& exercise_files();

/// All of them, in the order of their names.
[[nodiscard]] const std::vector<Exercise>& exercises();
/// Null: there is none of this name.
[[nodiscard]] const Exercise* find_exercise(std::string_view name);

}  // namespace kerf::training
