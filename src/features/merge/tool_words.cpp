#include "features/merge/tool_words.hpp"

#include <algorithm>
#include <string_view>

#include "features/merge/block_words.hpp"

namespace kerf::features {
namespace {

/// A line of a text: where it begins, and what stands in it.
struct TextLine {
  std::uint64_t from = 0;
  std::string_view text{};
};

TextLine line_at(std::string_view text, std::uint64_t from) {
  const std::size_t end = text.find('\n', from);
  return {from, text.substr(from, end == std::string_view::npos ? end : end - from)};
}

std::uint64_t start_of_line(std::string_view text, std::uint64_t at) {
  const std::size_t end = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  return end == std::string_view::npos ? 0 : end + 1;
}

class ToolWordChanger {
 public:
  ToolWordChanger(const Recording& recording, const ToolWords& wish, const MergeSources& sources,
                  Merged& merged)
      : recording_(recording),
        wish_(wish),
        sources_(sources),
        first_(recording.block_of(recording.moves[wish.rows.first])),
        text_(sources.texts.at(first_.file)),
        list_(merged.replacements[first_.file]),
        merged_(merged) {}

  [[nodiscard]] tl::expected<void, CannotMerge> change() {
    const std::uint64_t begin = begin_of_opening();
    bool has_tool = false;
    for (std::uint64_t at = begin; at <= end_of_rows() && at < text_.size();) {
      const TextLine line = line_at(text_, at);
      const bool is_opening = at <= first_.from;
      has_tool = change_line(line, is_opening ? "THD" : "HD") || has_tool;
      at += line.text.size() + 1;
    }
    for (std::uint64_t at = begin; !has_tool && at > 0;) {
      at = start_of_line(text_, at - 1);
      has_tool = change_line(line_at(text_, at), "T");
    }
    sort();
    if (has_tool) return {};
    return tl::unexpected(CannotMerge{base::Code::edit_not_editable,
                                      "NO BLOCK BEFORE LINE " + std::to_string(first_.line) +
                                          " CALLS T" + std::to_string(wish_.was)});
  }

 private:
  // Behind the last row of what was cut before.
  [[nodiscard]] std::uint64_t begin_of_opening() const {
    if (wish_.rows.first == 0) return 0;
    const base::BlockId& before = recording_.block_of(recording_.moves[wish_.rows.first - 1]);
    if (before.file != first_.file || before.from >= first_.from) return start_of_line(text_, 0);
    const std::size_t end = text_.find('\n', before.to());
    return end == std::string_view::npos ? text_.size() : end + 1;
  }
  [[nodiscard]] std::uint64_t end_of_rows() const {
    std::uint64_t end = first_.from;
    for (std::uint32_t row = wish_.rows.first; row <= wish_.rows.last; ++row) {
      const base::BlockId& block = recording_.block_of(recording_.moves[row]);
      if (block.file == first_.file) end = std::max<std::uint64_t>(end, block.from);
    }
    return end;
  }

  // Whether the line has the old number behind T.
  bool change_line(const TextLine& line, std::string_view letters) {
    bool has_tool = false;
    for (const BlockWord& word : words_of(sources_.language, line.text)) {
      if (letters.find(word.letter) == std::string_view::npos || word.number() != wish_.was)
        continue;
      std::string number = std::to_string(wish_.is);
      const std::size_t digits = word.end - word.value_begin();
      if (number.size() < digits && word.value.front() == '0')
        number.insert(0, digits - number.size(), '0');
      list_.push_back({line.from + word.value_begin(), digits, number});
      has_tool = has_tool || word.letter == 'T';
      ++merged_.patched;
    }
    return has_tool;
  }

  void sort() {
    std::stable_sort(list_.begin(), list_.end(), [](const Replacement& a, const Replacement& b) {
      return std::pair(a.from, a.length > 0) < std::pair(b.from, b.length > 0);
    });
  }

  const Recording& recording_;
  const ToolWords& wish_;
  const MergeSources& sources_;
  const base::BlockId& first_;
  std::string_view text_;
  std::vector<Replacement>& list_;
  Merged& merged_;
};

}  // namespace

tl::expected<void, CannotMerge> change_tool_words(const Recording& recording, const ToolWords& wish,
                                                  const MergeSources& sources, Merged& merged) {
  return ToolWordChanger(recording, wish, sources, merged).change();
}

}  // namespace kerf::features
