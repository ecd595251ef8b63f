#include "drawing/font/internal/hershey.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "base/decimal.hpp"

namespace kerf::drawing {
namespace {

constexpr char32_t kFirstLetter = 32;
constexpr std::size_t kNumberColumns = 5;
constexpr std::size_t kCountColumns = 3;

/// A record as it is written, in Hershey's units, y up from its own middle.
struct HersheyGlyph {
  double left = 0;
  double right = 0;
  std::vector<std::vector<Vec2>> strokes;
};

double off_middle(char letter) { return static_cast<double>(letter) - 'R'; }

/// All bytes but ends of lines; `at` goes on by `count` of them.
class HersheyText {
 public:
  explicit HersheyText(std::string_view bytes) : bytes_(bytes) {}

  std::optional<std::string> take(std::size_t count) {
    std::string taken;
    while (taken.size() < count && at_ < bytes_.size()) {
      const char c = bytes_[at_++];
      if (c == '\n') ++line_;
      if (c != '\n' && c != '\r') taken += c;
    }
    return taken.size() == count ? std::optional(taken) : std::nullopt;
  }
  /// Goes to the next record; false: there is none.
  [[nodiscard]] bool has_more() {
    for (; at_ < bytes_.size() && (bytes_[at_] == '\n' || bytes_[at_] == '\r'); ++at_)
      if (bytes_[at_] == '\n') ++line_;
    return bytes_.find_first_not_of(" \r\n\t\x1a", at_) != std::string_view::npos;
  }
  [[nodiscard]] std::size_t line() const { return line_; }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

std::optional<std::size_t> count_of(const std::string& columns) {
  const std::size_t first = columns.find_first_not_of(' ');
  if (first == std::string::npos) return std::nullopt;
  const auto count = base::read_whole_number(columns.substr(first));
  if (!count || *count == 0) return std::nullopt;
  return static_cast<std::size_t>(*count);
}

void add_point(HersheyGlyph& glyph, const std::string& pairs, std::size_t at) {
  if (pairs[at] == ' ' && pairs[at + 1] == 'R') {
    glyph.strokes.emplace_back();
    return;
  }
  if (glyph.strokes.empty()) glyph.strokes.emplace_back();
  glyph.strokes.back().push_back({off_middle(pairs[at]), -off_middle(pairs[at + 1])});
}

std::optional<HersheyGlyph> glyph_of(HersheyText& text) {
  if (!text.take(kNumberColumns)) return std::nullopt;
  const auto columns = text.take(kCountColumns);
  const auto count = columns ? count_of(*columns) : std::nullopt;
  const auto pairs = count ? text.take(2 * *count) : std::nullopt;
  if (!pairs) return std::nullopt;
  HersheyGlyph glyph{off_middle((*pairs)[0]), off_middle((*pairs)[1]), {}};
  for (std::size_t i = 2; i < pairs->size(); i += 2) add_point(glyph, *pairs, i);
  return glyph;
}

/// The lowest and the highest point.
std::pair<double, double> reach(const HersheyGlyph& glyph) {
  std::pair<double, double> found{1e9, -1e9};
  for (const auto& stroke : glyph.strokes)
    for (const Vec2 point : stroke)
      found = {std::min(found.first, point.v), std::max(found.second, point.v)};
  return found;
}

class HersheyFont : public Font {
 public:
  explicit HersheyFont(const std::vector<HersheyGlyph>& records) {
    double base = -9;
    double height = 21;
    if (records.size() > 'H' - kFirstLetter) {
      const auto [low, high] = reach(records['H' - kFirstLetter]);
      if (high > low) std::tie(base, height) = std::pair(low, high - low);
    }
    for (const HersheyGlyph& record : records) take(record, base, 1 / height);
  }

  const Glyph* find(char32_t code) override {
    if (code < kFirstLetter || code - kFirstLetter >= glyphs_.size()) return nullptr;
    return &glyphs_[code - kFirstLetter];
  }
  [[nodiscard]] double depth() const override { return depth_; }

 private:
  void take(const HersheyGlyph& record, double base, double scale) {
    Glyph glyph;
    glyph.advance = scale * (record.right - record.left);
    for (const auto& stroke : record.strokes)
      for (std::size_t i = 0; i < stroke.size(); ++i)
        glyph.strokes.push_back(
            {i == 0 ? Stroke::Kind::begin : Stroke::Kind::line,
             {scale * (stroke[i].u - record.left), scale * (stroke[i].v - base)}});
    for (const Stroke& stroke : glyph.strokes) depth_ = std::max(depth_, -stroke.to.v);
    glyphs_.push_back(std::move(glyph));
  }

  std::vector<Glyph> glyphs_;
  double depth_ = 0;
};

}  // namespace

base::Outcome<std::unique_ptr<Font>> read_hershey(std::string_view bytes, const std::string& name) {
  HersheyText text(bytes);
  std::vector<HersheyGlyph> records;
  while (text.has_more()) {
    const std::size_t line = text.line();
    auto record = glyph_of(text);
    if (!record)
      return tl::unexpected(base::Failure{
          base::Failure::Kind::input,
          fmt::format("{}:{}: no letter of a Hershey font: five columns of a number, three of a "
                      "count, and as many pairs of letters",
                      name, line)});
    records.push_back(std::move(*record));
  }
  if (records.empty())
    return tl::unexpected(
        base::Failure{base::Failure::Kind::input, fmt::format("{}: it has no letters", name)});
  return std::make_unique<HersheyFont>(records);
}

}  // namespace kerf::drawing
