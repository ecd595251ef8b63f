#include "features/milling/stroke.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "features/path/tolerance.hpp"

namespace kerf::features {
namespace {

enum class RowKind : std::uint8_t { level, air, down, up, slope_down, slope_up, still, free };

bool is_in(RowKind kind, std::initializer_list<RowKind> kinds) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

RowKind kind_of(const Recording& recording, std::uint32_t row, double top) {
  const Move& move = recording.moves[row];
  if (move.kind != Move::Kind::feed || move.shape == Move::Shape::other) return RowKind::free;
  const double from_z = recording.from(row).z;
  const double rise = move.to.z - from_z;
  const bool is_across = recording.goes_across(row);
  if (is_across && std::min(from_z, move.to.z) >= top - kSameZ_mm) return RowKind::air;
  if (std::fabs(rise) <= kSameZ_mm) return is_across ? RowKind::level : RowKind::still;
  if (rise < 0) return is_across ? RowKind::slope_down : RowKind::down;
  return is_across ? RowKind::slope_up : RowKind::up;
}

/// Divides the rows of one stroke, from a rapid to the next.
class StrokeReader {
 public:
  StrokeReader(const Recording& recording, double top, Strokes& strokes)
      : recording_(recording), top_(top), strokes_(strokes) {}

  /// `approach`: the first of the rapids before that are the stroke's own, or its first row.
  void read(Span rows, std::uint32_t approach, std::uint32_t retract) {
    rows_ = rows;
    visit_begin_ = approach;
    is_first_ = true;
    at_ = rows.first;
    pending_ = at_;
    last_level_ = kNone;
    while (at_ <= rows_.last) step();
    end(retract);
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  [[nodiscard]] RowKind kind(std::uint32_t row) const { return kind_of(recording_, row, top_); }
  [[nodiscard]] bool has_pending() const { return pending_ < at_; }

  void step() {
    const RowKind one = kind(at_);
    if (one == RowKind::level) return take_level();
    ++at_;
    if (one == RowKind::up) settle_pending();
  }

  void take_level() {
    const std::uint32_t first = at_;
    const double z = recording_.moves[first].to.z;
    while (at_ <= rows_.last && is_in(kind(at_), {RowKind::level, RowKind::still}) &&
           std::fabs(recording_.moves[at_].to.z - z) <= kSameZ_mm)
      ++at_;
    LevelRun run{.z = z, .rows = {first, at_ - 1}, .visit = {visit_begin_, at_ - 1}};
    if (pending_ < first) take_entry({pending_, first - 1}, run);
    run.is_entered_by_rapid = is_first_ && pending_ == first;
    take_exit(run);
    run.visit.last = at_ - 1;
    strokes_.level_mm += recording_.length_of(run.rows);
    strokes_.levels.push_back(run);
    last_level_ = strokes_.levels.size() - 1;
    begin_next();
  }

  // What goes down to the level is its entry, what wanders before that is not.
  void take_entry(Span rows, LevelRun& run) {
    std::uint32_t first = rows.last + 1;
    while (first > rows.first && leads_down(first - 1)) --first;
    if (first > rows.first) add_free({rows.first, first - 1});
    if (first <= rows.last) run.entries.push_back({first, rows.last});
    if (!is_first_) count_slopes({first, rows.last});
  }

  [[nodiscard]] bool leads_down(std::uint32_t row) const {
    return is_in(kind(row),
                 {RowKind::down, RowKind::slope_down, RowKind::still, RowKind::air, RowKind::up});
  }

  // Ways up behind a level, until something goes down again.
  void take_exit(LevelRun& run) {
    const std::uint32_t first = at_;
    while (at_ <= rows_.last && is_in(kind(at_), {RowKind::up, RowKind::slope_up, RowKind::still}))
      ++at_;
    if (at_ == first) return;
    run.entries.push_back({first, at_ - 1});
    count_slopes(run.entries.back());
  }

  // A way up ends what went down before it; what slopes up and down goes on.
  void settle_pending() {
    if (settle({pending_, at_ - 1})) begin_next();
  }

  bool settle(Span rows) {
    if (is_plunge(rows)) {
      add_plunge(rows);
      return true;
    }
    if (has_level_before()) {
      append_to_level(rows);
      return true;
    }
    return add_helix(rows);
  }

  [[nodiscard]] bool has_level_before() const {
    if (last_level_ == kNone) return false;
    for (std::uint32_t row = pending_; row < at_; ++row) {
      if (!is_in(kind(row), {RowKind::up, RowKind::air, RowKind::still})) return false;
    }
    return true;
  }

  void append_to_level(Span rows) {
    LevelRun& run = strokes_.levels[last_level_];
    run.entries.push_back(rows);
    run.visit.last = rows.last;
  }

  [[nodiscard]] bool is_plunge(Span rows) const {
    bool goes_down = false;
    for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
      const RowKind one = kind(row);
      goes_down = goes_down || one == RowKind::down;
      if (!is_in(one, {RowKind::down, RowKind::up, RowKind::still, RowKind::air})) return false;
    }
    return goes_down;
  }

  void add_plunge(Span rows) {
    PlungeRun run{.rows = rows, .visit = {visit_begin_, rows.last}};
    run.top = recording_.from(rows.first).z;
    run.bottom = run.top;
    for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
      if (recording_.moves[row].to.z >= run.bottom) continue;
      run.bottom = recording_.moves[row].to.z;
      run.at = recording_.flat_to(row);
    }
    strokes_.plunges.push_back(run);
  }

  bool add_helix(Span rows) {
    Span arcs = rows;
    while (arcs.first < arcs.last && is_in(kind(arcs.first), {RowKind::down, RowKind::air}))
      ++arcs.first;
    while (arcs.last > arcs.first && is_in(kind(arcs.last), {RowKind::up, RowKind::still}))
      --arcs.last;
    auto helix = helix_of(recording_, arcs);
    if (!helix) return false;
    helix->rows = rows;
    helix->visit = {visit_begin_, rows.last};
    strokes_.helices.push_back(*helix);
    return true;
  }

  void add_free(Span rows) {
    strokes_.frees.push_back({rows, {visit_begin_, rows.last}});
    count_slopes(rows);
  }

  void count_slopes(Span rows) {
    for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
      if (is_in(kind(row), {RowKind::slope_down, RowKind::slope_up, RowKind::free}))
        strokes_.sloping_mm += recording_.length_of(row);
    }
  }

  void begin_next() {
    pending_ = at_;
    visit_begin_ = at_;
    is_first_ = false;
  }

  // What is left when the tool goes away by a rapid.
  void end(std::uint32_t retract) {
    const Span rest{pending_, at_ - 1};
    if (has_pending() && !settle(rest)) add_free(rest);
    extend_visit(retract);
  }

  void extend_visit(std::uint32_t retract) {
    const auto extend = [&](auto& runs) {
      if (!runs.empty() && runs.back().visit.last == rows_.last) runs.back().visit.last = retract;
    };
    extend(strokes_.levels);
    extend(strokes_.plunges);
    extend(strokes_.helices);
    extend(strokes_.frees);
  }

  const Recording& recording_;
  double top_;
  Strokes& strokes_;
  Span rows_;
  std::uint32_t at_ = 0;
  std::uint32_t pending_ = 0;  // first row that is part of nothing yet
  std::uint32_t visit_begin_ = 0;
  bool is_first_ = true;            // nothing of the stroke has been told yet
  std::size_t last_level_ = kNone;  // of the stroke
};

bool is_rapid(const Recording& recording, std::uint32_t row) {
  return recording.moves[row].kind == Move::Kind::rapid;
}

}  // namespace

std::optional<HelixRun> helix_of(const Recording& recording, Span rows) {
  HelixRun helix{.rows = rows, .visit = rows};
  double sweep = 0;
  for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
    if (recording.moves[row].shape != Move::Shape::arc) return std::nullopt;
    const ArcRow& arc = recording.arc_of(row);
    const double radius = geometry::length(recording.flat_from(row) - arc.centre);
    if (row == rows.first) {
      helix.centre = arc.centre;
      helix.radius = radius;
    }
    if (geometry::length(arc.centre - helix.centre) > kSamePoint_mm ||
        std::fabs(radius - helix.radius) > kSamePoint_mm)
      return std::nullopt;
    sweep += std::fabs(arc.sweep_rad);
  }
  helix.top = recording.from(rows.first).z;
  helix.bottom = recording.moves[rows.last].to.z;
  if (helix.bottom >= helix.top - kSameZ_mm || sweep < std::numbers::pi) return std::nullopt;
  helix.pitch = (helix.top - helix.bottom) * 2 * std::numbers::pi / sweep;
  return helix;
}

Strokes strokes_of(const Recording& recording, const Operation& operation, double top) {
  Strokes strokes;
  StrokeReader reader(recording, top, strokes);
  const std::uint32_t end = operation.rows.last + 1;
  std::uint32_t approach = operation.rows.first;
  std::uint32_t row = operation.rows.first;
  while (row < end) {
    if (is_rapid(recording, row)) {
      ++row;
      continue;
    }
    const std::uint32_t first = row;
    while (row < end && !is_rapid(recording, row)) ++row;
    const bool retracts =
        row < end && recording.moves[row].to.z > recording.from(row).z + kSameZ_mm;
    const std::uint32_t last = retracts ? row : row - 1;
    reader.read({first, row - 1}, approach, last);
    approach = last + 1;
    row = std::max(row, approach);
  }
  return strokes;
}

}  // namespace kerf::features
