#include "features/turning/lathe_work.hpp"

#include <algorithm>
#include <cmath>

#include "features/path/tolerance.hpp"
#include "features/path/united.hpp"
#include "features/tree/key.hpp"
#include "features/tree/words.hpp"
#include "features/turning/turned_thread.hpp"
#include "geometry/contour/boolean.hpp"
#include "stock/turned/revolved.hpp"

namespace kerf::features {
namespace {

using contour::Region;
using stock::ToolKind;

constexpr double kBeyondBars_mm = 1e4;
constexpr std::size_t kPartEdges = 256;

bool is_plain_groove(FeatureType type) {
  return type == FeatureType::groove || type == FeatureType::face_groove;
}

/// What a tool on the axis takes: a cylinder from its tip to the front.
Region bored(double radius, double bottom, std::uint32_t row) {
  return {{{{{{bottom, 0}, 0, row},
             {{kBeyondBars_mm, 0}, 0, row},
             {{kBeyondBars_mm, radius}, 0, row},
             {{bottom, radius}, 0, row}},
            true}}};
}

contour::Box path_box(const Recording& recording, Span rows) {
  contour::Box box;
  for (const contour::Edge& edge : edges_of(recording, rows)) box.take(contour::extents(edge));
  if (box.is_empty()) box.take(recording.flat_to(rows.last));
  return box;
}

double feed_length(const Recording& recording, Span rows) { return recording.length_of(rows); }

}  // namespace

LatheWork::LatheWork(const Recording& recording, const Blank& blank, Allowance& allowance)
    : recording_(recording), allowance_(allowance) {
  for (const SetUp& setup : recording.setups) materials_.emplace_back(blank, setup);
}

const stock::Tool& LatheWork::tool_of(std::uint32_t number) const {
  return recording_.tools.at(number);
}

HalfSection& LatheWork::material_of(const Chain& chain) {
  return materials_[recording_.state_of(recording_.moves[chain.rows.first]).setup];
}

void LatheWork::follow(std::size_t number, const Operation& operation) {
  air_mm_.resize(number + 1);
  for (const Chain& chain : chains_of(recording_, operation, tool_of(operation.tool)))
    take(number, operation, chain);
}

void LatheWork::take(std::size_t number, const Operation& operation, const Chain& chain) {
  if (allowance_.is_over()) return leave(chain);
  const stock::Tool& tool = tool_of(operation.tool);
  switch (chain.kind) {
    case Chain::Kind::other: return leave(chain);
    case Chain::Kind::axial: return take_axial(number, chain, tool);
    case Chain::Kind::thread: return take_thread(placed(number, chain, tool), tool);
    case Chain::Kind::along:
    case Chain::Kind::across:
    case Chain::Kind::groove: return take_cut(placed(number, chain, tool), tool);
  }
}

void LatheWork::leave(const Chain& chain) {
  Unrecognised rest{.rows = chain.rows, .moves = chain.rows.last - chain.rows.first + 1};
  rest.cut_mm = feed_length(recording_, chain.rows);
  const Move& first = recording_.moves[chain.rows.first];
  const SetUp& setup = recording_.setups[recording_.state_of(first).setup];
  if (allowance_.is_over()) {
    rest.why = Unrecognised::Why::budget;
  } else if (first.kind == Move::Kind::probe) {
    rest.why = Unrecognised::Why::probing;
  } else if (setup.is_turned() || first.shape == Move::Shape::other) {
    rest.why = Unrecognised::Why::rotary;
  }
  unrecognised_.push_back(rest);
}

// A boring bar, a tip that points away from the axis, or, of a tool whose tip nobody has said, a
// way that begins in the bore.
bool LatheWork::is_inside(const Chain& chain, const stock::Tool& tool,
                          const HalfSection& material) const {
  if (tool.kind == ToolKind::boring_bar) return true;
  if (const auto tip = tool.said(stock::Measure::tip)) return *tip == 1 || *tip == 2 || *tip == 6;
  const contour::Box box = path_box(recording_, chain.rows);
  const auto radii = material.radii_between(box.low.u, box.high.u);
  return radii && radii->least > kSamePoint_mm &&
         recording_.from(chain.rows.first).x < radii->least + kSamePoint_mm;
}

TurnedChain LatheWork::placed(std::size_t number, const Chain& chain, const stock::Tool& tool) {
  HalfSection& material = material_of(chain);
  TurnedChain its{.chain = chain, .operation = number};
  const bool inside = is_inside(chain, tool, material);
  its.beyond = inside ? Beyond::inside : Beyond::outside;
  if (chain.kind == Chain::Kind::across || tool.kind == ToolKind::face_grooving)
    its.beyond = Beyond::front;
  if (chain.kind == Chain::Kind::groove) its.width = tip_width(tool);
  if (chain.kind == Chain::Kind::along) its.nose = nose_of(tool);
  its.path = path_box(recording_, chain.rows);
  if (inside) material.assume_bore(recording_.moves[chain.visit.first].to.x);
  return its;
}

void LatheWork::take_thread(TurnedChain chain, const stock::Tool&) {
  TurnedDraft* const last = drafts_.empty() ? nullptr : &drafts_.back();
  if (last != nullptr && last->feature.type == FeatureType::thread &&
      is_same_thread(recording_, *last, chain)) {
    last->chains.push_back(std::move(chain));
    return;
  }
  begin(FeatureType::thread, chain).chains.push_back(std::move(chain));
}

FeatureType LatheWork::type_of(const TurnedChain& chain, const stock::Tool& tool) const {
  if (chain.chain.kind == Chain::Kind::groove) {
    if (chain.beyond == Beyond::front) return FeatureType::face_groove;
    const bool reaches_axis = chain.beyond == Beyond::outside && chain.path.low.v <= kSamePoint_mm;
    return reaches_axis ? FeatureType::parting : FeatureType::groove;
  }
  if (chain.beyond != Beyond::front)
    return chain.beyond == Beyond::inside ? FeatureType::boring : FeatureType::turning;
  // Facing leaves nothing before it.
  const std::uint32_t setup = recording_.state_of(recording_.moves[chain.chain.rows.first]).setup;
  // A bar that nobody has described may be wider than the cut begins.
  const bool is_known = materials_[setup].is_known();
  const auto front =
      materials_[setup].front_within(is_known ? kBeyondBars_mm : chain.path.high.v - kSamePoint_mm);
  const bool is_clear = !front || *front <= chain.path.low.u + kSamePoint_mm;
  if (is_clear) return FeatureType::facing;
  return tool.kind == ToolKind::boring_bar ? FeatureType::boring : FeatureType::turning;
}

// The last one of the type that it meets; facing goes on wherever it is.
TurnedDraft* LatheWork::draft_for(FeatureType type, const TurnedChain& chain) {
  for (auto draft = drafts_.rbegin(); draft != drafts_.rend(); ++draft) {
    const bool is_same_operation = draft->chains.back().operation == chain.operation;
    if (draft->feature.type == type && draft->meets(chain)) return &*draft;
    if (is_plain_groove(type) && !is_same_operation) return nullptr;
  }
  return nullptr;
}

// Of a long chain part by part, so that what wanders costs no more than its border.
std::optional<Region> LatheWork::swept_by(const TurnedChain& chain) {
  const std::vector<contour::Edge> path = edges_of(recording_, chain.chain.rows);
  std::vector<Region> parts;
  for (std::size_t begin = 0; begin < path.size(); begin += kPartEdges) {
    if (allowance_.is_over()) return std::nullopt;
    const auto at = [&](std::size_t i) { return path.begin() + static_cast<std::ptrdiff_t>(i); };
    const std::vector<contour::Edge> part(at(begin), at(std::min(path.size(), begin + kPartEdges)));
    parts.push_back(chain.nose.radius > 0 ? reached_by_nose(part, chain.beyond, chain.nose)
                                          : reached(part, chain.beyond, chain.width));
  }
  return united(std::move(parts), allowance_);
}

void LatheWork::take_cut(TurnedChain chain, const stock::Tool& tool) {
  const auto swept = swept_by(chain);
  if (!swept) return leave(chain.chain);
  chain.removed = material_of(chain.chain).take(*swept);
  allowance_.keep(contour::vertex_count(chain.removed) * sizeof(contour::Vertex) + sizeof(chain));
  if (chain.removed.is_empty())
    air_mm_[chain.operation] += feed_length(recording_, chain.chain.rows);
  const FeatureType type = type_of(chain, tool);
  TurnedDraft* draft = draft_for(type, chain);
  if (draft == nullptr) draft = &begin(type, chain);
  draft->add(std::move(chain));
}

TurnedDraft& LatheWork::begin(FeatureType type, const TurnedChain& chain) {
  const State& state = recording_.state_of(recording_.moves[chain.chain.rows.first]);
  TurnedDraft draft;
  draft.feature.type = type;
  draft.feature.setup = state.setup;
  draft.feature.tool = state.tool;
  drafts_.push_back(std::move(draft));
  return drafts_.back();
}

// What is done on the axis is one hole, as on a mill.
void LatheWork::take_axial(std::size_t number, const Chain& chain, const stock::Tool& tool) {
  HalfSection& material = material_of(chain);
  const State& state = recording_.state_of(recording_.moves[chain.rows.first]);
  HoleStep step{.how = drilling_of(tool, state.cycle), .tool = state.tool, .operation = number};
  step.cycle = state.cycle;
  if (tool.is_insert()) step.how = HoleStep::How::bore;
  step.diameter = tool.is_insert() ? 0 : tool.value(stock::Measure::diameter).value_or(0);
  const contour::Box box = path_box(recording_, chain.rows);
  step.bottom = box.low.u;
  step.top = std::max(material.front_within(step.diameter / 2).value_or(box.high.u), step.bottom);
  step.rows = {chain.rows};
  step.visits = {chain.visit};
  if (step.how == HoleStep::How::tap) step.thread_pitch = tap_pitch(tool, state);
  TurnedChain its{.chain = chain, .operation = number, .path = box};
  if (step.how != HoleStep::How::tap && step.diameter > 0)
    its.removed = material.take(bored(step.diameter / 2, step.bottom, chain.rows.first));
  const auto drilled = std::find_if(drafts_.rbegin(), drafts_.rend(), [&](const auto& draft) {
    return draft.feature.type == FeatureType::drilling && draft.feature.setup == state.setup;
  });
  TurnedDraft& draft = drilled != drafts_.rend() ? *drilled : begin(FeatureType::drilling, its);
  draft.add(std::move(its));
  if (!draft.feature.turned) draft.feature.turned.emplace();
  add_step(draft.feature.turned->steps, std::move(step));
}

// A groove or thread hangs on what it lies on.
void LatheWork::tell_parents(Tree& tree) const {
  for (std::size_t i = 0; i < tree.features.size(); ++i) {
    Feature& feature = tree.features[i];
    const bool hangs = is_plain_groove(feature.type) || feature.type == FeatureType::thread;
    if (!hangs) continue;
    for (std::size_t k = i; k-- > 0;) {
      const Feature& other = tree.features[k];
      const bool turns = other.type == FeatureType::turning || other.type == FeatureType::boring;
      const double middle = (feature.top + feature.bottom) / 2;
      if (!turns || other.setup != feature.setup || other.turned->outer != feature.turned->outer)
        continue;
      if (middle > other.top + kSamePoint_mm || middle < other.bottom - kSamePoint_mm) continue;
      feature.parent = Relation{k, RelationKind::nested};
      break;
    }
  }
}

void LatheWork::finish(Tree& tree) {
  Keys keys;
  for (TurnedDraft& draft : drafts_) {
    Feature& feature = draft.feature;
    if (feature.type == FeatureType::thread) {
      finish_thread(recording_, materials_[feature.setup], tool_of(feature.tool), draft);
    } else {
      features::finish(recording_, draft);
    }
    const auto& contour = feature.turned->contour;
    const Vec2 at = contour.vertices.empty() ? Vec2{feature.top, 0}
                                             : Vec2{contour.vertices.front().point.u,
                                                    2 * contour.vertices.front().point.v};
    feature.key = keys.of(recording_.setups[feature.setup].zero, feature.tool,
                          word_of(feature.type), at, feature.bottom);
    tree.features.push_back(std::move(feature));
  }
  tell_parents(tree);
  tree.unrecognised = std::move(unrecognised_);
  for (std::size_t i = 0; i < tree.operations.size(); ++i) tree.operations[i].air_mm = air_mm_[i];
}

}  // namespace kerf::features
