#include "geometry/contour/offset.hpp"

#include <cmath>

#include "geometry/contour/internal/arrangement.hpp"
#include "geometry/contour/internal/chain.hpp"
#include "geometry/contour/tolerance.hpp"

namespace kerf::contour {
namespace {

bool is_kept(Winding w) { return w.first > 0; }

// What owns the round ends while the parallel is looked for.
constexpr std::uint32_t kEnd = ~std::uint32_t{0};

// Forth and back, each edge owned by its number among those that go forth, all else by kEnd.
std::vector<Link> numbered(std::vector<Link> chain) {
  const std::size_t forth = chain.size() / 2;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const std::uint32_t owner = i < forth ? static_cast<std::uint32_t>(i) : kEnd;
    chain[i].edge.owner = owner;
    chain[i].corner_owner = i + 1 == forth ? kEnd : owner;
  }
  return chain;
}

// The edges of a loop from `begin` on that belong to the parallel, as an open contour.
Contour run_from(const Contour& loop, std::size_t begin) {
  Contour run{{}, false};
  const std::size_t count = loop.vertices.size();
  for (std::size_t i = begin; i < begin + count; ++i) {
    const Vertex& vertex = loop.vertices[i % count];
    run.vertices.push_back(vertex);
    if (vertex.owner == kEnd) break;
  }
  run.vertices.back().bulge = 0;
  return run;
}

void take_runs(const Contour& loop, std::vector<Contour>& runs) {
  const std::size_t count = loop.vertices.size();
  for (std::size_t i = 0; i < count; ++i) {
    const bool was_end = loop.vertices[i == 0 ? count - 1 : i - 1].owner == kEnd;
    if (was_end && loop.vertices[i].owner != kEnd) runs.push_back(run_from(loop, i));
  }
}

void own(Contour& run, const std::vector<Link>& chain) {
  for (Vertex& vertex : run.vertices) {
    vertex.owner = vertex.owner == kEnd ? 0 : chain[vertex.owner].edge.owner;
  }
}

}  // namespace

Region offset(const Region& region, double distance) {
  if (std::fabs(distance) <= kSame_mm || !(std::fabs(distance) <= kFarthest_mm)) return region;
  std::vector<Strand> strands;
  for (const Contour& loop : region.loops) add_raw_offset(strands, chain_of(loop), distance);
  return {Arrangement(std::move(strands)).loops(is_kept)};
}

std::vector<Contour> parallel(const Contour& open, double distance) {
  if (distance < 0) {
    std::vector<Contour> mirrored = parallel(reversed(open), -distance);
    std::vector<Contour> result;
    for (auto run = mirrored.rbegin(); run != mirrored.rend(); ++run) {
      result.push_back(reversed(*run));
    }
    return result;
  }
  const auto chains = chains_round(open);
  if (chains.size() != 1 || !(distance > kSame_mm) || distance > kFarthest_mm) return {};
  std::vector<Strand> strands;
  add_raw_offset(strands, numbered(chains.front()), distance);
  std::vector<Contour> runs;
  for (const Contour& loop : Arrangement(std::move(strands)).loops(is_kept)) take_runs(loop, runs);
  std::sort(runs.begin(), runs.end(), [](const Contour& a, const Contour& b) {
    return a.vertices.front().owner < b.vertices.front().owner;
  });
  for (Contour& run : runs) own(run, chains.front());
  return runs;
}

}  // namespace kerf::contour
