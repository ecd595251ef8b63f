#pragma once

#include <array>
#include <cstdint>

#include "control/core/parameters.hpp"
#include "control/gcode/codes/code_table.hpp"
#include "motion/motion.hpp"

namespace kerf::control {

/// The modal G codes of all groups. Value type.
class ModalState {
 public:
  /// At power-on. The codes must outlive this.
  ModalState(const CodeTable& codes, const Parameters& parameters);

  [[nodiscard]] Meaning operator[](Group group) const {
    const CodeRow* const row = rows_[index(group)];
    return row == nullptr ? Meaning::none : row->meaning;
  }
  /// The code in force; null: the group has none.
  [[nodiscard]] const CodeRow* row(Group group) const { return rows_[index(group)]; }
  void set(const CodeRow& row) { rows_[index(row.group)] = &row; }
  /// The dialect's first code with that meaning.
  void set(Meaning meaning) { set(codes_->with(meaning)); }

  [[nodiscard]] bool incremental() const {
    return (*this)[Group::distance] == Meaning::incremental;
  }
  [[nodiscard]] bool inch() const { return (*this)[Group::unit] == Meaning::inch; }
  [[nodiscard]] bool compensating() const {
    return (*this)[Group::compensation] != Meaning::compensation_off;
  }
  [[nodiscard]] bool in_cycle() const { return (*this)[Group::cycle] != Meaning::cycle_off; }
  /// G02 or G03.
  [[nodiscard]] bool circular() const {
    const Meaning motion = (*this)[Group::motion];
    return motion == Meaning::arc_clockwise || motion == Meaning::arc_counterclockwise;
  }
  [[nodiscard]] motion::Plane plane() const;
  [[nodiscard]] motion::FeedMode feed_mode() const;
  /// The numbers of all of them in the order of the groups; 0 where a group has none.
  [[nodiscard]] std::array<GCode, kGroups> codes() const;
  /// Value of #4001 + number - 1, or a negative number when there is no such group.
  [[nodiscard]] double variable(std::size_t group_number) const;

 private:
  static constexpr std::size_t index(Group group) { return static_cast<std::size_t>(group); }

  const CodeTable* codes_;
  std::array<const CodeRow*, kGroups> rows_{};
};

}  // namespace kerf::control
