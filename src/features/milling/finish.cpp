#include "features/milling/finish.hpp"

#include <algorithm>
#include <cmath>

#include "features/milling/classify.hpp"
#include "features/milling/contour_shapes.hpp"
#include "features/milling/strategy.hpp"
#include "features/milling/tool_reach.hpp"
#include "features/path/tolerance.hpp"
#include "features/tree/key.hpp"

namespace kerf::features {
namespace {

using contour::Box;
using contour::Contour;

constexpr double kMostOfDrilled = 3;  // a round pocket up to so many times a hole is its step
constexpr double kAlongWall = 0.9;    // of its length

template <typename List>
void add_all(List& to, const List& more) {
  to.insert(to.end(), more.begin(), more.end());
}

/// Of a draft all of whose layers are one disc; nothing: they are not.
std::optional<Disc> disc_of_all(const Draft& draft) {
  if (!has_levels(draft.feature.type)) return std::nullopt;
  std::optional<Disc> disc;
  for (const Layer& layer : draft.feature.layers) {
    disc = disc_of(layer.contour);
    if (!disc || !layer.islands.empty()) return std::nullopt;
  }
  return disc;
}

HoleStep step_of(const Draft& draft, const Disc& disc) {
  HoleStep step{.how = HoleStep::How::mill, .tool = draft.feature.tool};
  step.operation = draft.shares.front().operation;
  step.diameter = 2 * disc.radius;
  step.top = draft.feature.layers.front().top;
  step.bottom = draft.feature.layers.back().z;
  for (const Layer& layer : draft.feature.layers) {
    add_all(step.rows, layer.cuts);
    add_all(step.rows, layer.entries);
    add_all(step.visits, layer.visits);
  }
  std::sort(step.rows.begin(), step.rows.end(),
            [](const Span& a, const Span& b) { return a.first < b.first; });
  return step;
}

// Round pockets about the axis of a hole are steps of it.
void give_to_holes(HoleBook& holes, std::vector<Draft>& drafts) {
  for (Draft& draft : drafts) {
    const auto disc = disc_of_all(draft);
    if (!disc || draft.shares.size() > 1) continue;
    const auto* const hole = holes.find(draft.feature.setup, disc->centre, kRounded_mm);
    if (hole == nullptr) continue;
    const double drilled = drilled_diameter(hole->steps);
    if (drilled <= 0 || 2 * disc->radius > kMostOfDrilled * drilled + kSamePoint_mm) continue;
    holes.add(draft.feature.setup, hole->at, step_of(draft, *disc));
    draft.is_gone = true;
  }
}

void tell_heights(Draft& draft, const Blank& blank) {
  Feature& feature = draft.feature;
  feature.top = feature.layers.front().top;
  feature.bottom = feature.layers.back().z;
  feature.through = blank.is_known && feature.bottom <= blank.bottom + kSameZ_mm;
}

std::optional<double> stepdown_of(const Feature& feature) {
  if (feature.layers.size() < 2) return std::nullopt;
  std::vector<double> steps;
  for (std::size_t i = 1; i < feature.layers.size(); ++i)
    steps.push_back(feature.layers[i - 1].z - feature.layers[i].z);
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

Compensation compensation_of(const Recording& recording, const Layer& layer) {
  for (const Span& span : layer.cuts) {
    for (std::uint32_t row = span.first; row <= span.last; ++row) {
      const Compensation side = recording.state_of(recording.moves[row]).compensation;
      if (side != Compensation::none) return side;
    }
  }
  return Compensation::none;
}

void tell_cutting(const Recording& recording, Draft& draft) {
  Feature& feature = draft.feature;
  if (!has_levels(feature.type)) return;
  const Clearing clearing = clearing_of(recording, draft.first);
  feature.strategy = clearing.strategy;
  feature.stepover = clearing.stepover;
  feature.stepdown = stepdown_of(feature);
  feature.order = order_of(draft.first.loops.loops);
  feature.entry = feature.layers.front().entry;
  feature.compensated = compensation_of(recording, feature.layers.front());
}

void tell_milling(const Recording& recording, Draft& draft) {
  Feature& feature = draft.feature;
  if (!has_levels(feature.type) || feature.type == FeatureType::engraving) return;
  const Layer& layer = feature.layers.front();
  std::vector<const Contour*> outlines;
  std::vector<const Contour*> islands;
  const bool is_outside =
      feature.type == FeatureType::outside_profile || feature.type == FeatureType::boss;
  if (!is_outside) outlines.push_back(&layer.contour);
  if (feature.type != FeatureType::inside_profile) {
    for (const Contour& island : layer.islands) islands.push_back(&island);
  }
  feature.milling = milling_of(recording, outlines, islands);
}

// Of what stands alone the drawing shows its outline.
void choose_nominal(Feature& feature) {
  if (feature.type != FeatureType::outside_profile && feature.type != FeatureType::boss) return;
  for (Layer& layer : feature.layers) {
    if (layer.nominal_islands.empty()) continue;
    layer.nominal = layer.nominal_islands.front();
    layer.nominal_islands.erase(layer.nominal_islands.begin());
  }
}

Cut::Role role_of(const Share& share) {
  if (share.beside_mm >= kAlongWall * share.wall_mm && share.area < share.radius * share.beside_mm)
    return Cut::Role::finish;
  return share.pieces > 1 ? Cut::Role::rest : Cut::Role::rough;
}

void tell_cuts(Draft& draft) {
  for (const Share& share : draft.shares) {
    const bool is_first = &share == &draft.shares.front();
    Cut cut{.operation = share.operation, .visits = share.visits};
    if (draft.shares.size() > 1) cut.role = is_first ? Cut::Role::rough : role_of(share);
    draft.feature.cuts.push_back(std::move(cut));
  }
}

void leave(const Recording& recording, const Span& rows, std::vector<Unrecognised>& rest) {
  Unrecognised left{.why = Unrecognised::Why::budget, .rows = rows};
  left.moves = rows.last - rows.first + 1;
  left.cut_mm = recording.length_of(rows);
  rest.push_back(left);
}

// Nobody has said yet what it is.
void leave(const Recording& recording, Draft& draft, std::vector<Unrecognised>& rest) {
  for (const Layer& layer : draft.feature.layers) {
    for (const Span& span : layer.cuts) leave(recording, span, rest);
    for (const Span& span : layer.entries) leave(recording, span, rest);
  }
  draft.is_gone = true;
}

/// Strokes of one tool at one z that follow each other are one engraving.
bool goes_on(const Draft& last, const Draft& next) {
  const Feature& a = last.feature;
  const Feature& b = next.feature;
  return a.type == FeatureType::engraving && b.type == FeatureType::engraving &&
         last.shares.front().operation == next.shares.front().operation && a.layers.size() == 1 &&
         b.layers.size() == 1 && std::fabs(a.layers.front().z - b.layers.front().z) <= kSameZ_mm;
}

void join_strokes(Draft& last, const Draft& next) {
  Layer& layer = last.feature.layers.front();
  const Layer& more = next.feature.layers.front();
  add_all(last.feature.measures.strokes, next.feature.measures.strokes);
  add_all(last.shares.front().visits, next.shares.front().visits);
  add_all(layer.cuts, more.cuts);
  add_all(layer.entries, more.entries);
  add_all(layer.visits, more.visits);
  add_all(layer.links, more.links);
  add_all(layer.loops, more.loops);
  add_all(layer.removed.loops, more.removed.loops);
  layer.area += more.area;
}

void join_engravings(std::vector<Draft>& drafts) {
  Draft* last = nullptr;
  for (Draft& draft : drafts) {
    if (draft.is_gone) continue;
    if (last != nullptr && goes_on(*last, draft)) {
      join_strokes(*last, draft);
      draft.is_gone = true;
    } else {
      last = &draft;
    }
  }
}

std::string_view kind_word(const Draft& draft) {
  const FeatureType type = draft.feature.type;
  if (!has_levels(type)) return "S";
  return type == FeatureType::engraving || type == FeatureType::groove ? "L" : "R";
}

/// What is cut in the set-ups, and by which operations besides one.
class Surroundings {
 public:
  explicit Surroundings(const std::vector<Draft>& drafts, const std::vector<HoleBook::Entry>& holes)
      : holes_(holes), drafts_(drafts) {
    for (const Draft& draft : drafts) {
      if (has_levels(draft.feature.type))
        boxes_[draft.feature.setup].take(contour::extents(draft.feature.layers.front().contour));
    }
    for (const HoleBook::Entry& hole : holes) boxes_[hole.setup].take(hole.at);
  }

  [[nodiscard]] Box box(std::size_t setup) const {
    const auto found = boxes_.find(setup);
    return found == boxes_.end() ? Box{} : found->second;
  }
  [[nodiscard]] bool has_later(const Draft& draft) const {
    const std::size_t operation = draft.shares.front().operation;
    return std::any_of(
               drafts_.begin(), drafts_.end(),
               [&](const Draft& other) { return other.shares.front().operation > operation; }) ||
           std::any_of(holes_.begin(), holes_.end(), [&](const HoleBook::Entry& hole) {
             return hole.steps.front().operation > operation;
           });
  }

 private:
  std::map<std::size_t, Box> boxes_;
  const std::vector<HoleBook::Entry>& holes_;
  const std::vector<Draft>& drafts_;
};

// Parents are places among all drafts until here.
void put_features(std::vector<Draft>& drafts, const Recording& recording, Tree& tree) {
  std::vector<std::size_t> places(drafts.size());
  Keys keys;
  for (std::size_t i = 0; i < drafts.size(); ++i) {
    places[i] = tree.features.size();
    if (!drafts[i].is_gone) tree.features.push_back(Feature{});
  }
  for (std::size_t i = 0; i < drafts.size(); ++i) {
    if (drafts[i].is_gone) continue;
    Feature& feature = drafts[i].feature;
    if (feature.parent) feature.parent->feature = places[feature.parent->feature];
    const Box box = contour::extents(feature.layers.front().contour);
    feature.key = keys.of(recording.setups[feature.setup].zero, feature.tool, kind_word(drafts[i]),
                          box.is_empty() ? drafts[i].middle : box.middle(), feature.bottom);
    tree.features[places[i]] = std::move(feature);
  }
}

void put_holes(const std::vector<HoleBook::Entry>& entries, const Recording& recording,
               const Workshop& shop, Tree& tree) {
  Keys keys;
  for (const HoleBook::Entry& entry : entries) {
    const Blank& blank = shop.material(entry.setup).blank();
    Hole hole = hole_of(entry, blank.is_known ? std::optional(blank.bottom) : std::nullopt);
    hole.key = keys.of(recording.setups[hole.setup].zero, hole.tool, "H", hole.at, hole.bottom);
    tree.holes.push_back(std::move(hole));
  }
}

}  // namespace

void finish(const Recording& recording, Workshop& shop, Allowance& allowance, Tree& tree) {
  std::vector<Draft> drafts = shop.drafts();
  give_to_holes(shop.holes(), drafts);
  std::erase_if(drafts, [](const Draft& draft) { return draft.is_gone; });
  const std::vector<HoleBook::Entry> holes = shop.holes().done();
  const Surroundings surroundings(drafts, holes);
  for (std::size_t i = 0; i < drafts.size(); ++i) {
    Draft& draft = drafts[i];
    if (allowance.is_over()) {
      leave(recording, draft, shop.unrecognised());
      continue;
    }
    const std::size_t setup = draft.feature.setup;
    tell_heights(draft, shop.material(setup).blank());
    tell_cutting(recording, draft);
    classify({.recording = recording,
              .material = shop.material(setup),
              .drafts = drafts,
              .place = i,
              .all = surroundings.box(setup),
              .is_first_operation = draft.shares.front().operation == 0,
              .has_others_later = surroundings.has_later(draft)},
             draft);
    tell_milling(recording, draft);
    choose_nominal(draft.feature);
  }
  join_engravings(drafts);
  for (Draft& draft : drafts) tell_cuts(draft);
  put_features(drafts, recording, tree);
  put_holes(holes, recording, shop, tree);
  tree.unrecognised = std::move(shop.unrecognised());
}

}  // namespace kerf::features
