#include "features/merge/block_patch.hpp"

#include <algorithm>

namespace kerf::features {
namespace {

constexpr std::string_view kOrder = "XYZIJKRF";

}  // namespace

void BlockPatch::set(const BlockWord& word, double value) {
  const std::string_view old = block_.substr(word.value_begin(), word.end - word.value_begin());
  set_text(word, style_.number_like(old, value));
}

void BlockPatch::set_text(const BlockWord& word, const std::string& value) {
  changes_.push_back({word.value_begin(), word.end - word.value_begin(), value});
}

// Behind the words that come before the letter, else behind what stands at the head of a block.
std::size_t BlockPatch::place_of(char letter) const {
  const std::size_t rank = kOrder.find(letter == 'Q' ? 'F' : letter);
  std::size_t place = 0;
  for (const BlockWord& word : words_) {
    const std::size_t its = kOrder.find(word.letter);
    const bool is_before =
        its == std::string_view::npos ? word.letter == 'N' || word.letter == 'G' : its < rank;
    if (is_before) place = std::max<std::size_t>(place, word.end);
  }
  return place;
}

void BlockPatch::add(char letter, const std::string& value) {
  const bool is_lower = !words_.empty() && block_[words_.front().begin] >= 'a';
  const char shown = is_lower ? static_cast<char>(letter - 'A' + 'a') : letter;
  const std::size_t place = place_of(letter);
  const std::string word = std::string(1, shown) + value;
  changes_.push_back({place, 0, place == 0 ? word + style_.between() : style_.between() + word});
}

void BlockPatch::put_in_front(const std::string& word) {
  const auto first = std::find_if(words_.begin(), words_.end(),
                                  [](const BlockWord& each) { return each.letter != 'N'; });
  const std::size_t place = first == words_.end() ? block_.size() : first->begin;
  // Before what is added at the same place.
  changes_.insert(changes_.begin(), {place, 0, word + style_.between()});
}

std::vector<BlockPatch::Change> BlockPatch::changes() const {
  std::vector<Change> changes = changes_;
  std::stable_sort(changes.begin(), changes.end(),
                   [](const Change& a, const Change& b) { return a.at < b.at; });
  return changes;
}

std::string BlockPatch::text() const {
  std::string text;
  std::size_t at = 0;
  for (const Change& change : changes()) {
    text.append(block_.substr(at, change.at - at)).append(change.text);
    at = change.at + change.length;
  }
  return text.append(block_.substr(at));
}

}  // namespace kerf::features
