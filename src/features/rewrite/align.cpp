#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "features/path/tolerance.hpp"
#include "features/rewrite/contour_chain.hpp"
#include "features/rewrite/planned_row.hpp"

namespace kerf::features {
namespace {

// Half of the last digit that programs write, so that rounding makes no difference.
constexpr double kSameMotion_mm = 5e-4;
// Beyond this many reaches only what is equal at both ends is looked for: some 4,000 motions of
// which none is left.
constexpr std::size_t kMostPairs = 33'000'000;

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
bool is_same_kind(const Whole& a, const Whole& b) {
  return a.row.kind == b.row.kind && a.row.arc.has_value() == b.row.arc.has_value();
}

/// Lines on one line, and arcs on one circle, in one sense: what has other ends on its element.
template <bool kTurns>
bool is_on_same_element(const Whole& a, const Whole& b) {
  const auto flat = [](Vec3 v) { return kTurns ? Vec2{v.z, v.x} : Vec2{v.x, v.y}; };
  if (a.row.arc.has_value() != b.row.arc.has_value() || a.row.kind != b.row.kind) return false;
  if (!a.row.arc) return lie_along({flat(a.from), flat(a.row.to)}, {flat(b.from), flat(b.row.to)});
  const double off = geometry::length(a.row.arc->centre - b.row.arc->centre);
  const double larger = geometry::length(flat(a.from) - a.row.arc->centre) -
                        geometry::length(flat(b.from) - b.row.arc->centre);
  return off <= kSamePoint_mm && std::fabs(larger) <= kSamePoint_mm &&
         std::signbit(a.row.arc->sweep_rad) == std::signbit(b.row.arc->sweep_rad);
}

using Wholes = std::vector<Whole>;
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
using Same = bool (*)(const Whole&, const Whole&);

/// Stretches of two lists, not including their ends.
struct Window {
  std::size_t a = 0, a_end = 0, b = 0, b_end = 0;
};

/// How far from the ends of two lists one can begin so that no more than d motions are in only one
/// of them: for each d and each diagonal (place in `a` less place in `b`) the first place in `a`.
/// The greedy algorithm of E. W. Myers (1986) for differences, from behind.
class Reaches {
 public:
  Reaches(const Wholes& a, const Wholes& b, Window in, Same same)
      : a_(a),
        b_(b),
        in_(in),
        same_(same),
        rows_(static_cast<std::ptrdiff_t>(in.a_end - in.a)),
        columns_(static_cast<std::ptrdiff_t>(in.b_end - in.b)) {}

  /// Until the beginning of both is reached. False: they have too little in common.
  [[nodiscard]] bool find() {
    for (std::ptrdiff_t d = 0; !has(d - 1, 0, 0); ++d) {
      if (firsts_.size() + static_cast<std::size_t>(d) + 1 > kMostPairs) return false;
      begins_.push_back(firsts_.size());
      for (std::ptrdiff_t k = -d; k <= d; k += 2) firsts_.push_back(first_of(d, k));
    }
    return true;
  }

  /// The longest common row: what is equal as early as it can be, and where either may be passed
  /// over, that of `a`.
  void pair(Pairs& pairs) const {
    auto left = static_cast<std::ptrdiff_t>(begins_.size()) - 1;
    for (std::ptrdiff_t i = 0, j = 0; i < rows_ && j < columns_;) {
      if (is_same(i, j)) {
        pairs.emplace_back(in_.a + static_cast<std::size_t>(i++),
                           in_.b + static_cast<std::size_t>(j++));
      } else if (has(--left, i + 1, j)) {
        ++i;
      } else {
        ++j;
      }
    }
  }

 private:
  [[nodiscard]] bool is_same(std::ptrdiff_t i, std::ptrdiff_t j) const {
    return same_(a_[in_.a + static_cast<std::size_t>(i)], b_[in_.b + static_cast<std::size_t>(j)]);
  }
  /// The diagonal on which both lists end.
  [[nodiscard]] std::ptrdiff_t last_diagonal() const { return rows_ - columns_; }

  /// Beyond all places where d does not reach the diagonal.
  [[nodiscard]] std::ptrdiff_t first(std::ptrdiff_t d, std::ptrdiff_t k) const {
    if (d < 0 || k < -d || k > d) return kNowhere;
    return firsts_[begins_[static_cast<std::size_t>(d)] + static_cast<std::size_t>((k + d) / 2)];
  }
  [[nodiscard]] bool has(std::ptrdiff_t d, std::ptrdiff_t i, std::ptrdiff_t j) const {
    const std::ptrdiff_t k = i - j - last_diagonal();
    return d >= 0 && k >= -d && k <= d && (k + d) % 2 == 0 && first(d, k) <= i;
  }

  /// One motion more than d - 1, then along what is equal.
  [[nodiscard]] std::int32_t first_of(std::ptrdiff_t d, std::ptrdiff_t k) const {
    std::ptrdiff_t i = d == 0 ? rows_ : kNowhere;
    const auto begin_at = [&](std::ptrdiff_t place) {
      if (place >= 0 && place - k - last_diagonal() >= 0) i = std::min(i, place);
    };
    if (const auto behind = first(d - 1, k + 1); behind != kNowhere) begin_at(behind - 1);
    if (const auto behind = first(d - 1, k - 1); behind != kNowhere) begin_at(behind);
    if (i == kNowhere) return kNowhere;
    while (i > 0 && is_same_before(i, i - k - last_diagonal())) --i;
    return static_cast<std::int32_t>(i);
  }
  [[nodiscard]] bool is_same_before(std::ptrdiff_t i, std::ptrdiff_t j) const {
    return j > 0 && is_same(i - 1, j - 1);
  }

  static constexpr std::int32_t kNowhere = std::numeric_limits<std::int32_t>::max();

  const Wholes& a_;
  const Wholes& b_;
  Window in_;
  Same same_;
  std::ptrdiff_t rows_;
  std::ptrdiff_t columns_;
  std::vector<std::int32_t> firsts_{};  // of each d those of diagonals -d, -d + 2, ... d
  std::vector<std::size_t> begins_{};
};

void pair_by_reaches(const Wholes& a, const Wholes& b, Window in, Same same, Pairs& pairs) {
  if (in.a == in.a_end || in.b == in.b_end) return;
  Reaches reaches(a, b, in, same);
  if (reaches.find()) reaches.pair(pairs);
}

/// What is equal at both ends is paired at once.
void pair_up(const Wholes& a, const Wholes& b, Window in, Same same, Pairs& pairs) {
  while (in.a < in.a_end && in.b < in.b_end && same(a[in.a], b[in.b]))
    pairs.emplace_back(in.a++, in.b++);
  Pairs behind;
  while (in.a < in.a_end && in.b < in.b_end && same(a[in.a_end - 1], b[in.b_end - 1]))
    behind.emplace_back(--in.a_end, --in.b_end);
  pair_by_reaches(a, b, in, same, pairs);
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

using PairUp = void (*)(const Wholes&, const Wholes&, Window, Same, Pairs&);

/// Between the motions that are equal, those that are alike.
Pairs pairs_between(Pairs equal, const Wholes& olds, const Wholes& news, Same is_alike,
                    PairUp pair_alike) {
  Pairs pairs;
  Window gap{};
  equal.emplace_back(olds.size(), news.size());
  for (const auto& [a, b] : equal) {
    gap.a_end = a;
    gap.b_end = b;
    pair_alike(olds, news, gap, is_alike, pairs);
    if (a < olds.size()) pairs.emplace_back(a, b);
    gap.a = a + 1;
    gap.b = b + 1;
  }
  return pairs;
}

Pairs equal_pairs_of(const Wholes& olds, const Wholes& news) {
  Pairs equal;
  pair_up(olds, news, {0, olds.size(), 0, news.size()}, is_same, equal);
  return equal;
}

}  // namespace

// What came straight down comes straight down where it shall: nothing has to bring the tool there
// before, or a block that no row tells of.
void align(const Recording& recording, Span old, Vec3 begin, std::vector<PlannedRow>& rows) {
  const bool is_down =
      !rows.empty() && rows.front().was && is_upright(recording, *rows.front().was);
  if (is_down) begin = {rows.front().to.x, rows.front().to.y, begin.z};
  for (PlannedRow& row : rows) row.was.reset();
  const Wholes olds = olds_of(recording, old);
  const Wholes news = news_of(begin, rows);
  for (const auto& [a, b] :
       pairs_between(equal_pairs_of(olds, news), olds, news, is_same_sort, pair_up))
    rows[b].was = old.first + static_cast<std::uint32_t>(a);
}

void align_along(const Recording& recording, const std::vector<std::uint32_t>& olds, Vec3 begin,
                 std::vector<PlannedRow>& rows) {
  Wholes wholes;
  for (const std::uint32_t row : olds)
    wholes.push_back({recording.from(row), as_it_is(recording, row)});
  for (PlannedRow& row : rows) row.was.reset();
  const Wholes news = news_of(begin, rows);
  const Same is_along = recording.turns ? is_on_same_element<true> : is_on_same_element<false>;
  const Pairs along =
      pairs_between(equal_pairs_of(wholes, news), wholes, news, is_along, pair_by_reaches);
  for (const auto& [a, b] : pairs_between(along, wholes, news, is_same_kind, pair_by_reaches))
    rows[b].was = olds[a];
}

}  // namespace kerf::features
