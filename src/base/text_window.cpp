#include "base/text_window.hpp"

#include <algorithm>
#include <cstring>

namespace kerf::base {
namespace {

constexpr std::size_t kChunkBytes = 1 << 15;

std::size_t find(std::string_view text, char wanted, std::size_t from) {
  const void* const found = std::memchr(text.data() + from, wanted, text.size() - from);
  if (found == nullptr) return std::string_view::npos;
  return static_cast<std::size_t>(static_cast<const char*>(found) - text.data());
}

}  // namespace

void TextWindow::stand_at(const SourceFile& file, FileId id, std::uint64_t begin,
                          std::uint64_t end) {
  const bool goes_on = id == id_ && end == end_ && begin >= at_ && begin <= at_ + size_;
  file_ = &file;
  id_ = id;
  end_ = end;
  if (goes_on) {
    position_ = static_cast<std::size_t>(begin - at_);
    return;
  }
  at_ = begin;
  size_ = position_ = 0;
  before_ = 0;
  if (begin > 0 && file.read(begin - 1, {&before_, 1}) == 0) before_ = 0;
  has_returns_ = has_semicolons_ = false;
}

// The text before the next line is not needed any more.
void TextWindow::drop_past() {
  if (position_ == 0) return;
  before_ = buffer_[position_ - 1];
  std::memmove(buffer_.get(), buffer_.get() + position_, size_ - position_);
  at_ += position_;
  size_ -= position_;
  position_ = 0;
  has_returns_ = find(view(), '\r', 0) != std::string_view::npos;
  has_semicolons_ = find(view(), ';', 0) != std::string_view::npos;
}

// Reads more text behind what is there. False at the end of the stretch.
bool TextWindow::fill() {
  if (at_ + size_ >= end_) return false;
  drop_past();
  const std::size_t wanted = std::min<std::uint64_t>(kChunkBytes, end_ - at_ - size_);
  if (size_ + wanted > capacity_) {
    const std::size_t capacity = std::max(2 * kChunkBytes, size_ + size_ / 2 + wanted);
    std::unique_ptr<char[]> larger(new char[capacity]);
    if (size_ > 0) std::memcpy(larger.get(), buffer_.get(), size_);
    buffer_ = std::move(larger);
    capacity_ = capacity;
  }
  const std::size_t count = file_->read(at_ + size_, {buffer_.get() + size_, wanted});
  const std::string_view chunk(buffer_.get() + size_, count);
  has_returns_ |= count > 0 && find(chunk, '\r', 0) != std::string_view::npos;
  has_semicolons_ |= count > 0 && find(chunk, ';', 0) != std::string_view::npos;
  size_ += count;
  return count > 0;
}

// A line ends at LF, at CR…CR LF, or at a CR that no LF follows. False when the text ends first.
bool TextWindow::find_end(std::size_t from, LineEnd& end) const {
  if (from >= size_) return false;
  if (has_returns_) return find_end_with_returns(from, end);
  const std::size_t newline = find(view(), '\n', from);
  if (newline == std::string_view::npos) return false;
  end = {newline, newline + 1};
  return true;
}

char TextWindow::before(std::size_t position) const {
  return position > 0 ? buffer_[position - 1] : before_;
}

// An LF CR pair counts as LF: the stray CR is a blank of the next line.
bool TextWindow::find_end_with_returns(std::size_t from, LineEnd& end) const {
  const std::string_view text = view();
  const std::size_t newline = find(text, '\n', from);
  const std::size_t stop = std::min(newline, text.size());
  const std::size_t carriage = find(text.substr(0, stop), '\r', from);
  if (carriage == std::string_view::npos) {
    end = {newline, newline + 1};
    return newline != std::string_view::npos;
  }
  std::size_t behind = carriage;
  while (behind < text.size() && text[behind] == '\r') ++behind;
  const bool last = behind == text.size();
  if (last && at_ + size_ < end_) return false;  // an LF may still come
  if (!last && text[behind] == '\n') {
    end = {carriage, behind + 1};
  } else if (carriage == from && before(from) == '\n') {
    return find_end_with_returns(behind, end);
  } else {
    end = {carriage, carriage + 1};
  }
  return true;
}

// Drops the text of a line that is too long, chunk by chunk, up to its end.
void TextWindow::skip_long_line() {
  for (;;) {
    position_ = size_;
    if (!fill()) return;
    const std::size_t stop = view().find_first_of("\r\n");
    if (stop == std::string_view::npos) continue;
    LineEnd line_end;
    position_ = find_end(stop, line_end) ? line_end.next : size_;
    return;
  }
}

bool TextWindow::next(Line& line) {
  LineEnd line_end;
  bool complete = find_end(position_, line_end);
  while (!complete && size_ - position_ <= kLongestBlock && fill()) {
    complete = find_end(position_, line_end);
  }
  if (!complete) line_end = {size_, size_};
  if (!complete && position_ == size_) return false;
  line.offset = position();
  line.complete = complete;
  line.may_split = has_semicolons_;
  line.text = view().substr(position_, line_end.text - position_);
  line.too_long = line.text.size() > kLongestBlock;
  if (line.too_long) line.text = {};
  if (line.too_long && !complete) {
    skip_long_line();
    line.complete = true;
  } else {
    position_ = line_end.next;
  }
  return true;
}

}  // namespace kerf::base
