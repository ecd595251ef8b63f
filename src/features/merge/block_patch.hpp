#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "features/merge/block_words.hpp"
#include "features/merge/text_style.hpp"

namespace kerf::features {

/// Changes words of one block and keeps all its other bytes (features-contract §8.2).
class BlockPatch {
 public:
  BlockPatch(std::string_view block, std::vector<BlockWord> words, const TextStyle& style)
      : block_(block), words_(std::move(words)), style_(style) {}

  [[nodiscard]] const std::vector<BlockWord>& words() const { return words_; }
  [[nodiscard]] const BlockWord* word(char letter) const { return find(words_, letter); }
  /// The word has this value.
  void set(const BlockWord& word, double value);
  /// The word with another text of its value.
  void set_text(const BlockWord& word, const std::string& value);
  /// The word comes in behind the last one that stands before it in X Y Z I J K R F.
  void add(char letter, const std::string& value);
  /// In front of all words but N.
  void put_in_front(const std::string& word);

  [[nodiscard]] bool is_changed() const { return !changes_.empty(); }
  /// Bytes of the block that others take the place of, in their order.
  struct Change {
    std::size_t at = 0;
    std::size_t length = 0;
    std::string text{};
  };
  [[nodiscard]] std::vector<Change> changes() const;
  /// The block with all changes.
  [[nodiscard]] std::string text() const;

 private:
  [[nodiscard]] std::size_t place_of(char letter) const;

  std::string_view block_;
  std::vector<BlockWord> words_;
  const TextStyle& style_;
  std::vector<Change> changes_{};
};

}  // namespace kerf::features
