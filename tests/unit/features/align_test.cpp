// Which rows of an edited layer keep the blocks of which old ones.
#include <gtest/gtest.h>

#include <random>

#include "feature_path.hpp"
#include "features/rewrite/planned_row.hpp"

namespace kerf::features {
namespace {

struct Step {
  Vec3 from{};
  Vec3 to{};
  bool is_rapid = false;
};
using Way = std::vector<Step>;

/// Few places, so that many motions are equal.
Way random_way(std::mt19937& random, std::size_t steps) {
  std::uniform_int_distribution<int> place(0, 2);
  std::uniform_int_distribution<int> level(0, 1);
  Way way;
  for (Vec3 at{}; way.size() < steps;) {
    const Vec3 to{1.0 * place(random), 1.0 * place(random), -1.0 * level(random)};
    if (to == at) continue;
    way.push_back({at, to, place(random) == 0});
    at = to;
  }
  return way;
}

/// Some steps of another way, with others between them.
Way like(const Way& way, std::mt19937& random) {
  std::uniform_int_distribution<int> dice(0, 5);
  Way made;
  Vec3 at{};
  const auto go = [&](Vec3 to, bool is_rapid) {
    if (!(to == at)) made.push_back({at, to, is_rapid});
    at = to;
  };
  for (const Step& step : way) {
    if (dice(random) == 0) go({5.0 + dice(random), 0, step.to.z}, step.is_rapid);
    if (dice(random) != 0) go(step.to, step.is_rapid);
  }
  return made;
}

void record(const Way& way, test::FeaturePath& path) {
  path.tool(1, 10).rapid(0, 0, 0);
  for (const Step& step : way) {
    if (step.is_rapid) {
      path.rapid(step.to.x, step.to.y, step.to.z);
    } else {
      path.line(step.to.x, step.to.y, step.to.z);
    }
  }
}

bool is_equal(const Step& a, const Step& b) {
  return a.is_rapid == b.is_rapid && a.from == b.from && a.to == b.to;
}
bool is_of_one_sort(const Step& a, const Step& b) {
  const auto is_upright = [](const Step& s) { return s.from.x == s.to.x && s.from.y == s.to.y; };
  return a.is_rapid == b.is_rapid && is_upright(a) == is_upright(b);
}

/// Of two ways the longest common row, by the table of all pairs.
template <typename Same>
std::size_t common(const Way& a, const Way& b, Same same) {
  std::vector<std::vector<std::size_t>> table(a.size() + 1,
                                              std::vector<std::size_t>(b.size() + 1, 0));
  for (std::size_t i = a.size(); i-- > 0;) {
    for (std::size_t j = b.size(); j-- > 0;) {
      table[i][j] =
          same(a[i], b[j]) ? table[i + 1][j + 1] + 1 : std::max(table[i + 1][j], table[i][j + 1]);
    }
  }
  return table[0][0];
}

Way part(const Way& way, std::size_t first, std::size_t end) {
  return {way.begin() + static_cast<std::ptrdiff_t>(first),
          way.begin() + static_cast<std::ptrdiff_t>(end)};
}

struct Pair {
  std::size_t a = 0;
  std::size_t b = 0;
};

/// `align` of ways that begin in row 1 of a recording.
std::vector<Pair> aligned(const Way& olds, const Way& news) {
  test::FeaturePath path;
  record(olds, path);
  const Recording& recording = path.recording();
  std::vector<PlannedRow> rows;
  for (const Step& step : news)
    rows.push_back({.to = step.to, .kind = step.is_rapid ? Move::Kind::rapid : Move::Kind::feed});
  const auto first = static_cast<std::uint32_t>(recording.moves.size() - olds.size());
  align(recording, {first, static_cast<std::uint32_t>(recording.moves.size() - 1)}, {}, rows);
  std::vector<Pair> pairs;
  for (std::size_t b = 0; b < rows.size(); ++b) {
    if (rows[b].was) pairs.push_back({*rows[b].was - first, b});
  }
  return pairs;
}

// Between two pairs of equals as many of one sort as the table of all pairs finds.
void expect_sorts_between(const Way& olds, const Way& news, const std::vector<Pair>& pairs) {
  std::size_t a = 0, b = 0, of_sort = 0;
  const auto close = [&](std::size_t a_end, std::size_t b_end) {
    EXPECT_EQ(of_sort, common(part(olds, a, a_end), part(news, b, b_end), is_of_one_sort));
    of_sort = 0;
    a = a_end + 1;
    b = b_end + 1;
  };
  for (const Pair& pair : pairs) {
    if (is_equal(olds[pair.a], news[pair.b])) {
      close(pair.a, pair.b);
    } else {
      ++of_sort;
    }
  }
  close(olds.size(), news.size());
}

TEST(Align, KeepsTheLongestCommonRowOfEqualMotionsAndBetweenThemOfTheSameSort) {
  std::mt19937 random(7);
  for (int i = 0; i < 3000; ++i) {
    const Way olds = random_way(random, static_cast<std::size_t>(i % 40 + 1));
    const Way news =
        i % 3 == 0 ? random_way(random, static_cast<std::size_t>(i % 29 + 1)) : like(olds, random);
    const std::vector<Pair> pairs = aligned(olds, news);
    std::size_t equal = 0;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      ASSERT_TRUE(k == 0 || pairs[k - 1].a < pairs[k].a);
      ASSERT_TRUE(is_of_one_sort(olds[pairs[k].a], news[pairs[k].b]));
      if (is_equal(olds[pairs[k].a], news[pairs[k].b])) ++equal;
    }
    ASSERT_EQ(equal, common(olds, news, is_equal)) << "way " << i;
    expect_sorts_between(olds, news, pairs);
  }
}

TEST(Align, OfManyMotionsThatHaveNothingInCommonKeepsTheirBlocksByTheirSort) {
  Way olds, news;
  for (int i = 0; i < 20'000; ++i) {
    olds.push_back({{1.0 * i, 0, 0}, {1.0 + i, 0, 0}});
    news.push_back({{1.0 * i, 9, 0}, {1.0 + i, 9, 0}});
  }
  news.front().from = {};
  EXPECT_EQ(aligned(olds, news).size(), 20'000);
}

}  // namespace
}  // namespace kerf::features
