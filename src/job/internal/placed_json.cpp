#include "job/internal/placed_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <unordered_set>
#include <utility>

namespace kerf::job {
namespace {

using JsonKind = PlacedJson::Kind;

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

}  // namespace

/// Goes along a text that the library reads, one token behind the other: it does not say where its
/// values stand. Every token has been found right when it is asked for.
class TokenCursor {
 public:
  explicit TokenCursor(std::string_view text) : text_(text) {
    if (text.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
  }

  /// Where the next token begins; commas and colons are none.
  std::size_t begin() {
    at_ = std::min(text_.find_first_not_of(" \t\r\n,:", at_), text_.size());
    return at_;
  }
  void pass(std::size_t length) { at_ += length; }
  void pass_number() {
    at_ = std::min(text_.find_first_not_of("+-.eE0123456789", at_), text_.size());
  }
  void pass_string() {
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      if (text_[at_] == '\\') ++at_;
    }
    ++at_;
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

/// Builds the list from what the library tells of a text.
class JsonListener {
 public:
  using Base = nlohmann::json;

  JsonListener(std::string_view text, PlacedJson& json) : json_(json), cursor_(text) {}

  [[nodiscard]] const std::optional<JsonFault>& fault() const { return fault_; }

  // What nlohmann::json_sax has.
  bool null() {
    return add(JsonKind::null, [&] { cursor_.pass(4); });
  }
  bool boolean(bool truth) {
    const bool done = add(JsonKind::boolean, [&] { cursor_.pass(truth ? 4 : 5); });
    json_.values_.back().truth = truth;
    return done;
  }
  bool number_integer(Base::number_integer_t value) { return number(static_cast<double>(value)); }
  bool number_unsigned(Base::number_unsigned_t value) { return number(static_cast<double>(value)); }
  bool number_float(Base::number_float_t value, const std::string&) { return number(value); }
  bool string(std::string& text) { return add_text(JsonKind::string, text); }
  bool binary(Base::binary_t&) { return false; }  // no JSON text has any
  bool key(std::string& name) {
    const bool is_new = names_.back().insert(name).second;
    if (is_new) return add_text(JsonKind::name, name);
    return refuse(cursor_.begin(), "`" + name + "` IS SAID TWICE");
  }
  bool start_object(std::size_t) { return open(JsonKind::object); }
  bool start_array(std::size_t) { return open(JsonKind::array); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  template <typename Error>
  bool parse_error(std::size_t byte, const std::string&, const Error&) {
    return refuse(byte == 0 ? 0 : byte - 1, "THIS IS NO JSON");
  }

 private:
  template <typename Pass>
  bool add(JsonKind kind, const Pass& pass) {
    const std::size_t byte = cursor_.begin();
    const auto next = static_cast<std::uint32_t>(json_.values_.size() + 1);
    json_.values_.push_back({kind, false, static_cast<std::uint32_t>(byte), next, 0, 0});
    if (next > PlacedJson::kMost) {
      return refuse(byte, "MORE THAN " + std::to_string(PlacedJson::kMost) + " VALUES");
    }
    pass();
    return true;
  }
  bool number(double value) {
    const bool done = add(JsonKind::number, [&] { cursor_.pass_number(); });
    json_.values_.back().number = value;
    return done;
  }
  bool add_text(JsonKind kind, std::string& text) {
    const bool done = add(kind, [&] { cursor_.pass_string(); });
    json_.values_.back().text = static_cast<std::uint32_t>(json_.texts_.size());
    json_.texts_.push_back(std::move(text));
    return done;
  }
  bool open(JsonKind kind) {
    if (open_.size() == PlacedJson::kDeepest) {
      return refuse(cursor_.begin(), "NOTHING LIES SO DEEP");
    }
    open_.push_back(json_.values_.size());
    names_.emplace_back();
    return add(kind, [&] { cursor_.pass(1); });
  }
  bool close() {
    cursor_.begin();
    cursor_.pass(1);
    json_.values_[open_.back()].end = static_cast<std::uint32_t>(json_.values_.size());
    open_.pop_back();
    names_.pop_back();
    return true;
  }
  bool refuse(std::size_t byte, std::string sentence) {
    fault_ = JsonFault{std::move(sentence), json_.place_of(byte)};
    return false;
  }

  PlacedJson& json_;
  TokenCursor cursor_;
  std::vector<std::size_t> open_;                       // objects and arrays that have not ended
  std::vector<std::unordered_set<std::string>> names_;  // of their members
  std::optional<JsonFault> fault_;
};

PlacedJson::PlacedJson(std::string_view text) {
  lines_.push_back(0);
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '\n') lines_.push_back(static_cast<std::uint32_t>(at + 1));
  }
}

TextPlace PlacedJson::place_of(std::size_t byte) const {
  const auto behind = std::upper_bound(lines_.begin(), lines_.end(), byte);
  const std::uint32_t begin = *std::prev(behind);
  return {static_cast<std::uint32_t>(behind - lines_.begin()),
          static_cast<std::uint32_t>(byte - begin + 1)};
}

tl::expected<PlacedJson, JsonFault> PlacedJson::read(const std::string& text) {
  if (text.size() > kLongest) {
    return tl::make_unexpected(
        JsonFault{"IT IS LONGER THAN " + std::to_string(kLongest >> 20) + " MiB", {}});
  }
  PlacedJson json(text);
  JsonListener listener(text, json);
  if (!nlohmann::json::sax_parse(text, &listener)) {
    return tl::make_unexpected(listener.fault().value_or(JsonFault{"THIS IS NO JSON", {}}));
  }
  return json;
}

}  // namespace kerf::job
