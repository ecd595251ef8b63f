#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/token.hpp"

namespace kerf::base {

/// In capital letters.
[[nodiscard]] std::string capitals(std::string text);

/// The first word of a line in capitals, and the character behind it.
struct FirstWord {
  std::string word;
  char next = 0;  ///< 0: the line ends there

  [[nodiscard]] static FirstWord of(std::string_view line);
};

/// Marks of a comment. Without `end` it goes to the end of its line; no comment is longer than
/// that.
struct CommentMarks {
  std::string_view begin;
  std::string_view end{};
};

/// All that is to be known of a language besides what its programs mean. The folder of its front
/// end has the one instance of it; machine/dialect/registry knows the folders.
struct Language {
  std::string_view name;
  /// Of files, as written, the usual one first: ".bas".
  std::span<const std::string_view> endings;
  /// Whether the first one, in letters of any case, says that a file is in this language. G-code
  /// has the endings that everybody uses.
  bool shows_by_ending = true;
  /// Whether a line of this first word is in this language and in no other. Null: none is.
  bool (*shows_by_word)(const FirstWord& first) = nullptr;
  CommentMarks comment;
  /// Words with a meaning of their own, in capitals.
  std::span<const std::string_view> key_words;
  /// What a line looks like.
  std::string_view example;
  /// What a new program begins with.
  std::string_view fresh = "\n";
  /// Whether files are bytes, and the language is their listing.
  bool is_listing = false;
  /// Appends the tokens of a line without its end to `tokens`: each byte is in exactly one. No
  /// token depends on another line. The mark of a file's first line (without_byte_order_mark) is no
  /// part of it.
  void (*cut)(std::string_view line, std::vector<Token>& tokens) = nullptr;
};

/// The tokens of a line.
[[nodiscard]] std::vector<Token> tokens_of(const Language& language, std::string_view line);
/// Whether a file is in this language by the ending of its name.
[[nodiscard]] bool shows_by_ending(const Language& language, const std::string& path);

}  // namespace kerf::base
