// A glance says no, and that it is sure, only where the exact passage says so, too.
#include "stock/dexel/glance.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "mill.hpp"
#include "stock/dexel/posed_tool.hpp"

namespace kerf::stock::dexel::test {
namespace {

class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
  }
  std::size_t below(std::size_t count) { return random_() % count; }
  Vec3 place(double half) {
    return {(*this)(-half, half), (*this)(-half, half), (*this)(-half, half)};
  }

 private:
  std::mt19937 random_;
};

std::vector<Solid> all_solids() {
  std::vector<Solid> all;
  const std::vector<Body> bodies{ball(6),        flat(4),        bull(6, 1),
                                 pointed(6, 30), pointed(2, 85), t_slot(8, 2, 3),
                                 lollipop(5, 2), ball(0.4),      flat(60)};
  for (const Body& body : bodies) {
    const std::vector<Solid> solids = solids_of(body.profile, 1e-3);
    all.insert(all.end(), solids.begin(), solids.end());
  }
  return all;
}

/// Mostly short and level or along an axis, as programs have them.
Vec3 some_way(Draw& draw) {
  const double size = draw(0, 1) < 0.7 ? draw(0.01, 0.4) : draw(0.5, 30);
  Vec3 way = size * draw.place(1);
  if (draw(0, 1) < 0.5) way.z = draw(0, 1) < 0.5 ? 0 : way.z * 1e-4;
  if (draw(0, 1) < 0.3) way.y = 0;
  if (draw(0, 1) < 0.2) way.x = 0;
  return way;
}

Vec3 some_axis(Draw& draw) {
  const double choice = draw(0, 1);
  if (choice < 0.5) return {0, 0, 1};
  if (choice < 0.7) return {1, 0, 0};
  const double lean = choice < 0.8 ? 1e-6 : 1;
  return geometry::unit({lean * draw(-1, 1), lean * draw(-1, 1), draw(0.2, 1)});
}

struct Counts {
  int asked = 0;
  int no = 0;
  int no_exactly = 0;
  int surely = 0;
  int yes_exactly = 0;
};

/// One solid on one way, against rows of four dexels around it.
class Case {
 public:
  Case(Draw& draw, const Solid& solid)
      : draw_(draw),
        axis_(static_cast<int>(draw.below(3))),
        tip_(draw.place(200)),
        way_(some_way(draw)),
        frame_(Frame::of(some_axis(draw))),
        passage_(solid, frame_, tip_, way_, axis_),
        step_(draw(0.05, 1)) {
    if (draw(0, 1) < 0.5) passage_.follow(draw(0, 1) < 0.5 ? 0 : 0.4);
    Bounds box = swept(reach_of(solid, frame_), tip_, way_);
    cut(box.low, -1);
    cut(box.high, 1);
    box_ = {turned(box.low), turned(box.high)};
  }

  void ask(Counts& counts) {
    const Glance glance(passage_, tip_, {axis_, step_, box_});
    for (int i = 0; i < 40; ++i) ask_one(glance, counts);
  }

 private:
  [[nodiscard]] Vec3 turned(Vec3 v) const {
    return {on_axis(v, axis_), on_axis(v, (axis_ + 1) % 3), on_axis(v, (axis_ + 2) % 3)};
  }
  /// Tools without an end are looked at near their tip.
  void cut(Vec3& corner, double side) const {
    for (double Vec3::*one : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      const double most = tip_.*one + side * 50;
      corner.*one = side < 0 ? std::max(corner.*one, most) - 1 : std::min(corner.*one, most) + 1;
    }
  }
  void ask_one(const Glance& glance, Counts& counts) {
    const double b = draw_(box_.low.y, std::max(box_.low.y, box_.high.y - 3 * step_));
    const double c = draw_(box_.low.z, box_.high.z);
    float low[Glance::kLines];
    float high[Glance::kLines];
    Glance::Four from{};
    Glance::Four to{};
    for (int i = 0; i < Glance::kLines; ++i) {
      const double s = draw_(box_.low.x, box_.high.x);
      low[i] = static_cast<float>(s);
      high[i] = static_cast<float>(std::min(box_.high.x, s + draw_(0, 1) * draw_(0, 20)));
      from[i] = glance.offset(double{low[i]});
      to[i] = glance.offset(double{high[i]});
    }
    const Glance::Answer answer = glance.may_meet(b, c, from, to);
    for (int i = 0; i < Glance::kLines; ++i) {
      const Passage::Line line = passage_.line(b + i * step_, c);
      const bool exact = passage_.may_meet(line, double{low[i]}, double{high[i]});
      const bool may = (answer.may >> static_cast<unsigned>(i) & 1U) != 0;
      const bool is_sure = (answer.surely >> static_cast<unsigned>(i) & 1U) != 0;
      ASSERT_TRUE(may || !exact);
      ASSERT_TRUE(exact || !is_sure);
      ++counts.asked;
      counts.no += may ? 0 : 1;
      counts.no_exactly += exact ? 0 : 1;
      counts.surely += is_sure ? 1 : 0;
      counts.yes_exactly += exact ? 1 : 0;
    }
  }

  Draw& draw_;
  int axis_;
  Vec3 tip_;
  Vec3 way_;
  Frame frame_;
  Passage passage_;
  double step_;
  Bounds box_;
};

TEST(Glance, NeverSaysNoNorThatItIsSureWhereTheExactOneDiffers) {
  Draw draw(104);
  const std::vector<Solid> solids = all_solids();
  Counts counts;
  for (int i = 0; i < 4000 && !::testing::Test::HasFatalFailure(); ++i) {
    SCOPED_TRACE(i);
    Case one(draw, solids[draw.below(solids.size())]);
    one.ask(counts);
  }
  // And it is worth asking.
  EXPECT_GT(counts.no_exactly, counts.asked / 3);
  EXPECT_GT(counts.no, 0.7 * counts.no_exactly);
  EXPECT_GT(counts.surely, 0.3 * counts.yes_exactly);
}

}  // namespace
}  // namespace kerf::stock::dexel::test
