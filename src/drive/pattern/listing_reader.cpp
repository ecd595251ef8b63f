#include "drive/pattern/listing_reader.hpp"

#include <algorithm>

namespace kerf::drive {
namespace {

constexpr std::size_t kBlock = 1 << 16;
static_assert(ListingReader::kLongestLine < kBlock);

}  // namespace

// Keeps what was not read yet and adds a block. False: there is nothing more in the file.
bool ListingReader::fill() {
  buffer_.erase(0, at_);
  begin_ += at_;
  at_ = 0;
  const std::size_t kept = buffer_.size();
  buffer_.resize(kept + kBlock);
  buffer_.resize(kept + file_.read(begin_ + kept, std::span(buffer_).subspan(kept)));
  return buffer_.size() > kept;
}

bool ListingReader::next_line() {
  std::size_t end = buffer_.find('\n', at_);
  while (end == std::string::npos && buffer_.size() - at_ <= kLongestLine && fill())
    end = buffer_.find('\n', at_);
  if (at_ == buffer_.size()) return false;
  line_ = std::string_view(buffer_).substr(at_, end == std::string::npos ? end : end - at_);
  too_long_ = line_.size() > kLongestLine;
  place_ = {.file = id_, .line = place_.line + 1, .column = 1, .line_start = begin_ + at_};
  at_ = end == std::string::npos ? buffer_.size() : end + 1;
  return true;
}

base::Result<std::optional<ListedMove>> ListingReader::next() {
  while (next_line()) {
    if (too_long_) {
      return base::unexpected(
          base::make_error(base::Code::pattern_text, place_,
                           "the line has more than " + std::to_string(kLongestLine) + " bytes"));
    }
    auto move = parse_listing(line_, place_, links_);
    if (!move) return base::unexpected(std::move(move.error()));
    if (!std::holds_alternative<std::monostate>(*move)) return *move;
  }
  return std::nullopt;
}

}  // namespace kerf::drive
