#include "process/order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "seeded_random.hpp"

namespace kerf::process {
namespace {

constexpr Ends kBackToZero{{0, 0}, true, {0, 0}};

using Random = test::SeededRandom;

Vec2 place_in(Random& random, double side = 100) {
  return {random.in(0, side), random.in(0, side)};
}

Item dot_at(Vec2 at) { return {{{at, at}}, {}}; }
Item line_of(Vec2 a, Vec2 b) { return {{{a, b}, {b, a}}, {}}; }
Item square_about(Vec2 c, double half) {
  Item item;
  for (const Vec2 d : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}})
    item.entries.push_back({c + half * d, c + half * d});
  return item;
}

Item any_item(Random& random) {
  const Vec2 at = place_in(random);
  switch (random.count(0, 3)) {
    case 0: return dot_at(at);
    case 1: return line_of(at, place_in(random));
    case 2: return square_about(at, random.in(0, 20));
    default: return {{{at, place_in(random)}}, {}};  // with leads: only in one direction
  }
}

std::vector<Item> any_items(Random& random, int count) {
  std::vector<Item> items;
  for (int i = 0; i < count; ++i) items.push_back(any_item(random));
  return items;
}

Item& at(std::vector<Item>& items, int which) { return items[static_cast<std::size_t>(which)]; }

/// Each has, with some probability, to be made before one that comes later in the list: a forest.
void nest(std::vector<Item>& items, Random& random, double share) {
  const auto last = static_cast<int>(items.size()) - 1;
  for (int i = 0; i < last; ++i) {
    if (random.in(0, 1) >= share) continue;
    at(items, random.count(i + 1, last)).before.push_back(static_cast<std::uint32_t>(i));
  }
}

double length_of(const std::vector<Item>& items, const Ends& ends, const std::vector<Turn>& turns) {
  double sum = 0;
  Vec2 at = ends.from;
  for (const Turn& turn : turns) {
    const Entry& entry = items[turn.item].entries.at(turn.entry);
    sum += std::hypot(entry.begin.u - at.u, entry.begin.v - at.v);
    at = entry.end;
  }
  return ends.comes_back ? sum + std::hypot(ends.to.u - at.u, ends.to.v - at.v) : sum;
}

bool keeps_before(const std::vector<Item>& items, const std::vector<Turn>& turns) {
  std::vector<std::size_t> place(items.size());
  for (std::size_t i = 0; i < turns.size(); ++i) place[turns[i].item] = i;
  for (std::size_t i = 0; i < items.size(); ++i) {
    for (const std::uint32_t before : items[i].before) {
      if (place[before] > place[i]) return false;
    }
  }
  return true;
}

bool has_each_once(const std::vector<Turn>& turns, std::size_t count) {
  std::vector<std::size_t> items;
  for (const Turn& turn : turns) items.push_back(turn.item);
  std::sort(items.begin(), items.end());
  if (items.size() != count) return false;
  for (std::size_t i = 0; i < count; ++i) {
    if (items[i] != i) return false;
  }
  return true;
}

/// Tries everything.
double least_of_all(const std::vector<Item>& items, const Ends& ends, std::vector<Turn>& made,
                    std::vector<bool>& is_made, Vec2 at, double way) {
  if (made.size() == items.size())
    return ends.comes_back ? way + std::hypot(ends.to.u - at.u, ends.to.v - at.v) : way;
  double least = 1e300;
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    const auto is_there = [&](std::uint32_t before) { return is_made[before]; };
    if (is_made[i] || !std::all_of(items[i].before.begin(), items[i].before.end(), is_there))
      continue;
    is_made[i] = true;
    for (const Entry& entry : items[i].entries) {
      made.push_back({i, 0});
      const double here = way + std::hypot(entry.begin.u - at.u, entry.begin.v - at.v);
      least = std::min(least, least_of_all(items, ends, made, is_made, entry.end, here));
      made.pop_back();
    }
    is_made[i] = false;
  }
  return least;
}

double least_of_all(const std::vector<Item>& items, const Ends& ends) {
  std::vector<Turn> made;
  std::vector<bool> is_made(items.size());
  return least_of_all(items, ends, made, is_made, ends.from, 0);
}

TEST(Order, of_few_items_is_the_best_there_is) {
  for (unsigned seed = 0; seed < 120; ++seed) {
    Random random{seed};
    std::vector<Item> items = any_items(random, random.count(1, seed < 10 ? 7 : 5));
    if (seed % 3 == 0) nest(items, random, 0.4);
    const Ends ends{place_in(random), seed % 2 == 0, place_in(random)};
    const Order order = find_order(items, ends);
    EXPECT_NEAR(order.travel_mm, least_of_all(items, ends), 1e-9) << "seed " << seed;
    EXPECT_TRUE(keeps_before(items, order.turns)) << "seed " << seed;
  }
}

TEST(Order, of_nine_rings_that_may_be_begun_anywhere_is_found_exactly) {
  // Rings along a line: there on one side, back on the other; each is passed at no cost inside.
  std::vector<Item> rings;
  for (int i = 0; i < 9; ++i) {
    Item ring;
    for (int k = 0; k < 90; ++k) {
      const double angle = k * std::acos(-1.0) / 45;
      const Vec2 at{20.0 * (i + 1) + 5 * std::cos(angle), 5 * std::sin(angle)};
      ring.entries.push_back({at, at});
    }
    rings.push_back(ring);
  }
  // To the left end of the last, at 175, and home: some on the way there, some on the way back.
  const double travel_mm = find_order(rings, kBackToZero).travel_mm;
  EXPECT_GE(travel_mm, 2 * 175.0 - 1e-9);
  EXPECT_LE(travel_mm, 2 * 175.0 + 0.5);
}

TEST(Order, tells_the_way_that_it_is) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    Random random{seed};
    std::vector<Item> items = any_items(random, random.count(1, 200));
    if (seed % 2 == 0) nest(items, random, 0.5);
    const Ends ends{place_in(random), seed % 3 != 0, place_in(random)};
    const Order order = find_order(items, ends);
    ASSERT_TRUE(has_each_once(order.turns, items.size())) << "seed " << seed;
    EXPECT_NEAR(order.travel_mm, length_of(items, ends, order.turns), 1e-6);
    EXPECT_TRUE(keeps_before(items, order.turns)) << "seed " << seed;
    EXPECT_LE(order.travel_mm, order.travel_nearest_mm + 1e-9) << "seed " << seed;
    const Order as_drawn = file_order(items, ends);
    EXPECT_EQ(as_drawn.travel_mm, order.travel_file_mm);
    EXPECT_EQ(as_drawn.travel_nearest_mm, order.travel_nearest_mm);
    EXPECT_NEAR(as_drawn.travel_mm, length_of(items, ends, as_drawn.turns), 1e-6);
    if (keeps_before(items, as_drawn.turns)) {
      EXPECT_LE(order.travel_mm, order.travel_file_mm + 1e-9) << "seed " << seed;
    }
  }
}

TEST(Order, is_not_worse_than_a_good_one_of_the_file) {
  // Round a circle of 400 places, as drawn: nothing is shorter.
  std::vector<Item> items;
  for (int i = 0; i < 400; ++i) {
    const double angle = i * std::acos(-1.0) / 200;
    items.push_back(dot_at({100 * std::cos(angle), 100 * std::sin(angle)}));
  }
  const Order order = find_order(items, {{100, 0}, true, {100, 0}});
  EXPECT_NEAR(order.travel_mm, order.travel_file_mm, 1e-9);
  EXPECT_NEAR(order.travel_mm, 400 * 200 * std::sin(std::acos(-1.0) / 400), 1e-6);
}

TEST(Order, of_ten_thousand_places_is_near_the_best) {
  Random random{1};
  std::vector<Item> items;
  for (int i = 0; i < 10'000; ++i) items.push_back(dot_at(place_in(random, 1000)));
  const Order order = find_order(items, kBackToZero);
  const double measure = std::sqrt(10'000 * 1e6);
  EXPECT_LE(order.travel_mm, 0.78 * measure);
  EXPECT_GE(order.travel_mm, 0.70 * measure);  // shorter than the shortest there can be
  EXPECT_NEAR(order.travel_nearest_mm, 0.9 * measure, 0.04 * measure);
}

TEST(Order, of_lines_uses_both_directions) {
  // A comb of lines: up the one, down the next, and never back without a cut.
  std::vector<Item> items;
  for (int i = 0; i < 100; ++i) items.push_back(line_of({double(i), 0}, {double(i), 50}));
  EXPECT_NEAR(find_order(items, {{0, 0}, false, {}}).travel_mm, 99, 1e-9);
}

/// Parts of an outline with four holes each, and some with a part inside of a hole.
std::vector<Item> sheet(std::uint32_t parts, Random& random) {
  std::vector<Item> items;
  for (std::uint32_t i = 0; i < parts; ++i) {
    const Vec2 centre = place_in(random, 10 * std::sqrt(parts) * 3);
    Item outline = square_about(centre, 10);
    for (const Vec2 d : {Vec2{-5, -5}, Vec2{5, -5}, Vec2{5, 5}, Vec2{-5, 5}}) {
      outline.before.push_back(static_cast<std::uint32_t>(items.size()));
      items.push_back(square_about(centre + d, 1));
    }
    items.push_back(outline);
  }
  return items;
}

TEST(Order, makes_what_is_inside_first_and_parts_one_after_the_other) {
  Random random{3};
  const std::vector<Item> items = sheet(400, random);
  const Order order = find_order(items, kBackToZero);
  EXPECT_TRUE(keeps_before(items, order.turns));
  EXPECT_LT(order.travel_mm, 0.97 * order.travel_nearest_mm);
}

TEST(Order, of_a_chain_is_the_chain) {
  Random random{5};
  std::vector<Item> items;
  for (std::uint32_t i = 0; i < 60; ++i) {
    items.push_back(dot_at(place_in(random)));
    if (i > 0) items.back().before = {i - 1};
  }
  const Order order = find_order(items, kBackToZero);
  for (std::uint32_t i = 0; i < 60; ++i) EXPECT_EQ(order.turns[i].item, i);
  EXPECT_EQ(order.travel_mm, order.travel_file_mm);
}

TEST(Order, ends_where_what_must_be_before_goes_in_circles) {
  for (const std::uint32_t count : {3U, 40U}) {
    Random random{count};
    std::vector<Item> items;
    for (std::uint32_t i = 0; i < count; ++i) {
      items.push_back(dot_at(place_in(random)));
      items.back().before = {(i + 1) % count, i, 4'000'000'000U};
    }
    EXPECT_TRUE(has_each_once(find_order(items, kBackToZero).turns, count));
  }
}

TEST(Order, of_nothing_and_of_one_place_many_times) {
  const Order none = find_order({}, {{1, 1}, true, {4, 5}});
  EXPECT_TRUE(none.turns.empty());
  EXPECT_EQ(none.travel_mm, 5);
  const std::vector<Item> same(500, dot_at({3, 4}));
  const Order order = find_order(same, kBackToZero);
  EXPECT_TRUE(has_each_once(order.turns, 500));
  EXPECT_EQ(order.travel_mm, 10);
}

TEST(Order, is_the_same_for_the_same_items) {
  Random random{11};
  const std::vector<Item> items = sheet(60, random);
  const Order one = find_order(items, kBackToZero);
  const Order other = find_order(items, kBackToZero);
  EXPECT_EQ(one.travel_mm, other.travel_mm);
  EXPECT_TRUE(std::equal(
      one.turns.begin(), one.turns.end(), other.turns.begin(),
      [](const Turn& a, const Turn& b) { return a.item == b.item && a.entry == b.entry; }));
}

TEST(Order, of_a_drawing_that_is_turned_and_mirrored_is_as_long) {
  Random random{13};
  std::vector<Item> items = any_items(random, 8);
  std::vector<Item> turned = items;
  for (Item& item : turned) {
    for (Entry& entry : item.entries)
      entry = {{entry.begin.v, entry.begin.u}, {entry.end.v, entry.end.u}};
  }
  EXPECT_NEAR(find_order(items, kBackToZero).travel_mm, find_order(turned, kBackToZero).travel_mm,
              1e-9);
}

}  // namespace
}  // namespace kerf::process
