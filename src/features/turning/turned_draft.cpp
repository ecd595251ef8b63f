#include "features/turning/turned_draft.hpp"

#include <algorithm>
#include <cmath>

#include "features/path/tolerance.hpp"
#include "features/turning/shape.hpp"
#include "geometry/contour/boolean.hpp"
#include "stock/turned/revolved.hpp"

namespace kerf::features {
namespace {

using contour::Box;
using contour::Region;

constexpr double kWholeLength = 0.99;  // of the feature, along which a finishing chain runs
constexpr std::size_t kLeastRoughing = 2;

Box box_of(const Region& region, const Box& otherwise) {
  const Box box = contour::extents(region);
  return box.is_empty() ? otherwise : box;
}

/// The row that cuts the most of a chain, which names its pass.
std::uint32_t longest_row(const Recording& recording, Span rows) {
  std::uint32_t longest = rows.first;
  for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
    if (recording.length_of(row) > recording.length_of(longest)) longest = row;
  }
  return longest;
}

TurnedPass pass_of(const Recording& recording, const TurnedChain& chain) {
  const std::uint32_t row = longest_row(recording, chain.chain.rows);
  const Vec2 from = recording.flat_from(row);
  const Vec2 to = recording.flat_to(row);
  TurnedPass pass{.rows = chain.chain.rows};
  pass.along_z = std::fabs(to.u - from.u) >= std::fabs(to.v - from.v);
  pass.at = pass.along_z ? 2 * to.v : to.u;
  return pass;
}

bool has_profile(const Recording& recording, Span rows) {
  std::size_t slopes = 0;
  std::size_t cylinders = 0;
  for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
    const Vec2 way = recording.flat_to(row) - recording.flat_from(row);
    const bool is_slope = recording.moves[row].shape == Move::Shape::arc ||
                          (std::fabs(way.u) > kSamePoint_mm && std::fabs(way.v) > kSamePoint_mm);
    slopes += static_cast<std::size_t>(is_slope);
    cylinders +=
        static_cast<std::size_t>(std::fabs(way.v) <= kSamePoint_mm && std::fabs(way.u) > 0);
  }
  return slopes > 0 || cylinders > 1;
}

/// The first chain of the finishing cut; as many as there are: there is none. It is another
/// operation's, or the last one, along the whole contour, behind passes.
std::size_t finish_from(const Recording& recording, const TurnedDraft& draft) {
  const auto& chains = draft.chains;
  for (std::size_t i = 1; i < chains.size(); ++i) {
    if (chains[i].operation != chains.front().operation) return i;
  }
  if (chains.size() <= kLeastRoughing) return chains.size();
  const TurnedChain& last = chains.back();
  const Box whole = contour::extents(draft.removed);
  const double covered =
      std::min(last.path.high.u, whole.high.u) - std::max(last.path.low.u, whole.low.u);
  const bool is_along = covered >= kWholeLength * (whole.high.u - whole.low.u);
  return is_along && has_profile(recording, last.chain.rows) ? chains.size() - 1 : chains.size();
}

void tell_cuts(const Recording& recording, TurnedDraft& draft) {
  Feature& feature = draft.feature;
  const bool may_finish =
      feature.type == FeatureType::turning || feature.type == FeatureType::boring;
  const std::size_t finish = may_finish ? finish_from(recording, draft) : draft.chains.size();
  for (std::size_t i = 0; i < draft.chains.size(); ++i) {
    const TurnedChain& chain = draft.chains[i];
    const bool begins =
        feature.cuts.empty() || i == finish || feature.cuts.back().operation != chain.operation;
    if (begins) {
      feature.cuts.push_back({.operation = chain.operation,
                              .role = i >= finish ? Cut::Role::finish : Cut::Role::rough});
    }
    feature.cuts.back().visits.push_back(chain.chain.visit);
  }
  if (feature.cuts.size() == 1) feature.cuts.front().role = Cut::Role::only;
}

bool is_own_row(const TurnedDraft& draft, std::uint32_t row) {
  return std::any_of(draft.chains.begin(), draft.chains.end(), [&](const TurnedChain& chain) {
    return row >= chain.chain.rows.first && row <= chain.chain.rows.last;
  });
}

Compensation compensation_along(const Recording& recording, Span rows) {
  for (std::uint32_t row = rows.first; row <= rows.last; ++row) {
    const Compensation side = recording.state_of(recording.moves[row]).compensation;
    if (side != Compensation::none) return side;
  }
  return Compensation::none;
}

// Along the axes a nose cuts where its tip is led; on slopes and arcs it does not.
void tell_nose(const Recording& recording, TurnedDraft& draft, const TurnedPart& part) {
  const TurnedChain& last = draft.chains.back();
  draft.feature.compensated = compensation_along(recording, last.chain.rows);
  if (last.nose.radius <= 0 || draft.feature.compensated != Compensation::none) return;
  const bool slopes = std::any_of(part.elements.begin(), part.elements.end(), [](const auto& one) {
    return one.kind != TurnedElement::Kind::cylinder && one.kind != TurnedElement::Kind::shoulder;
  });
  if (slopes) draft.feature.reasons.push_back(Reason::nose_not_compensated);
}

void tell_shape(const Recording& recording, TurnedDraft& draft, TurnedPart& part) {
  const Vec2 begin = recording.flat_from(draft.chains.back().chain.rows.first);
  part.contour = left_contour(
      draft.removed, [&](std::uint32_t row) { return is_own_row(draft, row); }, begin);
  part.contour = without_nose(part.contour, draft.chains.back().nose.radius);
  part.elements = elements_of(part.contour);
  tell_nose(recording, draft, part);
  for (const TurnedChain& chain : draft.chains) part.passes.push_back(pass_of(recording, chain));
}

// What the tool's edge has passed, also where there was nothing.
void tell_groove(const TurnedDraft& draft, TurnedPart& part) {
  Box box;
  for (const TurnedChain& chain : draft.chains) box.take(chain.path);
  const TipWidth width = draft.chains.front().width;
  const double tool = width.high - width.low;
  switch (draft.chains.front().beyond) {
    case Beyond::front:
      part.width = box.high.v - box.low.v + tool;
      part.bottom = box.low.u;
      break;
    case Beyond::outside:
      part.width = box.high.u - box.low.u + tool;
      part.bottom = 2 * box.low.v;
      break;
    case Beyond::inside:
      part.width = box.high.u - box.low.u + tool;
      part.bottom = 2 * box.high.v;
      break;
  }
}

void tell_bore(TurnedPart& part) {
  part.outer = false;
  part.passes.clear();
  double widest = 0;
  for (const HoleStep& step : part.steps) {
    if (step.how != HoleStep::How::tap && step.how != HoleStep::How::spot)
      widest = std::max(widest, step.diameter);
  }
  part.diameter = widest > 0 ? widest : part.steps.front().diameter;
}

bool is_groove(FeatureType type) {
  return type == FeatureType::groove || type == FeatureType::face_groove ||
         type == FeatureType::parting;
}

}  // namespace

bool TurnedDraft::meets(const TurnedChain& more) const {
  const Box mine = box_of(removed, chains.back().path);
  const Box its = box_of(more.removed, more.path);
  if (!mine.grown(kSamePoint_mm).meets(its)) return false;
  if (removed.is_empty() || more.removed.is_empty()) return true;
  const double apart = contour::length(removed) + contour::length(more.removed);
  return apart - contour::length(contour::unite(removed, more.removed)) > 2 * kSamePoint_mm;
}

void TurnedDraft::add(TurnedChain more) {
  if (!more.removed.is_empty()) removed = contour::unite(removed, more.removed);
  chains.push_back(std::move(more));
}

void finish(const Recording& recording, TurnedDraft& draft) {
  Feature& feature = draft.feature;
  if (!feature.turned) feature.turned.emplace();
  TurnedPart& part = *feature.turned;
  Box box = contour::extents(draft.removed);
  for (const TurnedChain& chain : draft.chains) {
    if (draft.removed.is_empty()) box.take(chain.path);
  }
  part.outer = draft.chains.front().beyond != Beyond::inside;
  feature.top = box.high.u;
  feature.bottom = box.low.u;
  feature.turned_volume = stock::turned::volume(draft.removed);
  tell_shape(recording, draft, part);
  if (is_groove(feature.type)) tell_groove(draft, part);
  if (feature.type == FeatureType::drilling) tell_bore(part);
  if (feature.type == FeatureType::facing) part.x = 2 * draft.chains.back().path.low.v;
  tell_cuts(recording, draft);
  part.removed = std::move(draft.removed);
}

}  // namespace kerf::features
