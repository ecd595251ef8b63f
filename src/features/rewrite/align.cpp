#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "features/rewrite/planned_row.hpp"

namespace kerf::features {
namespace {

// Half of the last digit that programs write, so that rounding makes no difference.
constexpr double kSameMotion_mm = 5e-4;
// Beyond this many pairs only what is equal at both ends is looked for: some 4,000 motions of which
// none is left.
constexpr std::size_t kMostPairs = 33'000'000;
// How far apart two equal motions may stand at first, counted in motions.
constexpr std::size_t kFirstReach = 32;

/// A motion with its beginning, as far as it matters whether two are one.
struct Whole {
  Vec3 from{};
  PlannedRow row{};
};

bool near(Vec3 a, Vec3 b) {
  return std::fabs(a.x - b.x) <= kSameMotion_mm && std::fabs(a.y - b.y) <= kSameMotion_mm &&
         geometry::length(a - b) <= kSameMotion_mm;
}

bool are_equal_arcs(const std::optional<ArcRow>& a, const std::optional<ArcRow>& b) {
  if (a.has_value() != b.has_value()) return false;
  if (!a) return true;
  return geometry::length(a->centre - b->centre) <= kSameMotion_mm &&
         std::signbit(a->sweep_rad) == std::signbit(b->sweep_rad);
}

bool is_same(const Whole& a, const Whole& b) {
  return a.row.kind == b.row.kind && near(a.row.to, b.row.to) && near(a.from, b.from) &&
         are_equal_arcs(a.row.arc, b.row.arc);
}

/// What a block can be made another one of: rapids of rapids, lines of lines, arcs of arcs, and
/// what only goes up or down of its like.
int sort_of(const Whole& motion) {
  if (motion.row.arc) return 3;
  const Vec3 way = motion.row.to - motion.from;
  const bool is_upright = math::hypot(way.x, way.y) <= kSameMotion_mm && std::fabs(way.z) > 0;
  return (motion.row.kind == Move::Kind::rapid ? 0 : 1) + (is_upright ? 4 : 0);
}

bool is_same_sort(const Whole& a, const Whole& b) { return sort_of(a) == sort_of(b); }

using Wholes = std::vector<Whole>;
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
using Same = bool (*)(const Whole&, const Whole&);

/// Stretches of two lists, not including their ends.
struct Window {
  std::size_t a = 0, a_end = 0, b = 0, b_end = 0;
};

/// The longest common row by the lengths of what is left behind each pair of places; of a table of
/// all pairs only a band is looked at, `reach` to both sides of its diagonals.
class BandTable {
 public:
  BandTable(const Wholes& a, const Wholes& b, Window in, Same same, std::size_t reach)
      : a_(a),
        b_(b),
        in_(in),
        same_(same),
        rows_(in.a_end - in.a),
        columns_(in.b_end - in.b),
        before_(reach + (rows_ > columns_ ? rows_ - columns_ : 0)),
        width_(before_ + 1 + reach + (columns_ > rows_ ? columns_ - rows_ : 0)),
        left_((rows_ + 1) * width_, 0) {
    for (std::size_t i = rows_; i-- > 0;) fill(i);
  }

  /// How many are in neither or only one list.
  [[nodiscard]] std::size_t differences() const {
    return rows_ + columns_ - 2 * static_cast<std::size_t>(at(0, 0));
  }
  /// Where lists differ in so many places, no longest common row leaves a band that is as wide.
  [[nodiscard]] static std::size_t reach_for(std::size_t differences) {
    return 2 * differences + 4;
  }

  void pair(Pairs& pairs) const {
    for (std::size_t i = 0, j = 0; i < rows_ && j < columns_;) {
      if (is_same(i, j)) {
        pairs.emplace_back(in_.a + i++, in_.b + j++);
      } else if (at(i + 1, j) >= at(i, j + 1)) {
        ++i;
      } else {
        ++j;
      }
    }
  }

 private:
  [[nodiscard]] bool is_same(std::size_t i, std::size_t j) const {
    return same_(a_[in_.a + i], b_[in_.b + j]);
  }
  // 0 beyond the band and behind the ends.
  [[nodiscard]] std::uint32_t at(std::size_t i, std::size_t j) const {
    if (i >= rows_ || j >= columns_ || j + before_ < i || j + before_ - i >= width_) return 0;
    return left_[i * width_ + (j + before_ - i)];
  }
  void fill(std::size_t i) {
    const std::size_t first = i > before_ ? i - before_ : 0;
    const std::size_t end = std::min(columns_, i + width_ - before_);
    for (std::size_t j = end; j-- > first;) {
      left_[i * width_ + (j + before_ - i)] =
          is_same(i, j) ? at(i + 1, j + 1) + 1 : std::max(at(i + 1, j), at(i, j + 1));
    }
  }

  const Wholes& a_;
  const Wholes& b_;
  Window in_;
  Same same_;
  std::size_t rows_;
  std::size_t columns_;
  std::size_t before_;  // columns of the band before the diagonal
  std::size_t width_;
  std::vector<std::uint32_t> left_;
};

/// Bands, each wider than the one before, until one holds all longest common rows.
void pair_by_table(const Wholes& a, const Wholes& b, Window in, Same same, Pairs& pairs) {
  const std::size_t rows = in.a_end - in.a;
  const std::size_t columns = in.b_end - in.b;
  if (rows == 0 || columns == 0) return;
  const std::size_t apart = std::max(rows, columns) - std::min(rows, columns);
  for (std::size_t reach = kFirstReach;; reach *= 2) {
    const std::size_t whole = std::min(rows, columns);
    reach = std::min(reach, whole);
    if ((rows + 1) * (2 * reach + apart + 1) > kMostPairs) return;
    const BandTable table(a, b, in, same, reach);
    if (reach < whole && reach < BandTable::reach_for(table.differences())) continue;
    return table.pair(pairs);
  }
}

/// What is equal at both ends is paired at once.
void pair_up(const Wholes& a, const Wholes& b, Window in, Same same, Pairs& pairs) {
  while (in.a < in.a_end && in.b < in.b_end && same(a[in.a], b[in.b]))
    pairs.emplace_back(in.a++, in.b++);
  Pairs behind;
  while (in.a < in.a_end && in.b < in.b_end && same(a[in.a_end - 1], b[in.b_end - 1]))
    behind.emplace_back(--in.a_end, --in.b_end);
  pair_by_table(a, b, in, same, pairs);
  pairs.insert(pairs.end(), behind.rbegin(), behind.rend());
}

Wholes olds_of(const Recording& recording, Span span) {
  Wholes wholes;
  for (std::uint32_t row = span.first; row <= span.last; ++row)
    wholes.push_back({recording.from(row), as_it_is(recording, row)});
  return wholes;
}

Wholes news_of(Vec3 begin, const std::vector<PlannedRow>& rows) {
  Wholes wholes;
  for (const PlannedRow& row : rows) {
    wholes.push_back({begin, row});
    begin = row.to;
  }
  return wholes;
}

/// Between the motions that are equal, those of one sort.
Pairs pairs_of(const Wholes& olds, const Wholes& news) {
  Pairs equal;
  pair_up(olds, news, {0, olds.size(), 0, news.size()}, is_same, equal);
  Pairs pairs;
  Window gap{};
  equal.emplace_back(olds.size(), news.size());
  for (const auto& [a, b] : equal) {
    gap.a_end = a;
    gap.b_end = b;
    pair_up(olds, news, gap, is_same_sort, pairs);
    if (a < olds.size()) pairs.emplace_back(a, b);
    gap.a = a + 1;
    gap.b = b + 1;
  }
  return pairs;
}

}  // namespace

// What came straight down comes straight down where it shall: nothing has to bring the tool there
// before, or a block that no row tells of.
void align(const Recording& recording, Span old, Vec3 begin, std::vector<PlannedRow>& rows) {
  const bool is_down =
      !rows.empty() && rows.front().was && is_upright(recording, *rows.front().was);
  if (is_down) begin = {rows.front().to.x, rows.front().to.y, begin.z};
  for (PlannedRow& row : rows) row.was.reset();
  for (const auto& [a, b] : pairs_of(olds_of(recording, old), news_of(begin, rows)))
    rows[b].was = old.first + static_cast<std::uint32_t>(a);
}

}  // namespace kerf::features
