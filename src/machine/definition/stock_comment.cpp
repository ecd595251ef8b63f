#include "machine/definition/stock_comment.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "base/decimal.hpp"
#include "machine/definition/tools/program_lines.hpp"
#include "machine/definition/tools/tool_words.hpp"
#include "motion/feed.hpp"

namespace kerf::machine {
namespace {

constexpr std::string_view kBegin = "WORKPIECE";

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// A WORKPIECE comment as its kind and its values.
class StockWords {
 public:
  /// `text`: capitals, behind kBegin.
  StockWords(std::string_view text, double mm_per_unit) : mm_per_unit_(mm_per_unit) {
    while (!text.empty()) {
      text.remove_prefix(1);  // the comma
      const std::size_t comma = std::min(text.find(','), text.size());
      take(trimmed(text.substr(0, comma)));
      text.remove_prefix(comma);
    }
  }

  /// As `--stock` takes it; what is missing has made wrong() say so.
  std::string said() {
    if (kind_ == "BOX") return box();
    if (kind_ == "CYLINDER" || kind_ == "TUBE") return round();
    wrong_ = "there is no WORKPIECE of this kind: BOX, CYLINDER or TUBE is expected";
    return {};
  }
  [[nodiscard]] const std::string& wrong() const { return wrong_; }

 private:
  void take(std::string_view item) {
    const std::size_t sign = item.find('=');
    if (sign == std::string_view::npos) {
      if (kind_.empty()) kind_ = item;
      return;
    }
    values_.emplace(trimmed(item.substr(0, sign)), trimmed(item.substr(sign + 1)));
  }

  std::string number(const std::string& key) {
    const auto found = values_.find(key);
    const auto value =
        found == values_.end() ? base::read_number("") : base::read_number(found->second);
    if (value) return base::number_text(base::tidy(*value * mm_per_unit_));
    if (wrong_.empty()) wrong_ = "WORKPIECE needs a number for " + key;
    return {};
  }
  /// Of the middle: 0 where it is not said.
  std::string middle(const std::string& key) { return values_.contains(key) ? number(key) : "0"; }

  std::string box() {
    std::string text = "box:";
    for (const char* const key : {"XMIN", "YMIN", "ZMIN", "XMAX", "YMAX", "ZMAX"})
      text += (text.back() == ':' ? "" : ",") + number(key);
    return text;
  }

  std::string round() {
    const auto named = values_.find("AXIS");
    const std::string axis = named == values_.end() ? "Z" : named->second;
    if (axis != "X" && axis != "Y" && axis != "Z") {
      wrong_ = "AXIS of WORKPIECE is X, Y or Z";
      return {};
    }
    const bool is_tube = kind_ == "TUBE";
    std::string text = (is_tube ? "tube:" : "cylinder:") + axis;
    for (const char* const other : {"X", "Y", "Z"}) {
      if (axis != other) text += "," + middle(other);
    }
    text += "," + number(axis + "MIN") + "," + number(axis + "MAX") + "," + number("DIAMETER");
    return is_tube ? text + "," + number("INNER_DIAMETER") : text;
  }

  double mm_per_unit_;
  std::string kind_;
  std::map<std::string, std::string> values_;
  std::string wrong_;
};

CommentedStock stock_of(const std::string& comment, std::uint32_t line, double mm_per_unit) {
  StockWords words(std::string_view(comment).substr(kBegin.size()), mm_per_unit);
  CommentedStock stock{.line = line, .said = words.said()};
  stock.wrong = words.wrong();
  if (!stock.wrong.empty()) return stock;
  auto word = stock_word(stock.said, "WORKPIECE");
  if (word) {
    stock.word = std::move(*word);
  } else {
    stock.wrong = word.error().message;
  }
  return stock;
}

bool begins_stock(const std::string& comment) {
  return comment.starts_with(kBegin) && comment.size() > kBegin.size() &&
         comment[kBegin.size()] == ',';
}

}  // namespace

std::optional<CommentedStock> stock_in_comments(const base::SourceFile& program,
                                                double mm_per_unit) {
  std::uint32_t line = 0;
  std::uint32_t at = 0;
  std::string found;
  std::optional<bool> inches;
  each_line(program, [&](std::string_view text) {
    ++line;
    const ProgramLine words(text, false);
    if (!inches) inches = words.inches();
    if (at > 0) return;
    for (const std::string_view comment : words.comments()) {
      const std::string folded = capitals(trimmed(comment));
      if (at > 0 || !begins_stock(folded)) continue;
      found = folded;
      at = line;
    }
  });
  if (at == 0) return std::nullopt;
  if (inches) mm_per_unit = *inches ? motion::kMillimetresPerInch : 1;
  return stock_of(found, at, mm_per_unit);
}

}  // namespace kerf::machine
