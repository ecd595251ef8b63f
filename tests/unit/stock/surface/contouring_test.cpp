// Surfaces of dexels and height fields: closed, of the right kind, with the volume of the model.
#include "stock/surface/contouring.hpp"

#include <cmath>
#include <cstdlib>
#include <map>
#include <random>

#include "../dexel/mill.hpp"
#include "../field/field_jobs.hpp"
#include "soundness.hpp"
#include "stock/surface/dexel_samples.hpp"
#include "stock/surface/height_samples.hpp"
#include "stock/surface/internal/cell_cycles.hpp"

namespace kerf::stock::surface::test {
namespace {

using std::numbers::pi;
namespace tri = dexel::test;

constexpr double kCell = 0.5;

Surface surface_of(const dexel::TriDexel& model, unsigned jobs = 1, int stride = 1) {
  return Contouring(DexelSamples(model, stride)).surface(jobs);
}
Surface surface_of(const field::HeightField& model, unsigned jobs = 1, int stride = 1) {
  return Contouring(HeightSamples(model.columns(), stride)).surface(jobs);
}

/// `euler`: 2 (pieces + cavities - handles).
void expect_sound(const Surface& surface, long euler, const Model& model) {
  const Soundness found = soundness(surface);
  EXPECT_TRUE(found.is_sound()) << found.text();
  EXPECT_EQ(found.euler, euler) << found.text();
  EXPECT_NEAR(found.volume_mm3, model.left_mm3(), model.error_mm3() + 1e-6 * model.stock_mm3())
      << found.text();
  EXPECT_EQ(surface.owners.size(), surface.mesh.triangles.size());
  EXPECT_EQ(surface.point_owners.size(), surface.mesh.points.size());
}

void expect_box(const Surface& surface, Vec3 low, Vec3 high) {
  const mesh::MeshBox box = mesh::box_of(surface.mesh);
  for (const auto& [is, wanted] : {std::pair{box.low.x, low.x},
                                   {box.low.y, low.y},
                                   {box.low.z, low.z},
                                   {box.high.x, high.x},
                                   {box.high.y, high.y},
                                   {box.high.z, high.z}}) {
    EXPECT_NEAR(is, wanted, 1e-4);
  }
}

TEST(CellCycles, EveryCrossedEdgeHasALineAndNoFormIsDoubledTwice) {
  for (int form = 0; form < 256; ++form) {
    const CellCycles& cycles = cycles_of(static_cast<std::uint8_t>(form));
    EXPECT_LE(cycles.count, 4);
    EXPECT_EQ(cycles.count == 0, form == 0 || form == 255);
    EXPECT_LE(__builtin_popcount(cycles.doubled), 1) << form;
    std::array<int, 4> edges{};
    for (int edge = 0; edge < kCellEdges; ++edge) {
      const int from = corner_number(edge_begin(edge));
      const int to = from + (1 << (edge / 4));
      const bool crossed = ((form >> from) & 1) != ((form >> to) & 1);
      const std::uint8_t line = cycles.of_edge[static_cast<std::size_t>(edge)];
      EXPECT_EQ(crossed, line != CellCycles::kNone);
      if (crossed) ++edges[line];
    }
    for (std::size_t line = 0; line < cycles.count; ++line) EXPECT_GE(edges[line], 3) << form;
  }
}

TEST(CellCycles, ADoubledLineBecomesTwoWhereItsFaceIsTurned) {
  int doubled = 0;
  for (int form = 0; form < 256; ++form) {
    const auto shape = static_cast<std::uint8_t>(form);
    if (cycles_of(shape).doubled == 0) continue;
    ++doubled;
    const CellCycles turned = make_cycles(shape, cycles_of(shape).doubled);
    EXPECT_EQ(turned.count, cycles_of(shape).count + 1) << form;
    EXPECT_EQ(turned.doubled, 0) << form;
  }
  EXPECT_GT(doubled, 0);
}

TEST(SurfaceOfDexels, OfABoxIsTheBox) {
  tri::Mill mill({{0, 0, -20}, {30, 20, 0}}, kCell);
  const Surface surface = surface_of(mill.model);
  expect_sound(surface, 2, mill.model);
  expect_box(surface, {0, 0, -20}, {30, 20, 0});
  EXPECT_NEAR(mesh::volume_mm3(surface.mesh), 12000, 1e-6);
}

TEST(SurfaceOfDexels, OfATubeHasAHandle) {
  tri::Mill mill(dexel::round_shape({2, 1, 2, -10, 10, 12, 6}), kCell);
  const Soundness found = soundness(surface_of(mill.model));
  EXPECT_TRUE(found.is_sound()) << found.text();
  EXPECT_EQ(found.euler, 0) << found.text();
  EXPECT_NEAR(found.volume_mm3, mill.model.stock_mm3(), 1e-4 * mill.model.stock_mm3());
}

TEST(SurfaceOfDexels, OfASlotKeepsItsEdges) {
  tri::Mill mill({{0, 0, -20}, {70, 40, 0}}, kCell);
  mill.tool(tri::flat(10)).at({-10, 20, 5}).line({-10, 20, -5}).line({80, 20, -5}).run();
  const Surface surface = surface_of(mill.model);
  expect_sound(surface, 2, mill.model);
  expect_box(surface, {0, 0, -20}, {70, 40, 0});
  EXPECT_NEAR(mesh::volume_mm3(surface.mesh), 70.0 * 40 * 20 - 70 * 10 * 5, 0.1);
}

TEST(SurfaceOfDexels, OfAHoleThroughHasAHandle) {
  tri::Mill mill({{0, 0, -10}, {30, 30, 0}}, kCell);
  mill.tool(tri::flat(10)).at({15, 15, 5}).line({15, 15, -15}).run();
  expect_sound(surface_of(mill.model), 0, mill.model);
}

TEST(SurfaceOfDexels, OfATSlotThroughHasNoHandle) {
  tri::Mill mill({{0, 0, -30}, {60, 40, 0}}, kCell);
  mill.tool(tri::flat(8)).at({-15, 20, -10}).line({75, 20, -10});
  mill.tool(tri::t_slot(16, 4, 7)).at({-15, 20, -10}).line({75, 20, -10}).run();
  expect_sound(surface_of(mill.model), 2, mill.model);
}

TEST(SurfaceOfDexels, OfALollipopsGrooveIsSound) {
  tri::Mill mill({{0, 0, -30}, {50, 40, 0}}, kCell);
  mill.tool(tri::flat(6)).at({-10, 20, -10}).line({60, 20, -10});
  mill.tool(tri::lollipop(12, 5)).at({-10, 20, -16}).line({60, 20, -16}).run();
  expect_sound(surface_of(mill.model), 2, mill.model);
}

TEST(SurfaceOfDexels, OfCrossingHolesHasFiveHandles) {
  tri::Mill mill({{-20, -20, -20}, {20, 20, 20}}, kCell);
  mill.tool(tri::flat(20)).at({0, 0, 45}).line({0, 0, -25}).axis({0, 1, 0});
  mill.at({0, 45, 0}).line({0, -25, 0}).run();
  expect_sound(surface_of(mill.model), 2 * (1 - 3), mill.model);
}

TEST(SurfaceOfDexels, OfATiltedCutIsSound) {
  tri::Mill mill({{-10, -30, -30}, {50, 30, 0}}, kCell);
  const double s = std::sin(pi / 6), c = std::cos(pi / 6);
  mill.tool(tri::flat(10)).axis({0, -s, c}).at({0, -30 * s, 30 * c});
  mill.line({0, 5 * s, -5 * c}).line({40, 5 * s, -5 * c}).run();
  expect_sound(surface_of(mill.model), 2, mill.model);
}

TEST(SurfaceOfDexels, ATurningCutIsSound) {
  tri::Mill mill({{-15, -30, -15}, {15, 30, 12}}, kCell);
  mill.tool(tri::ball(8, 40)).at({0, 0, 40}).line({0, 0, -4});
  for (const double angle : {30.0, -30.0, 0.0}) {
    const double s = std::sin(angle * pi / 180), c = std::cos(angle * pi / 180);
    mill.turn({0, 4 * s, -4 * c}, {0, -s, c});
  }
  mill.run();
  expect_sound(surface_of(mill.model), 2, mill.model);
}

TEST(SurfaceOfDexels, TwoPiecesAreTwoShells) {
  tri::Mill mill({{0, 0, -5}, {30, 20, 0}}, kCell);
  mill.tool(tri::flat(4)).at({15, -5, -6}).line({15, 25, -6}).run();
  const Surface surface = surface_of(mill.model);
  expect_sound(surface, 4, mill.model);
  EXPECT_EQ(soundness(surface).shells, 2U);
}

TEST(SurfaceOfDexels, FacesOnTheLinesOfDexelsAreSoundAndExact) {
  // The middles of cells lie at -0.5, -1.5 …: floor and walls run along dexels.
  tri::Mill mill({{0, 0, -10}, {20, 20, 0}}, 1);
  mill.tool(tri::flat(5)).at({-5, 10, -2.5}).line({25, 10, -2.5}).run();
  const Surface surface = surface_of(mill.model);
  EXPECT_TRUE(soundness(surface).is_sound()) << soundness(surface).text();
  EXPECT_EQ(soundness(surface).euler, 2);
  EXPECT_NEAR(mesh::volume_mm3(surface.mesh), 20 * 20 * 10 - 20 * 5 * 2.5, 0.5);
}

TEST(SurfaceOfDexels, CornersThatTouchArePiecesThatDoNot) {
  // Two cuts leave two blocks that meet in one edge, on the border of cells and beside it.
  for (const double by : {0.0, 0.1, 0.25}) {
    tri::Mill mill({{0, 0, -4}, {20, 20, 0}}, kCell);
    const double m = 10 + by;
    mill.tool(tri::flat(2)).at({-5, m + 1, -5});
    for (double y = m + 1; y < 22; y += 1) mill.line({-5, y, -5}).line({m - 1, y, -5});
    mill.at({25, m - 1, -5});
    for (double y = m - 1; y > -2; y -= 1) mill.line({25, y, -5}).line({m + 1, y, -5});
    mill.run();
    const Soundness found = soundness(surface_of(mill.model));
    EXPECT_TRUE(found.is_sound()) << by << " " << found.text();
  }
}

TEST(SurfaceOfDexels, OwnersAreTheMotionsThatCut) {
  tri::Mill mill({{0, 0, -10}, {20, 20, 0}}, kCell);
  mill.tool(tri::flat(6)).at({-5, 10, -2}).line({25, 10, -2});
  mill.at({10, 10, 5}).line({10, 10, -6}).run();
  const Surface surface = surface_of(mill.model);
  for (std::size_t i = 0; i < surface.owners.size(); ++i) {
    const mesh::Triangle& t = surface.mesh.triangles[i];
    const Vec3 middle = (1.0 / 3) * (surface.mesh.points[t[0]] + surface.mesh.points[t[1]] +
                                     surface.mesh.points[t[2]]);
    if (middle.z < -2.4 && middle.z > -5.6 && std::hypot(middle.x - 10, middle.y - 10) < 4) {
      EXPECT_EQ(surface.owners[i], 2U);
    }
    if (std::fabs(middle.z) < 1e-3 || middle.z < -9.9) {
      EXPECT_EQ(surface.owners[i], 0U);
    }
  }
}

TEST(SurfaceOfDexels, DoesNotDependOnThreadsAndBlocksFitTogether) {
  tri::Mill mill({{0, 0, -20}, {40, 40, 0}}, 0.4);
  mill.tool(tri::ball(9)).at({20, 20, 5}).line({20, 20, -5}).arc(10, 20, 5, -6).run();
  const Surface one = surface_of(mill.model, 1);
  const Surface several = surface_of(mill.model, 7);
  EXPECT_EQ(one.mesh.points, several.mesh.points);
  EXPECT_EQ(one.mesh.triangles, several.mesh.triangles);
  EXPECT_EQ(one.owners, several.owners);
  const DexelSamples samples(mill.model);
  const Contouring contouring(samples);
  std::map<std::uint64_t, Vec3> points;
  std::size_t triangles = 0;
  for (int x = 0; x < contouring.blocks()[0]; ++x) {
    for (int y = 0; y < contouring.blocks()[1]; ++y) {
      for (int z = 0; z < contouring.blocks()[2]; ++z) {
        const Patch patch = contouring.patch({x, y, z});
        triangles += patch.triangles.size();
        EXPECT_TRUE(std::is_sorted(patch.keys.begin(), patch.keys.end()));
        for (std::size_t i = 0; i < patch.keys.size(); ++i) {
          const auto [at, is_new] = points.emplace(patch.keys[i], patch.points[i]);
          EXPECT_EQ(at->second, patch.points[i]) << is_new;
        }
      }
    }
  }
  EXPECT_EQ(triangles, one.mesh.triangles.size());
}

TEST(SurfaceOfDexels, CoarserOnesAreSound) {
  tri::Mill mill({{0, 0, -20}, {41, 37, 0}}, 0.3);
  mill.tool(tri::ball(9)).at({20, 20, 5}).line({20, 20, -5}).arc(10, 20, 5, -6).run();
  for (const int stride : {2, 3, 4, 8, 64}) {
    const Surface surface = surface_of(mill.model, 1, stride);
    const Soundness found = soundness(surface);
    EXPECT_TRUE(found.is_sound()) << stride << " " << found.text();
    if (stride > 8) continue;
    EXPECT_NEAR(found.volume_mm3, mill.model.left_mm3(), 0.03 * mill.model.stock_mm3()) << stride;
  }
}

TEST(SurfaceOfDexels, RandomCutsAreSound) {
  const char* const wanted = std::getenv("KERF_SURFACES");
  const int count = wanted != nullptr ? std::atoi(wanted) : 12;
  for (int seed = 1; seed <= count; ++seed) {
    std::mt19937 random(static_cast<unsigned>(seed));
    const auto number = [&](double low, double high) {
      return low + (high - low) * (static_cast<double>(random() % 10007) / 10006);
    };
    const auto on_grid = [&](double low, double high) {
      return seed % 2 == 0 ? number(low, high) : std::round(number(low, high) * 2) / 2;
    };
    tri::Mill mill({{0, 0, -8}, {16, 16, 0}}, seed % 3 == 0 ? 1 : 0.5);
    for (int tools = 0; tools < 3; ++tools) {
      mill.tool(tools == 0   ? tri::flat(on_grid(1, 5))
                : tools == 1 ? tri::ball(on_grid(1, 5))
                             : tri::pointed(4, number(20, 60)));
      const Vec3 axis = seed % 4 == 0   ? unit(Vec3{number(-1, 1), number(-1, 1), number(-1, 1)})
                        : seed % 4 == 1 ? Vec3{1, 0, 0}
                                        : Vec3{0, 0, 1};
      mill.axis(axis).at({on_grid(0, 16), on_grid(0, 16), on_grid(-8, 0)});
      for (int moves = 0; moves < 12; ++moves)
        mill.line({on_grid(-2, 18), on_grid(-2, 18), on_grid(-9, 0)});
    }
    mill.run();
    const Soundness found = soundness(surface_of(mill.model));
    EXPECT_TRUE(found.is_sound()) << "seed " << seed << ": " << found.text();
    EXPECT_EQ(found.euler % 2, 0) << "seed " << seed;
  }
}

TEST(SurfaceOfHeights, OfAPocketKeepsItsEdges) {
  field::Job job({{0, 0, -20}, {60, 50, 0}}, kCell, field::flat(8));
  job.at({10, 10, 5}).to({10, 10, -6});
  for (double y = 10; y <= 40; y += 5) {
    const bool is_right = std::fmod(y, 10) == 0;
    job.to({is_right ? 10.0 : 50.0, y, -6}).to({is_right ? 50.0 : 10.0, y, -6});
  }
  job.to({50, 10, -6}).to({10, 10, -6}).to({10, 40, -6});
  const Surface surface = surface_of(job.field());
  expect_sound(surface, 2, job.field());
  expect_box(surface, {0, 0, -20}, {60, 50, 0});
}

TEST(SurfaceOfHeights, OfAHoleThroughHasAHandle) {
  field::Job job({{0, 0, -10}, {30, 30, 0}}, kCell, field::flat(10));
  job.at({15, 15, 5}).to({15, 15, -15});
  expect_sound(surface_of(job.field()), 0, job.field());
}

TEST(SurfaceOfHeights, OfABallsGrooveLiesOnTheBall) {
  field::Job job({{0, 0, -20}, {60, 40, 0}}, 0.2, field::ball(12));
  job.at({-10, 20, -3}).to({70, 20, -3});
  const Surface surface = surface_of(job.field());
  expect_sound(surface, 2, job.field());
  for (const Vec3& p : surface.mesh.points) {
    if (p.z > -0.3 || p.z < -3.5 || p.x < 1 || p.x > 59 || p.y < 5 || p.y > 35) continue;
    EXPECT_NEAR(std::hypot(p.y - 20, p.z - 3), 6, 0.02) << p.x << " " << p.y << " " << p.z;
  }
}

TEST(SurfaceOfHeights, RoundWallsAreSmootherThanTheirCells) {
  field::Job job({{-20, -20, -10}, {20, 20, 0}}, kCell, field::flat(6));
  job.at({10, 0, 5}).to({10, 0, -4}).turn({0, 0, -4}, 2 * pi);
  const Surface surface = surface_of(job.field());
  expect_sound(surface, 2, job.field());
  double square = 0;
  int count = 0;
  for (const Vec3& p : surface.mesh.points) {
    const double r = std::hypot(p.x, p.y);
    if (p.z > -0.5 || p.z < -3.5 || r < 10 || r > 15) continue;
    EXPECT_NEAR(r, 13, kCell) << p.x << " " << p.y;
    square += (r - 13) * (r - 13);
    ++count;
  }
  // A wall of steps would have about 0.29 cells.
  EXPECT_LT(std::sqrt(square / count), 0.12 * kCell);
}

TEST(SurfaceOfHeights, WallsBelongToWhoMadeThem) {
  // A disc of 40 that is faced: its mantle is the stock's own. A plunge of 12: the wall is its.
  const auto disc = [](double x, double y) -> field::Column {
    return std::hypot(x, y) < 20 ? field::Column{-10, 0} : field::Column{};
  };
  field::HeightField model(field::grid_of({{-21, -21, -10}, {21, 21, 0}}, kCell), disc, 1);
  const BodyId face = model.add_body(field::flat(60));
  const BodyId mill = model.add_body(field::flat(12));
  const std::array<Sweep, 2> sweeps{
      {{.way = StraightWay{{0, 0, 1}, {0, 0, -1}}, .body = face, .motion = 1},
       {.way = StraightWay{{0, 0, 1}, {0, 0, -6}}, .body = mill, .motion = 2}}};
  std::array<Outcome, 2> outcomes;
  model.cut(sweeps, outcomes);
  const Surface surface = surface_of(model);
  int mantle = 0, wall = 0;
  for (std::size_t i = 0; i < surface.owners.size(); ++i) {
    const mesh::Triangle& t = surface.mesh.triangles[i];
    const Vec3 middle = (1.0 / 3) * (surface.mesh.points[t[0]] + surface.mesh.points[t[1]] +
                                     surface.mesh.points[t[2]]);
    const double r = std::hypot(middle.x, middle.y);
    if (middle.z > -8 && middle.z < -2.5 && r > 18) {
      EXPECT_EQ(surface.owners[i], 0U) << r;
      ++mantle;
    }
    if (middle.z > -4.5 && middle.z < -2.5 && r < 8) {
      EXPECT_EQ(surface.owners[i], 2U) << r;
      ++wall;
    }
  }
  EXPECT_GT(mantle, 100);
  EXPECT_GT(wall, 30);
}

TEST(SurfaceOfHeights, RandomCutsAreSound) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937 random(seed);
    const auto place = [&](double low, double high) {
      const double at = low + (high - low) * (static_cast<double>(random() % 10007) / 10006);
      return seed % 2 == 0 ? at : std::round(at * 4) / 4;
    };
    field::Job job({{0, 0, -8}, {16, 16, 0}}, seed % 3 == 0 ? 1 : 0.5, field::flat(3));
    job.at({5, 5, -2});
    for (int i = 0; i < 30; ++i) {
      if (i == 10) job.with_tool(field::ball(4));
      if (i == 20) job.with_tool(field::cone(4, 60, 0.5));
      job.to({place(-2, 18), place(-2, 18), place(-9, 0)});
    }
    const Surface surface = surface_of(job.field());
    const Soundness found = soundness(surface);
    EXPECT_TRUE(found.is_sound()) << "seed " << seed << ": " << found.text();
    EXPECT_NEAR(found.volume_mm3, job.field().left_mm3(), job.field().error_mm3() + 1);
  }
}

}  // namespace
}  // namespace kerf::stock::surface::test
