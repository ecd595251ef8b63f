#include "drawing/internal/joining.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "drawing/internal/end_pairs.hpp"

namespace kerf::drawing {
namespace {

using contour::Contour;
using contour::Vertex;
using Number = std::uint32_t;

std::vector<PathEnd> ends_of(const std::vector<Chain>& open, const Drawing& drawing) {
  std::vector<PathEnd> ends;
  ends.reserve(2 * open.size());
  for (const Chain& chain : open) {
    const Group group = group_of(drawing.entities[chain.entity]);
    const contour::Edge first = edge_of(chain.path, 0);
    const contour::Edge last = edge_of(chain.path, edge_count(chain.path) - 1);
    ends.push_back({first.from, -tangent_at_start(first), group});
    ends.push_back({last.to, tangent_at_end(last), group});
  }
  return ends;
}

Number other_end(Number end) { return end ^ 1U; }

/// Walks along paths and from end to end.
class Joiner {
 public:
  Joiner(const std::vector<Chain>& open, const std::vector<PathEnd>& ends,
         const std::vector<Partner>& partners)
      : open_(open), ends_(ends), partners_(partners), used_(open.size()) {}

  [[nodiscard]] std::vector<Chain> chains() {
    std::vector<Chain> made;
    for (Number path = 0; path < open_.size(); ++path)
      if (!used_[path]) made.push_back(chain_through(path));
    return made;
  }

 private:
  /// The end that a way begins with which goes through the path in its direction.
  [[nodiscard]] Number first_of(Number path) const {
    Number begin = 2 * path;
    for (Number before = partners_[begin]; before != kAlone; before = partners_[begin]) {
      begin = other_end(before);
      if (begin == 2 * path) break;  // all round
    }
    return begin;
  }

  Chain chain_through(Number path) {
    const Number first = first_of(path);
    Chain chain{{{}, false}, open_[path].entity};
    Number begin = first;
    while (true) {
      append(chain, begin);
      const Number next = partners_[other_end(begin)];
      if (next == kAlone) break;
      if (next == first) {
        close(chain, begin);
        break;
      }
      begin = next;
    }
    return chain;
  }

  [[nodiscard]] Vec2 place_of(Number end) const {
    const Partner partner = partners_[end];
    if (partner == kAlone) return ends_[end].at;
    return 0.5 * (ends_[end].at + ends_[partner].at);
  }

  void append(Chain& chain, Number begin) {
    const Number path = begin / 2;
    used_[path] = true;
    chain.entity = std::min(chain.entity, open_[path].entity);
    const Contour way = begin % 2 == 0 ? open_[path].path : reversed(open_[path].path);
    std::vector<Vertex>& vertices = chain.path.vertices;
    if (!vertices.empty()) vertices.pop_back();
    const std::size_t from = vertices.size();
    vertices.insert(vertices.end(), way.vertices.begin(), way.vertices.end());
    vertices[from].point = place_of(begin);
    vertices.back().point = place_of(other_end(begin));
  }

  static void close(Chain& chain, Number /*last*/) {
    chain.path.vertices.pop_back();
    chain.path.is_closed = true;
  }

  const std::vector<Chain>& open_;
  const std::vector<PathEnd>& ends_;
  const std::vector<Partner>& partners_;
  std::vector<bool> used_;
};

void tell_gaps(const std::vector<EndPair>& gaps, const std::vector<Chain>& open,
               const Drawing& drawing, Canvas& canvas) {
  for (const EndPair& gap : gaps) {
    const Entity& entity = drawing.entities[open[gap.second / 2].entity];
    canvas.find(
        base::Severity::warning, base::Code::draw_gap, {entity.file, entity.line, 1},
        fmt::format("{} on layer {} ends {:.3f} mm from another end", drawing.names[entity.kind],
                    drawing.names[entity.layer], gap.distance_mm),
        entity.layer, entity.kind, "--join");
  }
}

}  // namespace

Joined join_ends(std::vector<Chain> chains, const Drawing& drawing, double join_mm,
                 Canvas& canvas) {
  std::vector<Chain> open;
  Joined result;
  for (Chain& chain : chains)
    (chain.path.is_closed ? result.chains : open).push_back(std::move(chain));
  const std::vector<PathEnd> ends = ends_of(open, drawing);
  const std::vector<Partner> partners = partners_of(ends, join_mm);
  for (Number end = 0; end < ends.size(); ++end)
    if (partners[end] != kAlone && end < partners[end]) ++result.joined;
  std::vector<Chain> made = Joiner(open, ends, partners).chains();
  std::move(made.begin(), made.end(), std::back_inserter(result.chains));
  std::stable_sort(result.chains.begin(), result.chains.end(),
                   [](const Chain& a, const Chain& b) { return a.entity < b.entity; });
  const std::vector<EndPair> gaps = near_pairs(ends, partners, 10 * join_mm);
  result.gaps = gaps.size();
  tell_gaps(gaps, open, drawing, canvas);
  return result;
}

}  // namespace kerf::drawing
