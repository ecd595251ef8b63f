#include "features/path/programmed.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/arc.hpp"
#include "geometry/corner.hpp"
#include "geometry/intersect.hpp"

namespace kerf::features {
namespace {

using geometry::Curve;
using geometry::Piece;

constexpr double kSameCorner_mm = 2e-3;  // what rounded words leave between two ways to tell one
constexpr double kNearlyWhole = 0.75;    // of a turn: an arc that comes back is a whole circle

Recording copy_of(const Recording& recording) {
  return {.turns = recording.turns,
          .start = recording.start,
          .moves = recording.moves.copy(),
          .blocks = recording.blocks.copy(),
          .arcs = recording.arcs,
          .lengths = recording.lengths,
          .states = recording.states,
          .setups = recording.setups,
          .tools = recording.tools,
          .begins = recording.begins};
}

/// The rows of one block; the row of it that goes along what was programmed.
struct Commanded {
  Span rows{};
  std::optional<std::uint32_t> main{};  ///< none: it goes up or down alone
  Vec2 end{};                           ///< as programmed
};

/// Tells one stretch of rows under compensation as it was programmed.
class Stretched {
 public:
  Stretched(const Recording& recording, Span rows, const CutterBeside& beside)
      : recording_(recording), beside_(beside) {
    for (std::uint32_t row = rows.first; row <= rows.last;) {
      Commanded one{.rows = {row, row}};
      const std::uint32_t block = recording.moves[row].block;
      for (; row <= rows.last && recording.moves[row].block == block; ++row) {
        one.rows.last = row;
        if (!one.main && recording.goes_across(row)) one.main = row;
      }
      blocks_.push_back(one);
    }
  }

  /// False: its corners cannot be told. `starts_up`: the first one leads onto the contour.
  [[nodiscard]] bool find(bool starts_up) {
    std::optional<std::size_t> last;
    std::optional<Vec2> at;  // where the last one begins; none: nobody can say
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      if (!blocks_[i].main) continue;
      if (last && !end_at_corner(*last, i, starts_up && !at, at)) return false;
      last = i;
    }
    if (!last) return false;
    blocks_[*last].end = end_of(*last);
    go_upright();
    return !at || runs(*last, *at);
  }

  [[nodiscard]] const std::vector<Commanded>& blocks() const { return blocks_; }

 private:
  [[nodiscard]] Piece piece_of(std::size_t block) const {
    const std::uint32_t row = *blocks_[block].main;
    Piece piece{.from = recording_.flat_from(row) - beside_.tip,
                .to = recording_.flat_to(row) - beside_.tip};
    if (recording_.moves[row].shape != Move::Shape::arc) return piece;
    piece.is_arc = true;
    piece.centre = recording_.arc_of(row).centre - beside_.tip;
    piece.clockwise = recording_.arc_of(row).sweep_rad < 0;
    return piece;
  }
  [[nodiscard]] Vec2 begin_of(std::size_t block) const {
    const Piece piece = piece_of(block);
    return piece.from - beside_.to_left_mm * geometry::left_of(geometry::direction_at_start(piece));
  }
  [[nodiscard]] Vec2 end_of(std::size_t block) const {
    const Piece piece = piece_of(block);
    return piece.to - beside_.to_left_mm * geometry::left_of(geometry::direction_at_end(piece));
  }
  [[nodiscard]] Curve curve_of(std::size_t block) const {
    const Piece piece = piece_of(block);
    const Vec2 at = end_of(block);
    if (piece.is_arc) return {true, piece.centre, {}, geometry::length(at - piece.centre)};
    return {false, at, geometry::direction_at_end(piece), 0};
  }

  // Where block `a` ends and `b` goes on. `at`: where `a` begins, then where it ends.
  [[nodiscard]] bool end_at_corner(std::size_t a, std::size_t b, bool starts_up,
                                   std::optional<Vec2>& at) {
    const auto corner = starts_up ? begin_of(b) : corner_of(a, b);
    if (!corner) return false;
    blocks_[a].end = *corner;
    if (at && !runs(a, *at)) return false;
    at = corner;
    return true;
  }
  [[nodiscard]] std::optional<Vec2> corner_of(std::size_t a, std::size_t b) const {
    const Vec2 end = end_of(a);
    const Vec2 begin = begin_of(b);
    const Vec2 middle = 0.5 * (end + begin);
    if (geometry::length(end - begin) <= kSameCorner_mm) return middle;
    const auto found = geometry::intersect(curve_of(a), curve_of(b), 1e-7);
    std::optional<Vec2> nearest;
    for (std::size_t i = 0; i < found.count; ++i) {
      const Vec2 point = found.points[i];
      if (!nearest || geometry::length(point - middle) < geometry::length(*nearest - middle))
        nearest = point;
    }
    return nearest;
  }

  // A line goes from one corner to the next in its direction, an arc about its centre.
  [[nodiscard]] bool runs(std::size_t block, Vec2 from) const {
    const Piece piece = piece_of(block);
    const Vec2 to = blocks_[block].end;
    if (piece.is_arc) {
      const double off =
          geometry::length(from - piece.centre) - geometry::length(to - piece.centre);
      return std::fabs(off) <= 2 * kSameCorner_mm;
    }
    const Vec2 way = geometry::direction_at_end(piece);
    return std::fabs(geometry::cross(way, to - from)) <= 2 * kSameCorner_mm &&
           geometry::dot(way, to - from) > -kSameCorner_mm;
  }

  // What goes up or down does it where the block before it has ended.
  void go_upright() {
    Vec2 at = recording_.flat_to(blocks_.front().rows.last);
    for (Commanded& block : blocks_) {
      if (!block.main) block.end = at;
      at = block.end;
    }
  }

  const Recording& recording_;
  CutterBeside beside_;
  std::vector<Commanded> blocks_{};
};

/// Makes the recording.
class Programmed {
 public:
  explicit Programmed(const Recording& recording)
      : recording_(recording), made_(copy_of(recording)) {}

  [[nodiscard]] Recording make() {
    for (std::uint32_t row = 0; row < recording_.count();) {
      std::uint32_t end = end_of_stretch(row);
      if (is_beside(row)) {
        end = end_of_held(end);
        tell({row, end - 1});
      }
      row = end;
    }
    return std::move(made_);
  }

 private:
  [[nodiscard]] const State& state_at(std::uint32_t row) const {
    return recording_.state_of(recording_.moves[row]);
  }
  [[nodiscard]] bool is_beside(std::uint32_t row) const {
    return state_at(row).beside.to_left_mm != 0;
  }
  [[nodiscard]] std::uint32_t end_of_stretch(std::uint32_t row) const {
    const State& first = state_at(row);
    while (++row < recording_.count()) {
      const State& state = state_at(row);
      if (!(state.beside == first.beside) || state.setup != first.setup) break;
    }
    return row;
  }

  // The control holds a move until it knows the next one: the last one goes out when G40 is in
  // force by then, and so does what goes up or down behind it.
  [[nodiscard]] std::uint32_t end_of_held(std::uint32_t end) const {
    if (end >= recording_.count() || is_beside(end)) return end;
    std::uint32_t row = end;
    while (row < recording_.count() && !recording_.goes_across(row)) ++row;
    if (row >= recording_.count()) return end;
    row = recording_.of_one_block(row).last + 1;
    while (row < recording_.count() && !recording_.goes_across(row)) ++row;
    return row;
  }

  void tell(Span rows) {
    const bool starts_up = rows.first == 0 || !is_beside(rows.first - 1);
    const CutterBeside& beside = state_at(rows.first).beside;
    Stretched stretched(recording_, rows, beside);
    if (!stretched.find(starts_up)) return;
    for (const Commanded& block : stretched.blocks()) command(block, -beside.tip);
    for (std::uint32_t row = rows.first; row <= rows.last; ++row) hold(row, rows.first);
  }

  // A row that went out too late to be told of as compensated is.
  void hold(std::uint32_t row, std::uint32_t like) {
    if (state_at(row).is_compensated()) return;
    made_.states.push_back(state_at(row));
    made_.states.back().compensation = state_at(like).compensation;
    made_.states.back().beside = state_at(like).beside;
    made_.moves[row].state = static_cast<std::uint32_t>(made_.states.size() - 1);
  }

  void command(const Commanded& block, Vec2 centre) {
    const Vec2 begin = made_.flat_from(block.rows.first);
    const Vec3 from = made_.from(block.rows.first);
    for (std::uint32_t row = block.rows.first; row < block.rows.last; ++row) {
      made_.moves[row].shape = Move::Shape::line;
      made_.moves[row].to = from;
    }
    Move& last = made_.moves[block.rows.last];
    (recording_.turns ? last.to.z : last.to.x) = block.end.u;
    (recording_.turns ? last.to.x : last.to.y) = block.end.v;
    last.shape = Move::Shape::line;
    if (!block.main || recording_.moves[*block.main].shape != Move::Shape::arc) return;
    ArcRow arc = recording_.arc_of(*block.main);
    arc.centre = arc.centre + centre;
    arc.sweep_rad = sweep_of(arc, begin, block.end);
    last.shape = Move::Shape::arc;
    last.shaped = static_cast<std::uint32_t>(made_.arcs.size());
    made_.arcs.push_back(arc);
  }
  [[nodiscard]] static double sweep_of(const ArcRow& arc, Vec2 begin, Vec2 end) {
    const double sign = arc.sweep_rad < 0 ? -1 : 1;
    const double turn = 2 * std::numbers::pi;
    if (geometry::length(end - begin) > kSameCorner_mm)
      return sign * geometry::sweep_rad(begin, end, arc.centre, sign < 0);
    return std::fabs(arc.sweep_rad) > kNearlyWhole * turn ? sign * turn : 0;
  }

  const Recording& recording_;
  Recording made_;
};

}  // namespace

Recording as_programmed(const Recording& recording) { return Programmed(recording).make(); }

}  // namespace kerf::features
