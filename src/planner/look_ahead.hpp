#pragma once

#include <cstdint>
#include <limits>

#include "planner/cell.hpp"
#include "planner/profile.hpp"
#include "planner/ring.hpp"

namespace kerf::planner {

/// Cells in a row that one profile drives over, or a dwell.
struct Section {
  double length = 0;
  PathLimits limits;  ///< the least of all cells
  double entry = 0;   ///< planned speeds at its begin and end
  double exit = 0;
  std::uint64_t cells = 0;  ///< how many end within it
  double tail = 0;          ///< its end in the cell behind those, from the cell's begin
  double dwell_s = 0;       ///< > 0: the axes rest this long
  bool stop = false;        ///< the axes come to rest at its end
};

/// Plans how fast the cells ahead are driven, so that each can slow down in time for what follows.
///
/// Without a limit of the jerk a section is a cell. Backwards from the end of what is known every
/// entry is the speed that can be braked down to the exit; forwards every exit is what can be
/// reached from the entry.
///
/// With limited jerk the acceleration is 0 where two sections meet, so sections should be long: a
/// ramp runs through as many cells as make it faster. Each direction takes, cell by cell, the
/// better of two: to lengthen the ramp that is under way, at the lowest speed of all its cells, or
/// to begin a new one here. Where the ramps of both directions meet, they become one section when
/// no cell between them is slower than that meeting (docs/motion.md, "Look-ahead").
///
/// What lies behind the last cell is not known yet: the axes could stop there. Bounded memory.
class LookAhead {
 public:
  static constexpr std::size_t kItems = 2048;

  static constexpr double kNever = std::numeric_limits<double>::infinity();

  explicit LookAhead(bool jerk_limited) : jerk_limited_(jerk_limited) {}

  /// Takes over the cells of the ring that it has not seen yet, as far as there is room.
  void absorb(const Ring<Cell>& cells);

  /// Number of the first cell that has not been absorbed.
  [[nodiscard]] std::uint64_t next_cell() const { return seen_; }

  /// Plans what is there. With `ended` nothing follows, and all of it is final; otherwise the first
  /// half is. False when the speed at the begin is too high for what follows, which happens only
  /// after begin_at(); nothing is final then.
  [[nodiscard]] bool plan(bool ended);

  /// Forgets all and begins anew within a cell, `offset` behind its begin, at `speed`.
  void begin_at(std::uint64_t cell, double offset, double speed);
  /// What is absorbed next ends in a stop `way` behind its begin; nothing is absorbed behind that.
  /// Precondition: just after begin_at().
  void stop_after(double way) { stop_way_ = way; }

  /// Whether there is a section that is planned for good.
  [[nodiscard]] bool has_planned() const { return items_.begin() < planned_; }
  [[nodiscard]] bool empty() const { return items_.empty(); }
  /// The next section becomes `section`. Precondition: has_planned().
  void take(Section& section);

 private:
  /// A cell, or several of equal speed.
  struct Item {
    Section section;          // entry and exit: of the plan, where a section begins and ends
    double bound = 0;         // highest speed at its begin from which everything behind is possible
    std::uint64_t until = 0;  // where the ramp down ends that begins with `bound`: an item's number
    std::uint32_t items = 1;  // of the planned section that begins here
  };

  /// Items in a row as one.
  struct Run {
    double length = 0;
    PathLimits limits{1e300, 1e300, 1e300};
    void add(const Section& section);
    [[nodiscard]] double speed_from(double speed) const;
  };

  /// Where a section begins, and how fast.
  struct Way {
    std::uint64_t from = 0;
    double entry = 0;
  };

  [[nodiscard]] bool goes_on_at_the_end() const;
  void join_at_the_end();
  [[nodiscard]] bool plan_accelerations(std::uint64_t begin, std::uint64_t end);
  void look_back(std::uint64_t begin, std::uint64_t end);
  void go_forward(std::uint64_t begin, std::uint64_t end);
  [[nodiscard]] double speed_allowed_at(std::uint64_t number, std::uint64_t end) const;
  [[nodiscard]] double time_s(std::uint64_t begin, std::uint64_t end, double entry, double exit,
                              double least) const;
  Way way_down(const Way& up, std::uint64_t n, double speed, double reached, std::uint64_t end);
  void set_section(std::uint64_t begin, std::uint64_t end, double entry, double exit);
  void release(bool ended);

  Ring<Item> items_{kItems};
  bool jerk_limited_;
  std::uint64_t planned_ = 0;  // items before this one are final
  std::uint64_t seen_ = 0;     // cells before this one are in items
  double offset_ = 0;          // the next cell counts from here
  double stop_way_ = kNever;   // of what is absorbed next
  double entry_ = 0;           // speed where the first item begins that is not final
};

}  // namespace kerf::planner
