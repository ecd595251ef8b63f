#include "job/edit_undo.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/checksum.hpp"
#include "job/text_changes.hpp"

namespace kerf::job {
namespace {

using nlohmann::json;

/// Whether a report is wrong: then nothing more is read.
class ReportReader {
 public:
  explicit ReportReader(const std::string& text) : report_(json::parse(text, nullptr, false)) {}

  [[nodiscard]] tl::expected<std::vector<TextUndo>, std::string> read() {
    if (!report_.is_object() || member(report_, "kerf") != "edit")
      return tl::unexpected(std::string("is no report of kerf edit"));
    if (member(report_, "version") != 1) return tl::unexpected(std::string("is not of version 1"));
    texts_.push_back({.crc32 = checksum(report_)});
    for (const json& library : list(report_, "libraries", Presence::optional)) {
      texts_.push_back(
          {.file = word(library, "file"), .is_main = false, .crc32 = checksum(library)});
    }
    for (const json& change : list(report_, "changes", Presence::required)) add(change);
    if (!wrong_.empty()) return tl::unexpected("has no usable member \"" + wrong_ + "\"");
    return std::move(texts_);
  }

 private:
  enum class Presence : std::uint8_t { required, optional };

  static const json& member(const json& of, const char* name) {
    static const json kNone;
    const auto found = of.is_object() ? of.find(name) : of.end();
    return found == of.end() ? kNone : *found;
  }

  const json& list(const json& of, const char* name, Presence presence) {
    static const json kEmpty = json::array();
    const json& found = member(of, name);
    if (found.is_array()) return found;
    if (presence == Presence::required || !found.is_null()) note(name);
    return kEmpty;
  }

  std::string word(const json& of, const char* name) {
    const json& found = member(of, name);
    if (found.is_string()) return found.get<std::string>();
    note(name);
    return {};
  }

  std::uint32_t line(const json& of) {
    const json& found = member(of, "first");
    constexpr std::uint64_t kMost = 0xffffffffU;
    if (found.is_number_unsigned() && found.get<std::uint64_t>() <= kMost)
      return found.get<std::uint32_t>();
    note("first");
    return 0;
  }

  std::uint32_t checksum(const json& of) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    const std::string text = word(of, "crc32");
    std::uint32_t value = 0;
    for (const char c : text) {
      const std::size_t digit = kDigits.find(c);
      if (digit == std::string_view::npos || text.size() != 8) note("crc32");
      value = value * 16 + static_cast<std::uint32_t>(digit & 15U);
    }
    if (text.empty()) note("crc32");
    return value;
  }

  std::vector<std::string> lines(const json& of, const char* name) {
    const bool in_bytes = member(of, "encoding") == "latin-1";
    std::vector<std::string> all;
    for (const json& one : list(of, name, Presence::required)) {
      const auto text = one.is_string() ? one.get<std::string>() : std::string();
      const auto bytes = in_bytes ? bytes_of(text) : std::optional(text);
      if (!one.is_string() || !bytes) note(name);
      all.push_back(bytes.value_or(std::string()));
    }
    return all;
  }

  // Characters U+0000 to U+00FF stand for bytes.
  static std::optional<std::string> bytes_of(const std::string& text) {
    std::string bytes;
    for (std::size_t i = 0; i < text.size(); ++i) {
      const auto first = static_cast<unsigned char>(text[i]);
      if (first < 0x80) {
        bytes += text[i];
      } else if (first <= 0xc3 && i + 1 < text.size()) {
        const auto second = static_cast<unsigned char>(text[++i]);
        bytes += static_cast<char>(((first & 3U) << 6U) | (second & 63U));
      } else {
        return std::nullopt;
      }
    }
    return bytes;
  }

  void add(const json& change) {
    TextChange one{.file = word(change, "file"),
                   .first = line(change),
                   .old_lines = lines(change, "old"),
                   .new_lines = lines(change, "new")};
    const auto library = std::find_if(texts_.begin() + 1, texts_.end(),
                                      [&](const TextUndo& text) { return text.file == one.file; });
    TextUndo& text = library == texts_.end() ? texts_.front() : *library;
    text.file = one.file;
    text.changes.push_back(std::move(one));
  }

  void note(const char* name) {
    if (wrong_.empty()) wrong_ = name;
  }

  json report_;
  std::string wrong_;  // the first member that cannot be used
  std::vector<TextUndo> texts_;
};

}  // namespace

tl::expected<std::vector<TextUndo>, std::string> read_edit_report(const std::string& text) {
  return ReportReader(text).read();
}

tl::expected<std::vector<base::TextStretch>, ChangedSince> undo_of(const TextUndo& undo,
                                                                   const std::string& text) {
  auto stretches = stretches_of(text, taken_back(undo.changes));
  if (!stretches) return tl::unexpected(ChangedSince{stretches.error()});
  if (base::crc32(text) != undo.crc32) return tl::unexpected(ChangedSince{});
  return std::move(*stretches);
}

}  // namespace kerf::job
