#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "features/rewrite/planned_row.hpp"

namespace kerf::features {
namespace {

// Half of the last digit that programs write, so that rounding makes no difference.
constexpr double kSameMotion_mm = 5e-4;
// Beyond this many pairs only what is equal at both ends is looked for.
constexpr std::size_t kMostPairs = 16'000'000;

/// A motion with its beginning, as far as it matters whether two are one.
struct Whole {
  Vec3 from{};
  PlannedRow row{};
};

bool near(Vec3 a, Vec3 b) { return geometry::length(a - b) <= kSameMotion_mm; }

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

/// The longest common row by the lengths of what is left behind each pair of places.
void pair_by_table(const Wholes& a, const Wholes& b, Window in, Same same, Pairs& pairs) {
  const std::size_t rows = in.a_end - in.a + 1;
  const std::size_t columns = in.b_end - in.b + 1;
  std::vector<std::uint32_t> left(rows * columns, 0);
  for (std::size_t i = rows - 1; i-- > 0;) {
    for (std::size_t j = columns - 1; j-- > 0;) {
      left[i * columns + j] = same(a[in.a + i], b[in.b + j]) ? left[(i + 1) * columns + j + 1] + 1
                                                             : std::max(left[(i + 1) * columns + j],
                                                                        left[i * columns + j + 1]);
    }
  }
  for (std::size_t i = 0, j = 0; i + 1 < rows && j + 1 < columns;) {
    if (same(a[in.a + i], b[in.b + j])) {
      pairs.emplace_back(in.a + i++, in.b + j++);
    } else if (left[(i + 1) * columns + j] >= left[i * columns + j + 1]) {
      ++i;
    } else {
      ++j;
    }
  }
}

/// What is equal at both ends is paired at once.
void pair_up(const Wholes& a, const Wholes& b, Window in, Same same, Pairs& pairs) {
  while (in.a < in.a_end && in.b < in.b_end && same(a[in.a], b[in.b]))
    pairs.emplace_back(in.a++, in.b++);
  Pairs behind;
  while (in.a < in.a_end && in.b < in.b_end && same(a[in.a_end - 1], b[in.b_end - 1]))
    behind.emplace_back(--in.a_end, --in.b_end);
  if ((in.a_end - in.a) * (in.b_end - in.b) <= kMostPairs) pair_by_table(a, b, in, same, pairs);
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

void align(const Recording& recording, Span old, Vec3 begin, std::vector<PlannedRow>& rows) {
  for (PlannedRow& row : rows) row.was.reset();
  for (const auto& [a, b] : pairs_of(olds_of(recording, old), news_of(begin, rows)))
    rows[b].was = old.first + static_cast<std::uint32_t>(a);
}

}  // namespace kerf::features
