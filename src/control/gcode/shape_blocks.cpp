#include "control/gcode/shape_blocks.hpp"

#include <string>

namespace kerf::control {
namespace {

using base::Code;

bool missing(State& state, const vm::Span& at, std::uint32_t number, const char* where) {
  return state.alarms.raise(Code::shape_not_found, at,
                            "there is no N" + std::to_string(number) + where);
}

}  // namespace

// CTL-2: forward from the cycle, then from the head of the program; the last one behind the first.
std::optional<vm::Address> ShapeBlocks::find_last(const ShapeCycles::Request& request) const {
  const vm::CodeId code = interpreter_.running_code();
  const auto first = library_.find_label(code, interpreter_.running(), request.first);
  if (!first) {
    missing(state_, request.first_text, request.first, " in this program");
    return std::nullopt;
  }
  const auto last = library_.find_label(code, *first, request.last);
  if (last && *first < *last && request.first != request.last) return last;
  missing(state_, request.last_text, request.last, " behind the first block of the shape");
  return std::nullopt;
}

// The search may drop the page on which the words of the cycle stand.
bool ShapeBlocks::go(ReadBlock& cycle, std::span<const gcode::Word> words) {
  words_.assign(words.begin(), words.end());
  if (!blocks_.collect(words_, cycle)) return false;
  const ShapeCycles::Request request = *acts_.shapes().request();
  const auto end = find_last(request);
  if (!end) return false;
  vm::Address behind = interpreter_.running();
  ++behind.instruction;
  Stretch stretch{.last = request.last,
                  .code = interpreter_.running_code(),
                  .end = *end,
                  .depth = interpreter_.depth(),
                  .behind = behind,
                  .home = state_.coordinates.path(),
                  .block = state_.path.block(),
                  .number = cycle.number,
                  .line = state_.line,
                  .words = words_,
                  .codes = acts_.codes()};
  if (request.finishes()) {
    acts_.shapes().drop_request();
    acts_.finish(cycle.words);
    if (!state_.path.end_block()) return false;
    buffer_.release();
  } else {
    const auto axes = motion::plane_axes(motion::Plane::zx, state_.axes);
    buffer_.release();
    if (!reader_.begin(*axes)) return false;
  }
  stretch_ = std::move(stretch);
  return interpreter_.jump_to_label(request.first);
}

bool ShapeBlocks::is_behind(std::uint32_t sequence) const {
  return active() && interpreter_.running_code() == stretch_->code &&
         interpreter_.depth() == stretch_->depth && stretch_->end < interpreter_.running() &&
         sequence != stretch_->last;
}

bool ShapeBlocks::admits(const Words& words) const {
  return !active() || admits_in_shape(state_, acts_.targets(), words);
}

bool ShapeBlocks::finish_reading(ReadBlock& block) {
  vm::Address next = interpreter_.running();
  if (is_last(block)) ++next.instruction;
  const Stretch stretch = std::move(*stretch_);
  stretch_.reset();
  if (!reader_.end()) return false;
  interpreter_.jump(stretch.end < stretch.behind ? stretch.behind : next);
  words_ = stretch.words;
  state_.line = stretch.line;
  state_.path.begin_block(stretch.block);
  block.number = stretch.number;
  if (!blocks_.collect(words_, block)) return false;
  acts_.take_up(stretch.codes);
  const bool good = acts_.shapes().begin(reader_.shape(), reader_.take_blocks());
  acts_.shapes().drop_request();
  return good;
}

// Both axes at once, without compensation.
bool ShapeBlocks::finish_making() {
  const Stretch stretch = std::move(*stretch_);
  stretch_.reset();
  if (!ends_complete(state_)) return false;
  if (!state_.path.straight(state_.rapid(on_path(stretch.home)))) return false;
  state_.coordinates.arrive_at(stretch.home);
  buffer_.release();
  interpreter_.jump(stretch.behind);
  return true;
}

bool ShapeBlocks::miss_last() {
  return state_.alarms.raise(Code::shape_not_found,
                             "the program does not come to N" + std::to_string(stretch_->last));
}

void ShapeBlocks::drop() {
  acts_.shapes().drop_request();
  reader_.drop();
  stretch_.reset();
}

}  // namespace kerf::control
