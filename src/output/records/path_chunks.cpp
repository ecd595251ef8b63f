#include "output/records/path_chunks.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "math/math.hpp"
#include "motion/feed.hpp"
#include "motion/spindle_speed.hpp"

namespace kerf::output {
namespace {

using base::TipPoint;

static_assert(std::endian::native == std::endian::little, "chunks are little endian");

constexpr std::uint16_t kVersion = 1;
constexpr std::uint16_t kHasRotary = 1U << 8U;
constexpr std::size_t kMostRotary = 2;
// Shorter times than this are noise of the sums, no measure of a speed.
constexpr double kShortest_s = 1e-7;
constexpr double kMostChords = 1e9;

std::uint8_t byte_of(double value) {
  return static_cast<std::uint8_t>(std::clamp(std::round(value), 0.0, 255.0));
}

SegmentKind kind_of(const motion::Motion& motion) {
  if (std::holds_alternative<motion::Rapid>(motion.action)) return SegmentKind::rapid;
  if (std::holds_alternative<motion::Thread>(motion.action)) return SegmentKind::thread;
  if (std::holds_alternative<motion::Probe>(motion.action)) return SegmentKind::probe;
  return SegmentKind::cut;
}

// mm/min or degrees/min; 0 of a rapid, and where it cannot be told.
double programmed_feed(const motion::Motion& motion, double length, double speed_rpm) {
  return std::visit(
      [&](const auto& action) -> double {
        if constexpr (requires { action.lead; }) {
          return action.lead * speed_rpm;
        } else if constexpr (requires { action.feed; }) {
          return motion::feed_per_minute(action.feed, length, speed_rpm);
        } else {
          return 0;
        }
      },
      motion.action);
}

template <typename T>
void append_bytes(std::string& bytes, T value) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), &value, sizeof(T));
  bytes.append(raw.data(), raw.size());
}

// Every array starts at a multiple of four bytes.
template <typename T>
void append_array(std::string& bytes, const std::vector<T>& values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  bytes.resize((bytes.size() + 3) / 4 * 4);
}

}  // namespace

void PathChunks::Arrays::clear() {
  xyz.clear();
  time_s.clear();
  feed_mm_min.clear();
  speed_mm_min.clear();
  rotary.clear();
  motion.clear();
  line.clear();
  file.clear();
  kind.clear();
  tool.clear();
  power_percent.clear();
}

PathChunks::PathChunks(const machine::MachineDefinition& machine, Source source, std::uint32_t run,
                       Emit emit)
    : axes_(machine.axes),
      norms_{motion::linear_axes(axes_), axes_.count()},
      space_(axes_),
      source_(source),
      run_(run),
      emit_(std::move(emit)),
      curves_(axes_),
      commanded_(axes_.start),
      spindles_(axes_.standing_rpm),
      reached_(axes_.start),
      last_(axes_.start) {
  for (std::size_t m = 0; m < axes_.count() && rotary_axes_.size() < kMostRotary; ++m)
    if (axes_.axes[m].rotary) rotary_axes_.push_back(m);
}

// Turning counts as well: a move of rotary axes alone has a way.
double PathChunks::distance(const TipPoint& from, const TipPoint& to) const {
  const base::AxisVector way = to - from;
  return math::hypot(norms_.mm(way), norms_.degrees(way));
}

// The motions

void PathChunks::take(const motion::Motion& motion) {
  ++motions_;
  if (const TipPoint* const to = motion::target_of(motion)) {
    add_move(motion, *to);
  } else if (const auto* const dwell = std::get_if<motion::Dwell>(&motion.action)) {
    add_dwell(motion, dwell->seconds);
  } else if (const auto* const power = std::get_if<motion::Power>(&motion.action)) {
    power_percent_ = power->beam_percent();
  } else if (const auto* const change = std::get_if<motion::ToolChange>(&motion.action)) {
    tool_ = change->tool;
  } else if (const auto* const spindle = std::get_if<motion::Spindle>(&motion.action)) {
    spindles_.take(*spindle);
  }
}

PathChunks::Attributes PathChunks::attributes_of(const motion::Motion& motion,
                                                 SegmentKind kind) const {
  Attributes attributes;
  attributes.number = motions_;
  attributes.line = motion.block.line;
  attributes.file = static_cast<std::uint16_t>(motion.block.file);
  attributes.kind = kind;
  attributes.tool = byte_of(tool_);
  attributes.power_percent = byte_of(power_percent_);
  return attributes;
}

void PathChunks::add_move(const motion::Motion& motion, const TipPoint& to) {
  const auto curves = curves_.of(commanded_, motion);
  commanded_ = to;
  if (curves.empty()) return;
  Move& move = moves_.emplace_back(Move{attributes_of(motion, kind_of(motion)), to});
  double length = 0;
  for (const motion::Curve& curve : curves) length += curve.length();
  move.attributes.feed_mm_min =
      static_cast<float>(programmed_feed(motion, length, motion::rpm_at(spindles_.of_feed(), to)));
  if (curves.size() == 1 && curves.front().is_line()) return;
  for (const motion::Curve& curve : curves) move.curves.push_back({curve, chords_of(curve)});
}

// A chord leaves a curve by at most the eighth of its curvature times the square of its length.
std::uint32_t PathChunks::chords_of(const motion::Curve& curve) const {
  const auto bounds = curve.bounds(0, curve.length());
  const double bend = curve.curvature_bound(0, curve.length(), bounds, norms_.linear);
  const double chords = std::ceil(curve.length() * std::sqrt(bend / (8 * kChordError_mm)));
  return static_cast<std::uint32_t>(std::clamp(chords, 1.0, kMostChords));
}

void PathChunks::add_dwell(const motion::Motion& motion, double seconds) {
  if (seconds > 0) moves_.push_back(Move{attributes_of(motion, SegmentKind::dwell), commanded_});
}

// The set-points

void PathChunks::start(const motion::AxisPoint& at) {
  reached_ = last_ = at.tip.tip;
  reached_s_ = last_s_ = at.tip.time_s;
  way_ = 0;
  drawn_ = space_.point_of(last_, drawn_);
}

void PathChunks::take(const motion::AxisPoint& point) {
  pass_motions_before(point.tip.mark.motion, point.tip.time_s);
  pass_vertices_of_current(point);
  place_passed(point.tip.tip, point.tip.time_s);
  reached_ = point.tip.tip;
  reached_s_ = point.tip.time_s;
}

// False: the next one is the end of the move, which is passed with the move itself.
bool PathChunks::next_vertex_of_front(TipPoint& at) const {
  const Move& move = moves_.front();
  if (curve_ >= move.curves.size()) return false;
  const auto& [curve, count] = move.curves[curve_];
  const bool last_of_curve = chord_ + 1 >= count;
  if (last_of_curve && curve_ + 1 == move.curves.size()) return false;
  at = last_of_curve ? curve.end() : curve.at(curve.length() * (chord_ + 1) / count);
  return true;
}

void PathChunks::advance_front() {
  if (++chord_ < moves_.front().curves[curve_].count) return;
  chord_ = 0;
  ++curve_;
}

// However many vertices lie between two set-points, memory stays bounded: the first of them share
// half of the time.
void PathChunks::pass(const TipPoint& at, double time_s) {
  const TipPoint& before = passed_.empty() ? reached_ : passed_.back().at;
  const double way = passed_.empty() ? 0 : passed_.back().way;
  passed_.push_back({at, way + distance(before, at), moves_.front().attributes});
  if (passed_.size() < kMostVertices) return;
  const double half_s = (reached_s_ + time_s) / 2;
  place_passed(at, half_s);
  reached_ = at;
  reached_s_ = half_s;
}

void PathChunks::pass_motions_before(std::uint64_t number, double time_s) {
  while (!moves_.empty() && moves_.front().attributes.number < number) {
    TipPoint at;
    for (; next_vertex_of_front(at); advance_front()) pass(at, time_s);
    pass(moves_.front().end, time_s);
    moves_.pop_front();
    curve_ = chord_ = 0;
  }
}

// Of the move under way those vertices are passed that are nearer along the path than the tool.
void PathChunks::pass_vertices_of_current(const motion::AxisPoint& point) {
  way_ = passed_.empty() ? way_ + distance(reached_, point.tip.tip)
                         : distance(passed_.back().at, point.tip.tip);
  if (moves_.empty() || moves_.front().attributes.number != point.tip.mark.motion) return;
  TipPoint at;
  while (next_vertex_of_front(at)) {
    const double segment = distance(passed_.empty() ? last_ : passed_.back().at, at);
    if (segment > way_) return;
    way_ -= segment;
    pass(at, point.tip.time_s);
    advance_front();
  }
}

void PathChunks::place_passed(const TipPoint& at, double time_s) {
  if (passed_.empty()) return;
  const double whole = passed_.back().way + distance(passed_.back().at, at);
  const double lasted = time_s - reached_s_;
  for (const Passed& passed : passed_) {
    const double share = whole > 0 ? passed.way / whole : 0;
    add_vertex(passed.at, reached_s_ + lasted * share, passed.attributes);
  }
  passed_.clear();
}

// The vertices

void PathChunks::add_vertex(const TipPoint& at, double time_s, const Attributes& attributes) {
  if (arrays_.count() == 0) begin_chunk();
  const base::AxisVector way = at - last_;
  const double linear = norms_.mm(way);
  const double length = linear > 0 ? linear : norms_.degrees(way);
  const double lasted = time_s - last_s_;
  if (length == 0) {
    last_speed_ = 0;
  } else if (lasted > kShortest_s) {
    last_speed_ = length / lasted * motion::kSecondsPerMinute;
  }
  append(at, time_s, last_speed_, attributes);
  last_ = at;
  last_s_ = time_s;
  last_attributes_ = attributes;
  if (arrays_.count() == kMostVertices) flush();
}

void PathChunks::begin_chunk() {
  time_base_s_ = last_s_;
  append(last_, last_s_, last_speed_, last_attributes_);
  if (vertices_ == 0) vertices_ = 1;
}

void PathChunks::append(const TipPoint& at, double time_s, double speed_mm_min,
                        const Attributes& attributes) {
  drawn_ = space_.point_of(at, drawn_);
  bounds_.add(drawn_);
  for (const double coordinate : drawn_) arrays_.xyz.push_back(static_cast<float>(coordinate));
  arrays_.time_s.push_back(static_cast<float>(time_s - time_base_s_));
  arrays_.feed_mm_min.push_back(attributes.feed_mm_min);
  arrays_.speed_mm_min.push_back(static_cast<float>(speed_mm_min));
  arrays_.motion.push_back(static_cast<std::uint32_t>(attributes.number));
  arrays_.line.push_back(attributes.line);
  arrays_.file.push_back(attributes.file);
  arrays_.kind.push_back(static_cast<std::uint8_t>(attributes.kind));
  arrays_.tool.push_back(attributes.tool);
  arrays_.power_percent.push_back(attributes.power_percent);
  if (rotary_axes_.empty()) return;
  for (std::size_t i = 0; i < kMostRotary; ++i) {
    const bool fitted = i < rotary_axes_.size();
    arrays_.rotary.push_back(fitted ? static_cast<float>(at.values[rotary_axes_[i]]) : 0);
  }
}

std::string PathChunks::header() const {
  std::string bytes = "KPTH";
  const bool rotary = !rotary_axes_.empty();
  append_bytes(bytes, static_cast<std::uint16_t>(kVersion | (rotary ? kHasRotary : 0)));
  append_bytes(bytes, static_cast<std::uint16_t>(source_));
  append_bytes(bytes, run_);
  append_bytes(bytes, chunk_);
  append_bytes(bytes, arrays_.motion[1]);
  append_bytes(bytes, static_cast<std::uint32_t>(arrays_.count()));
  append_bytes(bytes, time_base_s_);
  return bytes;
}

void PathChunks::flush() {
  if (arrays_.count() < 2) return;
  std::string bytes = header();
  append_array(bytes, arrays_.xyz);
  append_array(bytes, arrays_.time_s);
  append_array(bytes, arrays_.feed_mm_min);
  append_array(bytes, arrays_.speed_mm_min);
  append_array(bytes, arrays_.motion);
  append_array(bytes, arrays_.line);
  append_array(bytes, arrays_.file);
  append_array(bytes, arrays_.kind);
  append_array(bytes, arrays_.tool);
  append_array(bytes, arrays_.power_percent);
  append_array(bytes, arrays_.rotary);
  vertices_ += arrays_.count() - 1;
  ++chunk_;
  arrays_.clear();
  emit_(std::move(bytes));
}

void PathChunks::finish() {
  pass_motions_before(motions_ + 1, reached_s_);
  place_passed(reached_, reached_s_);
  flush();
}

void PathChunks::abandon() {
  moves_.clear();
  curve_ = chord_ = 0;
  flush();
}

PathTotals PathChunks::totals() const {
  PathTotals totals;
  totals.motions = motions_;
  totals.vertices = vertices_ + (arrays_.count() > 0 ? arrays_.count() - 1 : 0);
  totals.time_s = last_s_;
  if (!bounds_.empty()) {
    totals.low = bounds_.low();
    totals.high = bounds_.high();
  }
  return totals;
}

}  // namespace kerf::output
