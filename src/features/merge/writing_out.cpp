#include "features/merge/writing_out.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "base/decimal.hpp"

namespace kerf::features {
namespace {

using base::Code;

constexpr double kLastLocal = 33;  // #1 to #33 are a macro's own

std::uint64_t start_of(const std::string& text, std::uint32_t line) {
  std::size_t at = 0;
  for (std::uint32_t passed = 1; passed < line && at < text.size(); ++passed) {
    const std::size_t end = text.find('\n', at);
    at = end == std::string::npos ? text.size() : end + 1;
  }
  return at;
}

std::uint32_t lines_in(const std::string& text) {
  return static_cast<std::uint32_t>(std::count(text.begin(), text.end(), '\n')) + 1;
}

/// What a block without motions may say and be left out: modes that written blocks do not need.
bool is_idle(const BlockWord& word) {
  constexpr std::array<double, 9> kModes = {0, 1, 2, 3, 17, 40, 80, 90, 91};
  const auto number = word.number();
  if (word.letter == 'N' || word.letter == 'O') return true;
  if (word.letter == 'M') return number == 99.0;
  if (word.letter != 'G' || !number) return word.letter == 'P' || word.letter == 'F';
  return std::find(kModes.begin(), kModes.end(), *number) != kModes.end();
}

class OutWriter {
 public:
  OutWriter(MergeState& state, const Stretch& stretch) : s_(state), stretch_(stretch) {
    for (std::uint32_t row = stretch.rows.first; row <= stretch.rows.last; ++row) {
      const base::BlockId& block = s_.id(s_.recording.moves[row].block);
      if (is_inside(block)) note(block);
    }
  }

  void begin() {
    if (file_ == base::kNoFile) return;
    const std::string& text = s_.sources.texts.at(file_);
    if (stretch_.called_by) lines_ = program_round(text);
    look_for_functions(text);
    look_for_variables(text);
    if (stretch_.called_by) {
      comment_out(*stretch_.called_by);
    } else {
      take_out(text);
    }
  }

 private:
  [[nodiscard]] bool is_inside(const base::BlockId& block) const {
    if (stretch_.written_out)
      return block.line >= stretch_.written_out->first && block.line <= stretch_.written_out->last;
    return block.calls != base::CallPath::main;
  }

  void note(const base::BlockId& block) {
    if (file_ == base::kNoFile) {
      file_ = block.file;
      lines_ = stretch_.written_out.value_or(Span{block.line, block.line});
    }
    if (block.file != file_) return;
    lines_ = {std::min(lines_.first, block.line), std::max(lines_.last, block.line)};
    moving_.insert(block.line);
    if (s_.sources.sets_up && s_.sources.sets_up(block)) refuse_line(block.line);
  }

  void refuse_line(std::uint32_t line) {
    s_.refuse(Code::edit_not_editable, "LINE " + std::to_string(line) +
                                           " ALSO SETS SOMETHING UP: IT IS WRITTEN OUT BY HAND");
  }

  // From the O word to M99.
  [[nodiscard]] Span program_round(const std::string& text) const {
    Span span = lines_;
    while (span.first > 1 && !has_word(text, span.first, 'O')) --span.first;
    const std::uint32_t most = lines_in(text);
    while (span.last < most && !has_word(text, span.last, 'M')) ++span.last;
    return span;
  }
  [[nodiscard]] std::string_view line_of(const std::string& text, std::uint32_t line) const {
    const std::uint64_t from = start_of(text, line);
    return std::string_view(text).substr(from, text.find('\n', from) - from);
  }
  [[nodiscard]] bool has_word(const std::string& text, std::uint32_t line, char letter) const {
    const std::string_view its = line_of(text, line);
    if (letter == 'O') return !its.empty() && (its[0] == 'O' || its[0] == 'o' || its[0] == ':');
    return find(words_of(s_.sources.language, its), letter) != nullptr;
  }

  void look_for_functions(const std::string& text) {
    for (std::uint32_t line = lines_.first; line <= lines_.last; ++line) {
      const std::string_view its = line_of(text, line);
      if (moving_.count(line) > 0 || its.find_first_of("#[") != std::string_view::npos) continue;
      const std::vector<BlockWord> words = words_of(s_.sources.language, its);
      if (!std::all_of(words.begin(), words.end(), is_idle)) refuse_line(line);
    }
  }

  // #1= in there, and #1 that is no #10 elsewhere; of a loop behind it.
  void look_for_variables(const std::string& text) {
    const std::uint64_t from = start_of(text, lines_.first);
    const std::uint64_t to = start_of(text, lines_.last + 1);
    for (std::size_t at = text.find('#', from); at < to; at = text.find('#', at + 1)) {
      const std::size_t end = text.find_first_not_of("0123456789", at + 1);
      if (end == std::string::npos || text[end] != '=') continue;
      const std::string name = text.substr(at, end - at);
      const bool is_own = stretch_.called_by && is_macro() &&
                          base::read_number(name.substr(1)).value_or(0) <= kLastLocal;
      const bool is_before = stretch_.called_by && is_read(text.substr(0, from), name);
      if (is_own || (!is_before && !is_read(text.substr(to), name))) continue;
      return s_.refuse(Code::edit_unroll_variables,
                       "ANOTHER BLOCK READS " + name + " THAT IS SET IN THERE");
    }
  }
  [[nodiscard]] static bool is_read(const std::string& text, const std::string& name) {
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
      const std::size_t behind = at + name.size();
      if (behind >= text.size() || text[behind] < '0' || text[behind] > '9') return true;
    }
    return false;
  }
  // Whose variables are its own: G65, not M98.
  [[nodiscard]] bool is_macro() const {
    const std::string& text = s_.sources.texts.at(stretch_.called_by->file);
    const std::string_view block =
        std::string_view(text).substr(stretch_.called_by->from, stretch_.called_by->length);
    const std::vector<BlockWord> words = words_of(s_.sources.language, block);
    return std::any_of(words.begin(), words.end(), [](const BlockWord& word) {
      return word.letter == 'G' && word.number() >= 65.0;
    });
  }

  void take_out(const std::string& text) {
    const std::uint64_t from = start_of(text, lines_.first);
    s_.merged.removed += lines_.last - lines_.first + 1;
    s_.merged.replacements[file_].push_back({from, start_of(text, lines_.last + 1) - from, ""});
    s_.in_place = MergeState::InPlace{file_, from};
  }

  void comment_out(const base::BlockId& call) {
    if (s_.sources.is_named && s_.sources.is_named(call)) return refuse_line(call.line);
    const std::string& text = s_.sources.texts.at(call.file);
    std::string comment = text.substr(call.from, call.length);
    std::replace(comment.begin(), comment.end(), '(', '[');
    std::replace(comment.begin(), comment.end(), ')', ']');
    s_.merged.replacements[call.file].push_back({call.from, call.length, "(" + comment + ")"});
    ++s_.merged.patched;
    const std::size_t end = text.find('\n', call.to());
    s_.in_place = MergeState::InPlace{call.file, end == std::string::npos ? text.size() : end + 1};
    s_.is_incremental =
        stretch_.rows.first > 0 &&
        s_.recording.state_of(s_.recording.moves[stretch_.rows.first - 1]).is_incremental;
  }

  MergeState& s_;
  const Stretch& stretch_;
  base::FileId file_ = base::kNoFile;
  Span lines_{};
  std::set<std::uint32_t> moving_{};  // lines with rows
};

}  // namespace

void begin_writing_out(MergeState& state, const Stretch& stretch) {
  OutWriter(state, stretch).begin();
}

}  // namespace kerf::features
