#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "control/gcode/codes/meaning.hpp"

namespace kerf::control {

/// A G code times ten: G54.1 is 541.
using GCode = std::uint16_t;

/// Groups of modal codes by the number behind #40 of a machining centre (docs/dialect/motion.md
/// §8.1); other dialects number them otherwise (CodeTable::group_of()).
enum class Group : std::uint8_t {
  one_shot = 0,
  motion = 1,
  plane = 2,
  distance = 3,
  stroke = 4,
  feed = 5,
  unit = 6,
  compensation = 7,
  length = 8,
  cycle = 9,
  cycle_return = 10,
  scaling = 11,
  modal_call = 12,
  speed = 13,
  work = 14,
  stop_mode = 15,
  rotation = 16,
  polar = 17,
  normal_direction = 19,
  in_feed = 20,
  polar_interpolation = 21,
  mirror = 22,
  turrets = 23,        ///< of lathes: G68, G69
  spindle_watch = 24,  ///< of lathes: G25, G26
  none = 255           ///< the code does not exist
};
inline constexpr std::size_t kGroups = 25;

/// Whose the axis words of a block are that has the code.
enum class AxisWords : std::uint8_t {
  motion,  ///< the motion's that is in force
  own,     ///< the code's, which acts in the motion's place
  data     ///< the code's, and nothing moves
};

/// A G code of a dialect: what it means, and all that follows from its number alone.
struct CodeRow {
  GCode number = 0;
  Meaning meaning = Meaning::none;
  Group group = Group::none;
  const char* letters = "";  ///< of P L Q R I J K those that it takes
  AxisWords axis_words = AxisWords::motion;
  std::int8_t value = 0;         ///< which one of several with the same meaning
  bool power_on = false;         ///< in force at power-on, where no parameter says otherwise
  const char* effect = nullptr;  ///< what to say where it has less of it than on a machine
  const char* title = "";
  const char* sentence = "";
};

/// When an M code acts.
enum class Moment : std::uint8_t { before_motion, behind_motion, at_end_of_block };

/// An M code of a dialect.
struct FunctionRow {
  std::uint32_t number = 0;
  Function function = Function::passed_on;
  Moment moment = Moment::behind_motion;
  const char* title = "";
  const char* sentence = "";
};

/// What a dialect's words mean besides its codes.
struct Habits {
  bool letters_are_increments = false;  ///< U V W H are ways along X Y Z C, and these are points
  bool tool_brings_offset = false;  ///< T turns the turret and brings the offset of its last digits
  bool drawing_dimensions = false;  ///< lines by their angle; corners stand between lines alone
};

/// The codes of a dialect. All lists outlive the table; rows are sorted by number.
class CodeTable {
 public:
  /// `numbers`: the groups by the number behind #40; empty: as those of Group.
  constexpr CodeTable(std::span<const CodeRow> codes, std::span<const FunctionRow> functions,
                      std::span<const Group> numbers = {}, const Habits& habits = {})
      : codes_(codes), functions_(functions), numbers_(numbers), habits_(habits) {
    for (std::size_t i = 0; i < codes.size(); ++i) {
      if (codes[i].number < kDirect) direct_[codes[i].number] = static_cast<std::uint8_t>(i + 1);
    }
  }

  /// Null: the dialect has no such code.
  [[nodiscard]] const CodeRow* find(GCode number) const {
    if (number >= kDirect) return search(number);
    const std::uint8_t place = direct_[number];
    return place == 0 ? nullptr : &codes_[place - 1U];
  }
  /// The first code with this meaning. Precondition: the dialect has one.
  [[nodiscard]] const CodeRow& with(Meaning meaning) const;
  /// The first M code with this function; null: the dialect has none.
  [[nodiscard]] const FunctionRow* with(Function function) const;
  /// The row of M198 and its like; null: the dialect has none.
  [[nodiscard]] const FunctionRow* external_call() const { return with(Function::external_call); }
  /// Null: the control has no meaning for it, and passes it on.
  [[nodiscard]] const FunctionRow* find_function(std::int64_t number) const;

  /// The group with the variable #4000 + number; none: there is none.
  [[nodiscard]] Group group_of(std::size_t number) const;
  [[nodiscard]] const Habits& habits() const { return habits_; }
  [[nodiscard]] std::span<const CodeRow> codes() const { return codes_; }
  [[nodiscard]] std::span<const FunctionRow> functions() const { return functions_; }

 private:
  static constexpr std::size_t kDirect = 1024;
  [[nodiscard]] const CodeRow* search(GCode number) const;

  std::span<const CodeRow> codes_;
  std::span<const FunctionRow> functions_;
  std::span<const Group> numbers_;
  Habits habits_;
  std::array<std::uint8_t, kDirect> direct_{};  // 1 + the place of a code; 0: none
};

/// "G01", "G54.1".
[[nodiscard]] std::string name_of(GCode code);

/// Codes of a machining centre.
[[nodiscard]] const CodeTable& mill_codes();

}  // namespace kerf::control
